// A gesture: edits from taking hold to letting go are one step of undo. Latest wins, the last always arrives.
//
// While the hand is on a control at most one of its values is under way; what comes meanwhile replaces what waits, and
// letting go sends it whatever is still under way. Two hands at once share one step: it begins with the first and ends
// with the last.

import { computed, effect, untracked } from '@preact/signals';
import { lookOnly } from './prefs';
import { editor, keep, merge, releaseUpTo, settle } from './store';
import { say } from './say';
import type { Patch } from './types';
import { followed, line, role, send } from './wire';

let open = 0;
const beginners = new Set<() => void>();
/** Is told before each step begins. */
export const onBegin = (heard: () => void): void => void beginners.add(heard);
const live = new Set<Gesture>();

/** Why this page edits nothing as it stands, or null: its controls are disabled then. */
export const penless = computed<string | null>(() => {
    if (lookOnly.value) return 'The look-only lock is on.';
    if (role.value === 'watch') return 'You are watching. Ask for the pen to change things.';
    if (!editor.value.you) return `${editor.value.name ?? 'Somebody else'} has the pen. Take it to change things.`;
    return null;
});

/** Why edits are not possible now, or null. */
export function whyNot(): string | null {
    if (line.value !== 'open') return 'There is no connection to the program: nothing was changed.';
    return penless.value;
}

/** A label as long as the program takes them. */
const short = (text: string): string => (text.length > 120 ? `${text.slice(0, 119)}…` : text).replace(/[\u0000-\u001f]/g, ' ');

export class Gesture {
    private waiting: Patch | null = null;
    private touched: Patch = {};
    private under = 0;
    private last = 0;
    private state: 'new' | 'held' | 'over' = 'new';

    constructor(private label: string) {}

    /** A new value of the control. */
    set(patch: Patch): void {
        if (this.state === 'over' || !this.begin()) return;
        keep(patch, Infinity);
        this.touched = merge(this.touched, patch);
        this.waiting = merge(this.waiting ?? {}, patch);
        if (this.under <= followed.peek()) this.flush();
    }

    /** Any other message that belongs to this step. */
    also(message: { do: string } & Record<string, unknown>): void {
        if (this.state === 'over' || !this.begin()) return;
        this.flush();
        this.last = send(message);
    }

    end(label?: string): void {
        if (this.state === 'held') {
            this.flush();
            settle(this.touched, this.last);
            this.finish({ do: 'end', ...(label ? { label: short(label) } : {}) });
        }
        this.state = 'over';
    }

    cancel(): void {
        if (this.state === 'held') {
            this.waiting = null;
            settle(this.touched, 0);
            this.finish({ do: 'cancel' });
            releaseUpTo(0);
        }
        this.state = 'over';
    }

    /** The server has followed so far. */
    followed(): void {
        if (this.waiting && this.under <= followed.peek()) this.flush();
    }

    /** The line is gone, and with it what was held. */
    drop(): void {
        this.state = 'over';
        live.delete(this);
        open = 0;
    }

    private begin(): boolean {
        if (this.state === 'held') return true;
        const why = untracked(whyNot);
        if (why) {
            say(why, 'warn');
            this.state = 'over';
            return false;
        }
        this.state = 'held';
        live.add(this);
        if (open === 0) beginners.forEach((heard) => heard());
        if (open++ === 0) this.last = send({ do: 'begin', label: short(this.label) });
        return true;
    }

    private flush(): void {
        if (!this.waiting) return;
        this.under = this.last = send({ do: 'set', patch: this.waiting });
        this.waiting = null;
    }

    private finish(message: { do: string } & Record<string, unknown>): void {
        live.delete(this);
        open = Math.max(0, open - 1);
        if (open === 0) send(message);
    }
}

/** An edit at one stroke. */
export function edit(label: string, patch: Patch): void {
    const gesture = new Gesture(label);
    gesture.set(patch);
    gesture.end();
}

/** Any other message, as a step of its own. */
export function step(label: string, message: { do: string } & Record<string, unknown>): void {
    const gesture = new Gesture(label);
    gesture.also(message);
    gesture.end();
}

/** What is not an edit but shown at once all the same: exposure, tone, false colour. */
export function show(patch: Patch): void {
    if (untracked(() => line.value) !== 'open') return;
    keep({ display: patch }, Infinity);
    settle({ display: patch }, send({ do: 'display', patch }));
}

let typed: { key: string; gesture: Gesture; timer: number } | null = null;

/** Strokes of a key on the same control become one step if they follow within 0.7 s. */
export function stroke(key: string, label: string, patch: Patch): void {
    if (typed && typed.key !== key) endStroke();
    typed ??= { key, gesture: new Gesture(label), timer: 0 };
    typed.gesture.set(patch);
    clearTimeout(typed.timer);
    typed.timer = window.setTimeout(endStroke, 700);
}

export function endStroke(): void {
    if (!typed) return;
    clearTimeout(typed.timer);
    typed.gesture.end();
    typed = null;
}

effect(() => {
    void followed.value;
    untracked(() => [...live].forEach((gesture) => gesture.followed()));
});
effect(() => {
    if (line.value !== 'open') [...live].forEach((gesture) => gesture.drop());
});
