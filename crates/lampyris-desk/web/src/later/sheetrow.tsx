// A lamp or a group as a line of the sheet.

import { act, colorText, cost, css, LevelField, listed, pickRow, Power, select, three, type Row } from '../desk';

export function SheetHead() {
    return (
        <div class="sheet-row head" aria-hidden="true">
            <span /><span>Name</span><span>Level</span><span>lm</span><span>White</span>
        </div>
    );
}

export function SheetRow({ row, index, count }: { row: Row; index: number; count: number }) {
    const own = listed(row, index, count);
    if (!own) return null;
    const { lamp, entry } = own;
    return (
        <div class={`sheet-row ${own.state}`} {...own.frame}>
            <Power of={own} />
            <button class="row-name" aria-pressed={own.selected} title={lamp ? cost(lamp) : undefined} onClick={(e) => pickRow(e, row.kind, row.id)} onDblClick={() => act('frame')}>
                <span>{entry.name}</span>
            </button>
            <LevelField of={own} label="level" />
            <span class="lumens">{three(own.lumens)}</span>
            {lamp ? (
                <button class="tint" aria-label={`${entry.name} colour: ${colorText(lamp)}`} onClick={() => select('lamp', row.id)}>
                    <i class="swatch" style={{ background: css(lamp.swatch) }} />{colorText(lamp)}
                </button>
            ) : <span />}
        </div>
    );
}
