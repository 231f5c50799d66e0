// Where the eye is: the page's own camera, its history, saved views, and the keys that walk. The program is told of each
// change once per animation frame.

import { computed, effect, signal, untracked } from '@preact/signals';
import {
    frame, fly, look, moved, orbit, pan, pinhole, preset, same, walk, type Preset,
} from './camera';
import { shown } from './frames';
import { walking } from './prefs';
import { editor, groups, lamps, meters, scene, things } from './store';
import { selection } from './select';
import type { Camera, Vec } from './types';
import { add, corners, dot, middle, scale, sub } from './vec';
import { ask, hear, line, role, send } from './wire';

/** Above the floor, of who walks [m]. */
export const EYE_HEIGHT = 1.6;

/** Where the hand wants the eye to be; the frame shown may still lag behind. */
export const camera = signal<Camera | null>(null);
/** True for the one whose eye the program follows; all others see what that one sees. */
const drives = computed(() => role.value === 'edit' && editor.value.you);
export const up = computed<Vec>(() => scene.value?.up ?? [0, 0, 1]);
/** Size of the view [CSS pixels]. */
export const viewSize = signal<[number, number]>([640, 480]);
/** The name of the view that one is in, as long as one has not left it. */
export const viewName = signal<string | null>(null);

let home: Camera | null = null;
let told: Camera | null = null;
let due = false;

const past: Camera[] = [];
const future: Camera[] = [];
let settledAt = 0;

/** Moves the eye. Motions that follow each other within a second are one entry of the view history. */
export function go(next: Camera, name: string | null = null): void {
    const now = camera.peek();
    if (now && same(now, next)) return;
    const time = performance.now();
    if (now && (time - settledAt > 1000 || name)) {
        past.push(now);
        if (past.length > 100) past.shift();
        future.length = 0;
    }
    settledAt = time;
    camera.value = next;
    viewName.value = name;
}

export const here = (): Camera | null => camera.peek();

export function back(): void {
    swap(past, future);
}
export function forth(): void {
    swap(future, past);
}
function swap(from: Camera[], to: Camera[]): void {
    const target = from.pop();
    if (!target) return;
    const now = camera.peek();
    if (now) to.push(now);
    settledAt = performance.now();
    camera.value = target;
    viewName.value = null;
}

/** Tells the program, at most once per animation frame and never what it knows. */
effect(() => {
    const now = camera.value;
    if (!now || line.value !== 'open' || !drives.value || due) return;
    due = true;
    requestAnimationFrame(() => {
        due = false;
        const next = camera.peek();
        if (!next || (told && same(told, next))) return;
        const { eye, target, up: above, fov, height, near } = next;
        const message = { do: 'camera', eye, target, up: above, fov } as { do: string } & Record<string, unknown>;
        if (height) message.height = height;
        if (near) message.near = near;
        if (send(message)) told = next;
    });
});

// The first camera is the program's; a watcher always has the editor's.
effect(() => {
    const picture = shown.value;
    if (!picture) return;
    untracked(() => {
        if (camera.peek() && drives.peek()) return;
        told = picture.camera;
        camera.value = picture.camera;
        home ??= picture.camera;
    });
});
hear('hello', () => (told = null));

/** The point and the pixel of the frame shown for a point of the view [CSS pixels]. */
export function toFrame(x: number, y: number): { frame: number; x: number; y: number } | null {
    const picture = shown.peek();
    if (!picture) return null;
    const { head } = picture;
    const fit = fitted(head.width, head.height);
    return { frame: head.frame, x: (x - fit.x) / fit.scale, y: (y - fit.y) / fit.scale };
}

/** Where a frame of this size lies in the view: whole, centred. */
export function fitted(width: number, height: number): { x: number; y: number; scale: number } {
    const [w, h] = viewSize.peek();
    const by = Math.min(w / width, h / height);
    return { x: (w - width * by) / 2, y: (h - height * by) / 2, scale: by };
}

/** The wanted camera for the view's own pixels. */
export function viewPinhole(c: Camera | null = camera.peek()): ReturnType<typeof pinhole> | null {
    const [w, h] = viewSize.peek();
    return c ? pinhole(c, w, h) : null;
}

export const bounds = (): [Vec, Vec] => scene.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]];
export const centre = (): Vec => middle(bounds());

export function turnHead(yaw: number, pitch: number): void {
    const c = here();
    if (c) go(look(c, up.peek(), yaw, pitch));
}
export function circle(pivot: Vec, yaw: number, pitch: number): void {
    const c = here();
    if (c) go(orbit(c, up.peek(), pivot, yaw, pitch));
}
export function slide(dx: number, dy: number, depth: number): void {
    const c = here();
    const view = viewPinhole();
    if (c && view) go(pan(c, view, dx, dy, depth));
}

/** Walks by metres; in walk mode the eye keeps its height above the floor that it finds under itself. */
export function stride(ahead: number, sideways: number, upward: number): void {
    const c = here();
    if (!c) return;
    if (c.height) {
        const view = viewPinhole(c);
        if (view) go(moved(c, add(scale(view.side, sideways), scale(view.up, ahead))));
        return;
    }
    if (walking.peek() === 'fly' || upward !== 0) go(fly(c, up.peek(), ahead, sideways, upward));
    else {
        go(walk(c, up.peek(), ahead, sideways, 0));
        keepHeight();
    }
}

let asking = false;
let floors = true;
let floor: number | null = null;

function keepHeight(): void {
    const c = here();
    if (!c || asking || !floors) return;
    const above = up.peek();
    asking = true;
    const stop = ask('ray', { origin: c.eye, direction: scale(above, -1) }, (answer) => {
        asking = false;
        floors = true;
        const now = here();
        if (!answer.hit || !now || now.height) return;
        floor = dot(answer.point as Vec, above);
        // Half of the way each time: stairs are climbed, not jumped.
        const off = floor + EYE_HEIGHT - dot(now.eye, above);
        if (Math.abs(off) > 0.01) go(moved(now, scale(above, off * 0.5)));
    }, () => {
        // A program that cannot be asked for floors has one, the lowest of the scene.
        asking = false;
        floors = false;
    });
    setTimeout(() => {
        if (asking) stop();
        asking = false;
    }, 500);
}

/** The box of what is selected, or null. */
function selectedBox(): [Vec, Vec] | null {
    const now = selection.peek();
    if (!now) return null;
    const boxes: [Vec, Vec][] = [];
    const take = (box: [Vec, Vec] | null | undefined, point?: Vec | null) => {
        if (box) boxes.push(box);
        else if (point) boxes.push([point, point]);
    };
    for (const id of now.ids) {
        if (now.kind === 'lamp') take(lamps.get(id)?.box, lamps.get(id)?.place?.position);
        if (now.kind === 'thing') take(things.get(id)?.box);
        if (now.kind === 'meter') take(null, meters.get(id)?.point);
        if (now.kind === 'group') {
            for (const lamp of groups.get(id)?.lamps ?? []) take(lamps.get(lamp)?.box, lamps.get(lamp)?.place?.position);
        }
    }
    if (!boxes.length) return null;
    const points = boxes.flatMap(corners);
    const pick = (of: (...v: number[]) => number): Vec =>
        [0, 1, 2].map((axis) => of(...points.map((p) => p[axis]))) as Vec;
    return [pick(Math.min), pick(Math.max)];
}

export function frameSelection(): void {
    const c = here();
    const box = selectedBox();
    if (c && box) go(frame(c, box), 'selection');
    else goHome();
}

export function goHome(): void {
    if (home) go(home, 'home');
}

export function goPreset(which: Preset): void {
    const [w, h] = viewSize.peek();
    go(preset(which, bounds(), up.peek(), w / h), which);
}

/** From inside again, where one was before the plan. */
export function goInside(): void {
    for (let k = past.length - 1; k >= 0; k--) {
        if (!past[k].height) return go(past[k], 'inside');
    }
    goHome();
}

/** Where the near cut lies between eye and the far side of the scene, 0 to 1, and how to set it. */
export const cut = computed<{ value: number; most: number; height: number | null } | null>(() => {
    const c = camera.value;
    if (!c?.height) return null;
    const view = pinhole(c, 2, 2);
    const ends = corners(bounds()).map((p) => dot(sub(p, c.eye), view.forward));
    const value = c.near ?? 0;
    // On plans the cut is told as a height above the floor.
    const rise = dot(view.forward, up.value);
    const low = Math.min(...corners(bounds()).map((p) => dot(p, up.value)));
    const height = Math.abs(rise) > 0.99 ? dot(c.eye, up.value) + rise * value - low : null;
    return { value, most: Math.max(...ends), height };
});
export function setCut(near: number): void {
    const c = here();
    if (c) camera.value = { ...c, near: Math.max(0, near) };
}
