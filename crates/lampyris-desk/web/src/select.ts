// What is selected, what is hovered, which tool the next click serves.

import { computed, signal } from '@preact/signals';
import { groups, lamps, materials, things } from './store';
import type { Id, Vec } from './types';

export type Kind = 'lamp' | 'group' | 'thing' | 'material' | 'meter' | 'grid';
export interface Selection {
    kind: Kind;
    ids: Id[];
}

export const selection = signal<Selection | null>(null);
export const hovered = signal<{ kind: Kind; id: Id } | null>(null);

/** What the next click in the view does. */
export type Tool = 'aim' | 'place' | 'meter' | 'grid' | 'add' | 'marquee' | null;
export const tool = signal<Tool>(null);
/** Handles that are shown for what is selected. */
export const handles = signal<'move' | 'turn'>('move');

/** Lamps that an edit of the selection concerns: those selected, or the members of the groups selected. */
export const chosenLamps = computed<Id[]>(() => {
    const now = selection.value;
    if (now?.kind === 'lamp') return now.ids.filter((id) => lamps.has(id));
    if (now?.kind === 'group') return now.ids.flatMap((id) => groups.get(id)?.lamps ?? []);
    return [];
});

export function select(kind: Kind, id: Id, how: 'only' | 'add' | 'toggle' = 'only'): void {
    const now = selection.peek();
    if (how === 'only' || now?.kind !== kind) {
        selection.value = { kind, ids: [id] };
        return;
    }
    const has = now.ids.includes(id);
    if (has && how === 'add') return;
    const ids = has ? now.ids.filter((other) => other !== id) : [...now.ids, id];
    selection.value = ids.length ? { kind, ids } : null;
}

export function deselect(): void {
    selection.value = null;
}

/** From one end of a list to the other, as Shift in a list does. */
export function selectRange(kind: Kind, order: Id[], to: Id): void {
    const now = selection.peek();
    const from = now?.kind === kind ? order.indexOf(now.ids[now.ids.length - 1]) : -1;
    if (from < 0) return select(kind, to);
    const end = order.indexOf(to);
    const [a, b] = from < end ? [from, end] : [end, from];
    const range = order.slice(a, b + 1);
    const kept = (now?.ids ?? []).filter((id) => !range.includes(id));
    selection.value = { kind, ids: [...kept, ...(from < end ? range : range.reverse())] };
}

export function stepSelection(by: number): void {
    const now = selection.peek();
    const kind = now?.kind ?? 'lamp';
    const order = kind === 'lamp' ? lamps.ids.peek() : kind === 'thing' ? things.ids.peek() : groups.ids.peek();
    if (!order.length) return;
    const at = now ? order.indexOf(now.ids[now.ids.length - 1]) : by > 0 ? -1 : 0;
    select(kind, order[(at + by + order.length) % order.length]);
}

export function nameOf(kind: Kind, id: Id): string {
    switch (kind) {
        case 'lamp':
            return lamps.get(id)?.name ?? `lamp ${id}`;
        case 'group':
            return groups.get(id)?.name ?? `group ${id}`;
        case 'thing':
            return things.get(id)?.name ?? `thing ${id}`;
        case 'material':
            return materials.get(id)?.name ?? `material ${id}`;
        default:
            return `${kind} ${id}`;
    }
}

/** How a step of undo names the lamps it concerns. */
export function titleOf(ids: Id[]): string {
    return ids.length === 1 ? nameOf('lamp', ids[0]) : `${ids.length} lamps`;
}

/**
 * What a click on a point selects: the lamp there, then its group, then the thing behind; beginning anew with the next
 * point or when the end is reached.
 */
export function selectHit(hit: { lamp: Id | null; thing: Id | null } | null, how: 'only' | 'add' | 'toggle'): void {
    const chain: Selection[] = [];
    if (hit?.lamp != null) {
        chain.push({ kind: 'lamp', ids: [hit.lamp] });
        const group = lamps.get(hit.lamp)?.group;
        if (group != null && (groups.get(group)?.lamps.length ?? 0) > 1) chain.push({ kind: 'group', ids: [group] });
    }
    if (hit?.thing != null) chain.push({ kind: 'thing', ids: [hit.thing] });
    if (!chain.length) {
        if (how === 'only') deselect();
        return;
    }
    if (how !== 'only') return select(chain[0].kind, chain[0].ids[0], how);
    const now = selection.peek();
    const at = chain.findIndex((s) => now?.kind === s.kind && now.ids.length === 1 && now.ids[0] === s.ids[0]);
    selection.value = chain[(at + 1) % chain.length];
}

/** The point that tools speak of, where the pointer last asked. */
export const spot = signal<{ point: Vec; normal: Vec } | null>(null);
