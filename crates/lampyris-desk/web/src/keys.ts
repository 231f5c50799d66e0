// Keys of the whole page. Single letters act only where nobody types and may be switched off; walking keys are known by
// their place on the keyboard, the others by what is printed on them.

import { signal } from '@preact/signals';
import { act, command, wantLevel } from './actions';
import { compareHeld, comparing } from './before';
import { highlight } from './highlight';
import {
    bounds, centre, circle, go, here, slide, stride, toFrame, turnHead, viewPinhole, viewSize,
} from './navigate';
import { dolly, zoom } from './camera';
import { fade, singleKeys } from './prefs';
import { say } from './say';
import { chosenLamps, deselect, selection, tool } from './select';
import { looks, views } from './store';
import { distance } from './vec';
import { closeWhat, openWhat, what } from './lights';
import { ask } from './wire';
import type { Hit } from './types';

/** Names of the walking keys on the user's own keyboard, where the browser tells. */
export const walkNames = signal('W A S D');

const WALK: Record<string, [number, number, number]> = {
    KeyW: [1, 0, 0], KeyS: [-1, 0, 0], KeyA: [0, -1, 0], KeyD: [0, 1, 0], KeyQ: [0, 0, -1], KeyE: [0, 0, 1],
};
const SPEED = 1.8;
const held = new Set<string>();
let recalling = false;
let fast = 1;
let running = false;
let last = 0;

function run(time: number): void {
    const seconds = Math.min(0.1, Math.max(0, (time - last) / 1000));
    last = time;
    if (!held.size) {
        running = false;
        return;
    }
    let [a, s, u] = [0, 0, 0];
    for (const code of held) {
        const [da, ds, du] = WALK[code];
        a += da;
        s += ds;
        u += du;
    }
    const reach = Math.max(1, distance(...bounds()) / 12);
    const by = SPEED * seconds * fast * Math.min(reach, 6);
    if (a || s || u) stride(a * by, s * by, u * by);
    requestAnimationFrame(run);
}

function press(code: string): void {
    held.add(code);
    if (running) return;
    running = true;
    last = performance.now();
    requestAnimationFrame(run);
}

const typing = (target: EventTarget | null): boolean =>
    target instanceof HTMLElement
    && (target.isContentEditable || (target.matches('input, textarea, select') && !target.matches('[type=range], [type=checkbox], [type=radio]')));

function inView(): boolean {
    const now = document.activeElement;
    return now === null || now === document.body || now.id === 'view';
}

/** Keys that act by letter or sign, without Ctrl. */
const LETTERS: Record<string, string> = {
    f: 'frame', t: 'aim', g: 'move', r: 'turn', n: 'add-spot', o: 'on-off', i: 'solo', h: 'hide', b: 'false-colour',
    u: 'panels', c: 'wipe', m: 'marquee', v: 'walking', p: 'meter', '[': 'previous', ']': 'next', '?': 'help', delete: 'remove',
    home: 'home',
};
const SHIFTED: Record<string, string> = {
    b: 'quantity', o: 'park', i: 'unsolo', l: 'from-lamp', g: 'grid', t: 'aim-here', n: 'place',
};
const PLACED: Record<string, string> = { Comma: 'darker', Period: 'brighter', Slash: 'expose' };
const DIGITS: Record<string, string> = {
    Digit1: 'preset-plan', Digit2: 'preset-ceiling', Digit3: 'preset-north', Digit4: 'preset-east', Digit5: 'preset-south',
    Digit6: 'preset-west', Digit0: 'inside',
};

function withControl(e: KeyboardEvent): string | null {
    const key = e.key.toLowerCase();
    if (key === 'z') return e.shiftKey ? 'redo' : 'undo';
    if (key === 'y') return 'redo';
    if (key === 'k') return 'palette';
    if (key === 's') return e.shiftKey ? 'picture' : 'save';
    if (key === 'd') return 'duplicate';
    if (key === 'g') return e.shiftKey ? 'ungroup' : 'group';
    if (key === 'a') return 'all-lamps';
    if (key === 'enter') return 'look-store';
    return null;
}

/** Leaves what is innermost: a tool, a popover, a comparison, the selection, at last the view. */
export function escape(): void {
    if (tool.peek()) tool.value = null;
    else if (what.peek()) closeWhat();
    else if (comparing.peek()) comparing.value = null;
    else if (selection.peek()) deselect();
    else if (document.activeElement?.id === 'view') {
        const next = document.querySelector<HTMLElement>('.bar button, .bar [tabindex="0"]');
        next?.focus();
    }
}

function arrows(e: KeyboardEvent): boolean {
    const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
    if (!x && !y) return false;
    if (e.ctrlKey || here()?.height) slide(-x * 24, y * 24, 3);
    else if (e.shiftKey) circle(centre(), -x * 0.05, y * 0.05);
    else turnHead(-x * 0.06, y * 0.06);
    return true;
}

function nearer(factor: number): void {
    const c = here();
    const view = viewPinhole();
    if (!c || !view) return;
    if (c.height) go(zoom(c, view, view.width / 2, view.height / 2, factor));
    else go(dolly(c, c.target, factor, 0.3, true));
}

/** Takes keys before all others while something is typed in the view; comes with the second file. */
let taker: (e: KeyboardEvent) => boolean = () => false;
export const keysFirst = (takes: typeof taker): void => void (taker = takes);

function down(e: KeyboardEvent): void {
    if (e.defaultPrevented || document.querySelector('dialog[open]')) return;
    if (!typing(e.target) && taker(e)) return e.preventDefault();
    const control = e.ctrlKey || e.metaKey;
    if (e.key === 'Escape') return escape();
    if (typing(e.target)) {
        if (control && e.key.toLowerCase() === 'k') stop(e, 'palette');
        return;
    }
    if (control && !e.altKey) {
        if (inView() && arrows(e)) return e.preventDefault();
        const id = withControl(e);
        if (id) stop(e, id);
        return;
    }
    if (e.altKey) {
        const digit = /^Digit(\d)$/.exec(e.code)?.[1];
        if (e.key === 'ArrowLeft') return stop(e, 'back');
        if (e.key === 'ArrowRight') return stop(e, 'forth');
        if (digit === '0') return stop(e, 'store-view');
        if (digit) {
            e.preventDefault();
            const saved = views.all()[Number(digit) - 1];
            if (saved) go(saved[1], saved[1].name ?? 'view');
            return;
        }
        if (e.code === 'KeyH') stop(e, 'unhide');
        if (!(e.code in WALK)) return;
    }
    const inside = inView();
    if (inside && arrows(e)) return e.preventDefault();
    if (inside && e.code in WALK) {
        fast = e.shiftKey ? 4 : e.altKey ? 0.25 : 1;
        press(e.code);
        return e.preventDefault();
    }
    if (inside && (e.key === '+' || e.key === '=')) return nearer(0.85);
    if (inside && (e.key === '-' || e.key === '_')) return nearer(1 / 0.85);
    if (!singleKeys.peek()) return;
    if (e.shiftKey && DIGITS[e.code]) return stop(e, DIGITS[e.code]);
    if (recalling && /^\d$/.test(e.key)) {
        e.preventDefault();
        recalling = false;
        const id = looks.ids.peek()[Number(e.key) - 1];
        if (id !== undefined) command({ do: 'look', id, what: 'recall', seconds: fade.peek() });
        return;
    }
    recalling = e.key.toLowerCase() === 'j';
    if (recalling) return say('Recall a look: now its digit.');
    if (!e.shiftKey && /^\d$/.test(e.key) && chosenLamps.peek().length) {
        e.preventDefault();
        wantLevel.value = e.key;
        return;
    }
    if (!e.shiftKey && e.key !== '?' && PLACED[e.code]) return stop(e, PLACED[e.code]);
    if (e.key === '\\') return void (e.repeat || compareHeld(true));
    const key = e.key.toLowerCase();
    if (key === 'l' && !e.shiftKey) return void (e.repeat || act('highlight'));
    if (key === 'p' && e.shiftKey) return whatHere();
    const id = e.shiftKey && SHIFTED[key] ? SHIFTED[key] : LETTERS[key];
    if (id && !(e.target instanceof HTMLButtonElement && key === 'enter')) stop(e, id);
}

/** What lights the middle of the view, for those who have no pointer. */
function whatHere(): void {
    const [w, h] = viewSize.peek();
    const at = toFrame(w / 2, h / 2);
    if (at) ask('point', at, (answer) => answer.hit && openWhat(w / 2, h / 2, answer as unknown as Hit));
}

function stop(e: KeyboardEvent, id: string): void {
    e.preventDefault();
    act(id);
}

function up(e: KeyboardEvent): void {
    held.delete(e.code);
    if (e.key === '\\') compareHeld(false);
    if (e.key.toLowerCase() === 'l') highlight(false);
    if (e.key === 'Shift') fast = 1;
}

export function followKeys(): void {
    addEventListener('keydown', down);
    addEventListener('keyup', up);
    addEventListener('blur', () => {
        held.clear();
        highlight(false);
        compareHeld(false);
    });
    const keyboard = (navigator as { keyboard?: { getLayoutMap(): Promise<Map<string, string>> } }).keyboard;
    void keyboard?.getLayoutMap().then((map) => {
        walkNames.value = ['KeyW', 'KeyA', 'KeyS', 'KeyD'].map((code) => (map.get(code) ?? code.slice(3)).toUpperCase()).join(' ');
    }).catch(() => undefined);
}

/** The pad under a finger walks as the keys do; each −1 to 1. */
export function padWalk(ahead: number, sideways: number): void {
    for (const code of ['KeyW', 'KeyS', 'KeyA', 'KeyD']) held.delete(code);
    fast = Math.min(1, Math.hypot(ahead, sideways));
    if (ahead > 0.2) press('KeyW');
    if (ahead < -0.2) press('KeyS');
    if (sideways < -0.2) press('KeyA');
    if (sideways > 0.2) press('KeyD');
}
