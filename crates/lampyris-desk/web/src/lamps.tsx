// The lamps: one list, as faders or as a sheet, in their groups; found by name, selected by one, several or a range.

import { computed, signal } from '@preact/signals';
import { act } from './actions';
import { listing } from './prefs';
import { chosenLamps, selection, selectRange, select, type Kind } from './select';
import { groups, lamps } from './store';
import type { Id } from './types';
import { FaderRow } from './faderrow';
import { Menu, Item } from './menu';
import { Later, part } from './load';
import { Virtual } from './virtual';
import { digits } from './units';

export type Row = { kind: 'lamp' | 'group'; id: Id; depth: number };

export const filter = signal('');
export const folded = signal<Set<Id>>(new Set());
const sort = signal<'group' | 'name' | 'flux' | 'level'>('group');

/** Rows in sight of both listings: groups with their lamps, or what the filter finds. */
export const rows = computed<Row[]>(() => {
    const wanted = filter.value.trim().toLowerCase();
    const all = lamps.listed();
    const own = groups.listed();
    const called = new Map(own.map(([id, group]) => [id, group.name]));
    const found = new Map(all.filter(([, lamp]) =>
        !wanted || `${lamp.name} ${lamp.kind} ${called.get(lamp.group ?? -1) ?? ''}`.toLowerCase().includes(wanted)));
    if (sort.value !== 'group' && listing.value === 'sheet') {
        const key = sort.value;
        const list = [...found];
        list.sort(([, a], [, b]) => (key === 'name' ? a.name.localeCompare(b.name, 'en', { numeric: true }) : b[key] - a[key]));
        return list.map(([id]) => ({ kind: 'lamp', id, depth: 0 }));
    }
    const out: Row[] = [];
    const grouped = new Set<Id>();
    for (const [id, group] of own) {
        group.lamps.forEach((lamp) => grouped.add(lamp));
        const members = group.lamps.filter((lamp) => found.has(lamp));
        if (!members.length) continue;
        if (group.lamps.length === 1) {
            out.push({ kind: 'lamp', id: members[0], depth: 0 });
            continue;
        }
        out.push({ kind: 'group', id, depth: 0 });
        if (!folded.value.has(id) || wanted) members.forEach((lamp) => out.push({ kind: 'lamp', id: lamp, depth: 1 }));
    }
    for (const [id] of found) if (!grouped.has(id)) out.push({ kind: 'lamp', id, depth: 0 });
    return out;
});

/** Many groups are shown folded at first. */
let seen = false;
groups.ids.subscribe((ids) => {
    if (seen || !ids.length) return;
    seen = true;
    if (lamps.ids.peek().length > 40) folded.value = new Set(ids.filter((id) => (groups.get(id)?.lamps.length ?? 0) > 1));
});

export function fold(id: Id): void {
    const next = new Set(folded.peek());
    if (!next.delete(id)) next.add(id);
    folded.value = next;
}

/** A click on a row's name, with the usual keys. */
export function pickRow(e: MouseEvent, kind: Kind, id: Id): void {
    if (e.shiftKey) selectRange(kind, rows.peek().filter((row) => row.kind === kind).map((row) => row.id), id);
    else select(kind, id, e.ctrlKey || e.metaKey ? 'toggle' : 'only');
}

/** Arrow keys go from name to name. */
function key(e: KeyboardEvent): void {
    const by = { ArrowDown: 1, ArrowUp: -1 }[e.key];
    const target = e.target as HTMLElement;
    if (!by || !target.matches('.row-name')) return;
    e.preventDefault();
    const names = [...(e.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('.row-name')];
    names[names.indexOf(target) + by]?.focus();
}

const ADD = ['add-spot', 'add-point', 'add-disc', 'add-sphere'];

export function Lamps() {
    const list = rows.value;
    const last = selection.value?.ids[selection.value.ids.length - 1];
    const shown = list.findIndex((row) => row.kind === selection.value?.kind && row.id === last);
    const coarse = matchMedia('(pointer: coarse)').matches;
    const sheet = listing.value === 'sheet';
    return (
        <section class="panel lamps" aria-label="Lamps" onKeyDown={key}>
            <header class="panel-head">
                <h2>Lamps <small>{digits(lamps.ids.value.length)}</small></h2>
                <span class="gap" />
                <div class="segments" role="group" aria-label="Listing">
                    <button aria-pressed={!sheet} onClick={() => (listing.value = 'faders')}>Faders</button>
                    <button aria-pressed={sheet} onClick={() => (listing.value = 'sheet')}>Sheet</button>
                </div>
            </header>
            <div class="panel-tools">
                <span class="field filter">
                    <input
                        type="text"
                        aria-label="Filter lamps"
                        placeholder="Filter"
                        value={filter.value}
                        onInput={(e) => (filter.value = e.currentTarget.value)}
                        onKeyDown={(e) => {
                            if (e.key !== 'Escape') return;
                            filter.value = '';
                            e.stopPropagation();
                        }}
                    />
                </span>
                {sheet && (
                    <select aria-label="Order" value={sort.value} onChange={(e) => (sort.value = e.currentTarget.value as 'group')}>
                        <option value="group">by group</option>
                        <option value="name">by name</option>
                        <option value="flux">by flux</option>
                        <option value="level">by level</option>
                    </select>
                )}
                <Menu id="add-menu" label="Add" title="Add a lamp">
                    {ADD.map((id) => <Item key={id} id={id} />)}
                    <button class="item" aria-disabled="true" title="Photometric files come with a later version"><span>IES or LDT file…</span><kbd>later</kbd></button>
                </Menu>
            </div>
            {sheet && <Later part="SheetHead" />}
            <Virtual
                label="Lamps and groups"
                count={list.length}
                height={sheet ? (coarse ? 44 : 28) : coarse ? 84 : 54}
                show={shown}
                row={(k) => {
                    const row = list[k];
                    const Part = sheet ? part('SheetRow') : FaderRow;
                    return Part && <Part key={`${row.kind}${row.id}`} row={row} index={k} count={list.length} />;
                }}
            />
            {chosenLamps.value.length > 1 && (
                <p class="several">
                    {chosenLamps.value.length} selected; a fader moves them in proportion
                    {selection.value?.kind === 'lamp' && <button onClick={() => act('group')}>Group</button>}
                    <button onClick={() => act('none')}>None</button>
                </p>
            )}
            {!list.length && lamps.ids.value.length > 0 && <p class="quiet empty">No lamp is called so.</p>}
        </section>
    );
}

