// The hand in the view: mouse, pen, fingers and wheel become motions of the eye; a press that hardly moves is a click.

import { dolly, zoom } from './camera';
import { hands, lookOnly } from './prefs';
import {
    centre, circle, fitted, go, here, slide, toFrame, turnHead, viewPinhole, viewSize,
} from './navigate';
import { tool } from './select';
import type { Hit, Vec } from './types';
import { distance, dot, sub } from './vec';
import { ask } from './wire';

/** A press that stays within so many pixels is a click. */
const STILL = 4;
/** Radians per pixel of a look. */
const LOOK = 0.0035;
const NEAREST = 0.15;

export type Motion = 'look' | 'orbit' | 'pan' | 'dolly' | 'none';

/** What a drag does, by the habits that the user has chosen. */
export function motionOf(habit: string, button: number, e: { alt: boolean; shift: boolean; ctrl: boolean; space: boolean }): Motion {
    if (habit === 'maya' && e.alt) return (['orbit', 'pan', 'dolly'] as const)[button] ?? 'none';
    if (habit === 'blender' && button === 1) return e.shift ? 'pan' : e.ctrl ? 'dolly' : 'orbit';
    if (button === 1) return e.shift ? 'pan' : 'orbit';
    if (button === 2) return 'look';
    if (button === 0) return e.alt ? 'orbit' : e.space ? 'pan' : e.shift || e.ctrl ? 'none' : 'look';
    return 'none';
}

/** What clicks of the view lead to. */
export interface Clicks {
    click(x: number, y: number, how: 'only' | 'add' | 'toggle'): void;
    menu(x: number, y: number): void;
    double(x: number, y: number): void;
    hover(x: number, y: number): void;
    unhover(): void;
    marquee(from: [number, number], to: [number, number], done: boolean): void;
}

interface Press {
    id: number;
    button: number;
    x: number;
    y: number;
    startX: number;
    startY: number;
    moved: boolean;
    motion: Motion;
    touch: boolean;
    shift: boolean;
    ctrl: boolean;
}

/** Listens on an element; returns how to stop. */
export function followPointer(element: HTMLElement, clicks: Clicks): () => void {
    const presses = new Map<number, Press>();
    let pivot: Vec = centre();
    let depth = 3;
    let space = false;
    let hoverTimer = 0;
    let longPress = 0;
    let lastTap = 0;
    let pinch: { gap: number; x: number; y: number } | null = null;

    const local = (e: { clientX: number; clientY: number }): [number, number] => {
        const box = element.getBoundingClientRect();
        return [e.clientX - box.left, e.clientY - box.top];
    };
    const asked = (x: number, y: number, then?: (hit: Hit) => void) => {
        const at = toFrame(x, y);
        if (!at) return;
        ask('point', at, (answer) => {
            const hit = answer as unknown as Hit;
            if (hit.hit) then?.(hit);
        });
    };
    const depthOf = (point: Vec): number => {
        const view = viewPinhole();
        return view ? Math.max(0.2, dot(sub(point, view.eye), view.forward)) : depth;
    };

    function down(e: PointerEvent): void {
        if ((e.target as Element).closest('[data-handle]')) return;
        element.focus({ preventScroll: true });
        const [x, y] = local(e);
        const touch = e.pointerType === 'touch';
        const mods = { alt: e.altKey, shift: e.shiftKey, ctrl: e.ctrlKey || e.metaKey, space };
        let motion = touch ? 'look' : motionOf(hands.peek(), e.button, mods);
        if (motion === 'look' && here()?.height) motion = 'pan';
        if (tool.peek() === 'marquee' && e.button === 0) motion = 'none';
        presses.set(e.pointerId, {
            id: e.pointerId, button: e.button, x, y, startX: x, startY: y, moved: false, motion, touch,
            shift: e.shiftKey, ctrl: mods.ctrl,
        });
        element.setPointerCapture(e.pointerId);
        clearTimeout(hoverTimer);
        clicks.unhover();
        if (motion === 'orbit' || motion === 'pan' || motion === 'dolly') {
            pivot = centre();
            depth = depthOf(pivot);
            asked(x, y, (hit) => {
                pivot = hit.point;
                depth = depthOf(hit.point);
            });
        }
        clearTimeout(longPress);
        if (touch && presses.size === 1) {
            longPress = window.setTimeout(() => {
                const press = presses.get(e.pointerId);
                if (press && !press.moved && presses.size === 1) {
                    press.moved = true;
                    press.motion = 'none';
                    clicks.menu(press.x, press.y);
                }
            }, 550);
        }
        if (presses.size === 2) pinch = spread();
        if (e.button === 1) e.preventDefault();
    }

    function spread(): { gap: number; x: number; y: number } {
        const [a, b] = [...presses.values()];
        return { gap: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    }

    function move(e: PointerEvent): void {
        const press = presses.get(e.pointerId);
        const [x, y] = local(e);
        if (!press) {
            if (e.pointerType === 'touch' || e.buttons) return;
            clicks.unhover();
            clearTimeout(hoverTimer);
            hoverTimer = window.setTimeout(() => clicks.hover(x, y), 150);
            return;
        }
        const [dx, dy] = [x - press.x, y - press.y];
        if (!press.moved && Math.hypot(x - press.startX, y - press.startY) < STILL) return;
        press.moved = true;
        press.x = x;
        press.y = y;
        if (presses.size === 2 && pinch) {
            const now = spread();
            slide(now.x - pinch.x, now.y - pinch.y, depth);
            if (now.gap > 8 && pinch.gap > 8) toward(now.x, now.y, pinch.gap / now.gap, false);
            pinch = now;
            return;
        }
        if (tool.peek() === 'marquee' && press.button === 0) {
            clicks.marquee([press.startX, press.startY], [x, y], false);
            return;
        }
        switch (press.motion) {
            case 'look': {
                // A finger pulls the room along, a mouse turns the head.
                const sign = press.touch ? 1 : -1;
                turnHead(sign * dx * LOOK, sign * dy * LOOK);
                break;
            }
            case 'orbit':
                circle(pivot, -dx * 0.006, -dy * 0.006);
                break;
            case 'pan':
                slide(dx, dy, depth);
                break;
            case 'dolly':
                toward(press.startX, press.startY, Math.exp(dy * 0.006), false);
                break;
            case 'none':
                break;
        }
    }

    function release(e: PointerEvent): void {
        const press = presses.get(e.pointerId);
        presses.delete(e.pointerId);
        clearTimeout(longPress);
        if (presses.size < 2) pinch = null;
        if (!press || e.type === 'pointercancel') return;
        if (press.moved) {
            if (tool.peek() === 'marquee') clicks.marquee([press.startX, press.startY], [press.x, press.y], true);
            return;
        }
        if (press.touch) {
            const time = performance.now();
            const twice = time - lastTap < 320;
            lastTap = time;
            if (twice) return clicks.double(press.x, press.y);
            if (lookOnly.peek()) return;
        }
        if (press.button === 2) clicks.menu(press.x, press.y);
        else if (press.button === 0) {
            const how = press.shift ? 'add' : press.ctrl ? 'toggle' : 'only';
            clicks.click(press.x, press.y, how);
        }
    }

    // A burst of the wheel goes toward one point; the next burst, or another place of the pointer, asks again.
    let burst: { x: number; y: number; time: number; point: Vec | null } | null = null;

    function toward(x: number, y: number, factor: number, through: boolean): void {
        const c = here();
        const view = viewPinhole();
        if (!c || !view) return;
        if (c.height) return go(zoom(c, view, x, y, factor));
        const time = performance.now();
        if (!burst || time - burst.time > 500 || Math.hypot(x - burst.x, y - burst.y) > 6) {
            burst = { x, y, time, point: null };
            const mine = burst;
            asked(x, y, (hit) => {
                mine.point = hit.point;
                depth = depthOf(hit.point);
            });
        }
        burst.time = time;
        const [px, py] = [x - view.width / 2, view.height / 2 - y];
        const reach = Math.min(depth, distance(c.eye, centre()) + 1);
        const ahead = (axis: 0 | 1 | 2): number =>
            c.eye[axis] + (view.forward[axis] + view.side[axis] * px * view.pixel + view.up[axis] * py * view.pixel) * reach;
        const point: Vec = burst.point ?? [ahead(0), ahead(1), ahead(2)];
        go(dolly(c, point, factor, NEAREST, through));
        // Once through, one goes toward what is behind.
        if (through && distance(c.eye, point) < 0.5) burst = null;
    }

    function wheel(e: WheelEvent): void {
        if ((e.target as Element).closest('[data-scroll]')) return;
        e.preventDefault();
        const unit = e.deltaMode === 1 ? 18 : e.deltaMode === 2 ? 400 : 1;
        const [dx, dy] = [e.deltaX * unit, e.deltaY * unit];
        const [x, y] = local(e);
        if (hands.peek() === 'trackpad' && !e.ctrlKey) return slide(-dx, -dy, depth);
        // Shift turns the wheel sideways on some machines.
        const amount = (e.ctrlKey ? 6 : 1) * (Math.abs(dy) > Math.abs(dx) ? dy : dx);
        toward(x, y, Math.exp(Math.max(-300, Math.min(300, amount)) * 0.0016), e.shiftKey && !e.ctrlKey);
    }

    const menu = (e: Event) => e.preventDefault();
    const leave = () => {
        clearTimeout(hoverTimer);
        clicks.unhover();
    };
    const double = (e: MouseEvent) => {
        if (!(e.target as Element).closest('[data-handle]') && tool.peek() === null) clicks.double(...local(e));
    };
    const key = (e: KeyboardEvent) => {
        if (e.code === 'Space') space = e.type === 'keydown';
    };
    const sized = new ResizeObserver(() => {
        const box = element.getBoundingClientRect();
        viewSize.value = [Math.max(16, Math.round(box.width)), Math.max(16, Math.round(box.height))];
    });
    sized.observe(element);
    element.addEventListener('pointerdown', down);
    element.addEventListener('pointermove', move);
    element.addEventListener('pointerup', release);
    element.addEventListener('pointercancel', release);
    element.addEventListener('pointerleave', leave);
    element.addEventListener('wheel', wheel, { passive: false });
    element.addEventListener('contextmenu', menu);
    element.addEventListener('dblclick', double);
    addEventListener('keydown', key);
    addEventListener('keyup', key);
    return () => {
        sized.disconnect();
        removeEventListener('keydown', key);
        removeEventListener('keyup', key);
    };
}

/** True if a point of the view lies on the picture. */
export function onPicture(x: number, y: number, width: number, height: number): boolean {
    const fit = fitted(width, height);
    return x >= fit.x && y >= fit.y && x < fit.x + width * fit.scale && y < fit.y + height * fit.scale;
}
