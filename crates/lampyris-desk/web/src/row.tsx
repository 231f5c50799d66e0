// What both listings show of a lamp or a group: who it is, its switch, and its level as a number.

import { Field } from './field';
import { penless } from './gesture';
import { Icon } from './icon';
import type { Row } from './lamps';
import { switchOn, typeGroupLevel, typeLevel } from './levels';
import { chosenLamps, hovered, selection } from './select';
import { groups, lamps, lumensOf, solo } from './store';
import type { Group, Id, Lamp } from './types';
import { digits } from './units';

/** The colour of a lamp in a word. */
export function colorText(lamp: Lamp): string {
    const c = lamp.color;
    if (c.mode === 'kelvin') return `${digits(c.kelvin)} K`;
    return c.mode === 'rgb' ? 'RGB' : c.mode === 'xy' ? 'x y' : 'file';
}

export const cost = (lamp: Lamp): string =>
    lamp.free ? 're-mix: level and colour cost no ray' : 're-trace: its light is traced anew';

export interface Listed {
    row: Row;
    lamp: Lamp | undefined;
    group: Group | undefined;
    entry: Lamp | Group;
    members: Id[];
    /** What 100 % are, and what it gives now [lm]. */
    flux: number;
    lumens: number;
    selected: boolean;
    /** By Tab one comes to the rest of a row only once it is selected. */
    stop: number;
    /** Attributes of its element but for the class, whose words of the moment are `state`. */
    frame: Record<string, unknown>;
    state: string;
}

/** All of that; null for one that is gone. */
export function listed(row: Row, index: number, count: number): Listed | null {
    const { kind, id } = row;
    const lamp = kind === 'lamp' ? lamps.get(id) : undefined;
    const group = kind === 'group' ? groups.get(id) : undefined;
    const entry = lamp ?? group;
    if (!entry) return null;
    const members = group?.lamps ?? [id];
    const selected = selection.value?.kind === kind && selection.value.ids.includes(id);
    const muted = solo.value.length > 0 && !members.some((own) => solo.value.includes(own));
    const under = hovered.value?.kind === kind && hovered.value.id === id;
    return {
        row, lamp, group, entry, members, selected,
        flux: members.reduce((sum, own) => sum + (lamps.get(own)?.flux ?? 0) * (group ? lamps.get(own)?.level ?? 0 : 1), 0),
        lumens: lumensOf(members),
        stop: selected ? 0 : -1,
        frame: {
            role: 'listitem', 'aria-setsize': count, 'aria-posinset': index + 1, 'data-row': `${kind}-${id}`,
            onPointerEnter: () => (hovered.value = { kind, id }),
            onPointerLeave: () => (hovered.value = null),
        },
        state: `depth-${row.depth} ${kind} ${selected ? 'selected' : ''} ${entry.on && !lamp?.parked ? '' : 'off'} ${muted ? 'muted' : ''} ${under ? 'under' : ''}`,
    };
}

export function Power({ of: { row, entry, stop } }: { of: Listed }) {
    const locked = penless.value;
    return (
        <button class="icon power" tabIndex={stop} aria-pressed={entry.on} disabled={locked !== null} aria-label={`${entry.name} on`} title={locked ?? (entry.on ? 'On (O)' : 'Off (O)')} onClick={() => switchOn(row, !entry.on)}>
            <Icon name="power" />
        </button>
    );
}

/** A level that is typed: of all that are selected, if it is one of them. */
export function LevelField({ of: { row, entry, lamp, flux, selected }, label, tabIndex }: { of: Listed; label: string; tabIndex?: number }) {
    const ids = () => (selected && chosenLamps.peek().length > 1 ? chosenLamps.peek() : [row.id]);
    return (
        <Field
            label={`${entry.name} ${label}`}
            quantity="level"
            value={entry.level}
            flux={flux}
            step={0.01}
            disabled={penless.value !== null}
            why={penless.value}
            tabIndex={tabIndex}
            set={(apply) => (lamp ? typeLevel(ids(), apply) : typeGroupLevel(row.id, apply))}
        />
    );
}
