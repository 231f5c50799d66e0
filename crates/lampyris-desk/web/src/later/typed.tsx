// Moving and turning by keys: G or R, then an axis, then digits. What is typed is done at once; Enter keeps it, Escape
// takes it back. A key is first what is printed on it and else its place, so that all keyboards have these.

import { effect, handles, keysFirst, role, say, scale, selection, signal, tool, untracked, type Vec } from '../desk';
import { take } from './handles';
import type { Hold } from './gizmo';

interface Typed {
    what: 'move' | 'turn';
    /** Not chosen yet: every other key does what it always does. */
    axis: number | null;
    text: string;
}

/** What a key is to this: one of these, or nothing. */
export interface Stroke {
    axis?: number;
    sign?: string;
    does?: 'back' | 'keep' | 'leave';
}

const AXES: Vec[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const SIGNS: Record<string, string> = { Minus: '-', NumpadSubtract: '-', Period: '.', Comma: '.', NumpadDecimal: '.' };

const DOES: Record<string, Stroke['does']> = { Enter: 'keep', Escape: 'leave', Backspace: 'back' };

export function strokeOf({ key, code }: { key: string; code: string }): Stroke {
    if (DOES[key]) return { does: DOES[key] };
    const printed = key.length === 1 ? 'xyz'.indexOf(key.toLowerCase()) : -1;
    if (printed >= 0) return { axis: printed };
    if (/^\d$/.test(key)) return { sign: key };
    if (/^[.,]$/.test(key)) return { sign: '.' };
    if (/^[-−]$/.test(key)) return { sign: '-' };
    if (/^[a-z]$/i.test(key)) return {};
    const axis = ['KeyX', 'KeyY', 'KeyZ'].indexOf(code);
    if (axis >= 0) return { axis };
    const sign = /^(?:Digit|Numpad)(\d)$/.exec(code)?.[1] ?? SIGNS[code];
    return sign ? { sign } : {};
}

/** A number as far as it is typed, with one sign more: a second minus takes the first away, a second point is none. */
export function typedOn(text: string, sign: string): string {
    if (sign === '-') return text.startsWith('-') ? text.slice(1) : `-${text}`;
    if (sign === '.' && text.includes('.')) return text;
    return text.length < 9 ? text + sign : text;
}

/** What a number is that may not be whole yet. */
export const numberIn = (text: string): number => Number(text) || 0;

const typed = signal<Typed | null>(null);
let hold: Hold | null = null;

/** Takes the handles, and what is typed next. */
export function startTyped(what: Typed['what']): void {
    finish(true);
    handles.value = what;
    tool.value = null;
    typed.value = { what, axis: null, text: '' };
}

function finish(keep: boolean): void {
    if (!typed.peek()) return;
    typed.value = null;
    if (keep) hold?.end();
    else hold?.cancel();
    hold = null;
}

function follow(next: Typed): void {
    typed.value = next;
    const axis = AXES[next.axis ?? 0];
    const by = numberIn(next.text);
    if (next.what === 'move') hold?.move(scale(axis, by));
    else hold?.rotate(axis, (by * Math.PI) / 180);
}

/** True for a key that was meant for this. */
function takes(e: KeyboardEvent): boolean {
    const now = typed.peek();
    if (!now || e.key === 'Shift') return false;
    const controlled = e.ctrlKey || e.metaKey || e.altKey;
    const { axis, sign, does }: Stroke = controlled ? {} : strokeOf(e);
    if (now.axis === null) {
        if (axis === undefined) {
            finish(false);
            return does === 'leave';
        }
        hold = take(now.what);
        if (hold) follow({ ...now, axis });
        else {
            finish(false);
            say('Select lamps that have a place, or things that are not locked.', 'warn');
        }
        return true;
    }
    if (controlled) {
        finish(true);
        return false;
    }
    if (axis !== undefined) follow({ ...now, axis });
    else if (sign) follow({ ...now, text: typedOn(now.text, sign) });
    else if (does === 'back') follow({ ...now, text: now.text.slice(0, -1) });
    else if (does) finish(does === 'keep');
    else return e.key.length === 1;
    return true;
}

keysFirst(takes);
// Who takes the pointer has finished typing.
addEventListener('pointerdown', (e) => finish(e.button !== 2), true);
effect(() => {
    void selection.value;
    untracked(() => finish(true));
});

export function TypedHint() {
    const now = typed.value;
    if (!now || role.value === 'watch') return null;
    const does = now.what === 'move' ? 'Move' : 'Turn';
    if (now.axis === null) return <p class="hint" role="status">{does}: X, Y or Z, then {now.what === 'move' ? 'metres' : 'degrees'}; or drag a handle.</p>;
    return (
        <p class="hint" role="status">
            {does} {now.what === 'move' ? 'along' : 'about'} {'XYZ'[now.axis]}: <b>{now.text || '0'}</b>{now.what === 'move' ? ' m' : '°'}. Enter keeps it, Esc takes it back.
        </p>
    );
}
