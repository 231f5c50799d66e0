// A lamp or a group as a line of the sheet.

import {
    act, colorText, cost, css, Field, groups, hovered, Icon, lamps, lumensOf, penless, pickRow, select, selection, switchOn, three, typeGroupLevel,
    typeLevel, type Row,
} from '../desk';

export function SheetHead() {
    return (
        <div class="sheet-row head" aria-hidden="true">
            <span /><span>Name</span><span>Level</span><span>lm</span><span>White</span>
        </div>
    );
}

export function SheetRow({ row, index, count }: { row: Row; index: number; count: number }) {
    const lamp = row.kind === 'lamp' ? lamps.get(row.id) : undefined;
    const group = row.kind === 'group' ? groups.get(row.id) : undefined;
    const entry = lamp ?? group;
    if (!entry) return null;
    const selected = selection.value?.kind === row.kind && selection.value.ids.includes(row.id);
    const lumens = lumensOf(group?.lamps ?? [row.id]);
    const locked = penless.value;
    const under = hovered.value?.kind === row.kind && hovered.value.id === row.id;
    return (
        <div
            class={`sheet-row depth-${row.depth} ${row.kind} ${selected ? 'selected' : ''} ${entry.on ? '' : 'off'} ${under ? 'under' : ''}`}
            role="listitem"
            aria-setsize={count}
            aria-posinset={index + 1}
            data-row={`${row.kind}-${row.id}`}
            onPointerEnter={() => (hovered.value = { kind: row.kind, id: row.id })}
            onPointerLeave={() => (hovered.value = null)}
        >
            <button class="icon power" aria-pressed={entry.on} disabled={locked !== null} title={locked ?? undefined} aria-label={`${entry.name} on`} onClick={() => switchOn(row as { kind: 'lamp'; id: number }, !entry.on)}>
                <Icon name="power" />
            </button>
            <button class="row-name" aria-pressed={selected} title={lamp ? cost(lamp) : undefined} onClick={(e) => pickRow(e, row.kind, row.id)} onDblClick={() => act('frame')}>
                <span>{entry.name}</span>
            </button>
            <Field
                label={`${entry.name} level`}
                quantity="level"
                value={entry.level}
                flux={lamp?.flux}
                step={0.01}
                disabled={locked !== null}
                why={locked}
                set={(apply) => (lamp ? typeLevel([row.id], apply) : typeGroupLevel(row.id, apply))}
            />
            <span class="lumens">{three(lumens)}</span>
            {lamp ? (
                <button class="tint" aria-label={`${entry.name} colour: ${colorText(lamp)}`} onClick={() => select('lamp', row.id)}>
                    <i class="swatch" style={{ background: css(lamp.swatch) }} />{colorText(lamp)}
                </button>
            ) : <span />}
        </div>
    );
}
