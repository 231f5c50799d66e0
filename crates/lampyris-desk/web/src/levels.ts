// Levels under the hand: travel of faders, and gestures that change one lamp, several in proportion, or a group.

import { edit, Gesture, stroke } from './gesture';
import { travel } from './prefs';
import { chosenLamps, selection, titleOf } from './select';
import { groups, lamps } from './store';
import type { Id, Patch } from './types';
import { percent } from './units';

/** Where a fader stands for a level, 0 to 1: by the square law, near to how brightness is felt, or even. */
export const toTravel = (level: number): number => Math.min(1, travel.value === 'square' ? Math.sqrt(Math.max(level, 0)) : level);
export const toLevel = (t: number): number => {
    const level = travel.peek() === 'square' ? t * t : t;
    // Whole per mille, so that what is read can be typed.
    return Math.round(level * 1000) / 1000;
};

export type Strip = { kind: 'lamp' | 'group'; id: Id };

const levelOf = (s: Strip): number => (s.kind === 'lamp' ? lamps.get(s.id) : groups.get(s.id))?.level ?? 0;
const nameOf = (s: Strip): string => (s.kind === 'lamp' ? lamps.get(s.id) : groups.get(s.id))?.name ?? '';

/** The lamps that move with a fader: all that are selected if it is one of them. */
function together(s: Strip): Id[] {
    const chosen = chosenLamps.peek();
    return s.kind === 'lamp' && selection.peek()?.kind === 'lamp' && chosen.length > 1 && chosen.includes(s.id) ? chosen : [s.id];
}

/** What a fader does to all that move with it: their proportions stay; from nothing they rise together. */
function patchFor(s: Strip, level: number, from: Map<Id, number>): Patch {
    if (s.kind === 'group') return { groups: { [s.id]: { level } } };
    const own = from.get(s.id) ?? 0;
    const values: Record<string, unknown> = {};
    for (const [id, was] of from) {
        const next = id === s.id ? level : own > 0 ? Math.min(10, was * (level / own)) : level;
        values[id] = { level: Math.round(next * 1000) / 1000 };
    }
    return { lamps: values };
}

/** A fader from taking hold to letting go. */
export class Fade {
    private gesture: Gesture;
    private from: Map<Id, number>;
    private was: number;
    private now: number;
    constructor(private strip: Strip) {
        this.was = this.now = levelOf(strip);
        this.from = strip.kind === 'lamp' ? new Map(together(strip).map((id) => [id, lamps.get(id)?.level ?? 0])) : new Map();
        this.gesture = new Gesture(`${nameOf(strip)} level`);
    }
    to(level: number): void {
        this.now = level;
        this.gesture.set(patchFor(this.strip, level, this.from));
    }
    end(): void {
        const title = this.from.size > 1 ? titleOf([...this.from.keys()]) : nameOf(this.strip);
        this.gesture.end(`${title} ${percent(this.was)} → ${percent(this.now)} %`);
    }
    cancel(): void {
        this.gesture.cancel();
    }
}

/** A stroke of a key or of the wheel; those that follow each other are one step. */
export function strokeLevel(s: Strip, level: number): void {
    const from = new Map(together(s).map((id) => [id, lamps.get(id)?.level ?? 0]));
    stroke(`level ${s.kind} ${s.id}`, `${nameOf(s)} level`, patchFor(s, level, from));
}

/** A typed level: absolute for all, or each by its own old value. */
export function typeLevel(ids: Id[], apply: (old: number, flux: number) => number): void {
    if (!ids.length) return;
    const values = Object.fromEntries(ids.map((id) => {
        const lamp = lamps.get(id);
        return [id, { level: apply(lamp?.level ?? 0, lamp?.flux ?? 1) }];
    }));
    const now = ids.length === 1 ? ` ${percent(lamps.get(ids[0])?.level ?? 0)} → ${percent((values[ids[0]] as { level: number }).level)} %` : ' level';
    edit(`${titleOf(ids)}${now}`, { lamps: values });
}

export function typeGroupLevel(id: Id, apply: (old: number) => number): void {
    const level = apply(groups.get(id)?.level ?? 0);
    edit(`${groups.get(id)?.name ?? 'Group'} ${percent(level)} %`, { groups: { [id]: { level } } });
}

export function switchOn(s: Strip, on: boolean): void {
    const label = `${nameOf(s)} ${on ? 'on' : 'off'}`;
    if (s.kind === 'group') edit(label, { groups: { [s.id]: { on } } });
    else edit(label, { lamps: Object.fromEntries(together(s).map((id) => [id, { on }])) });
}
