// A lamp or a group as a fader: on, name, solo, colour; under them the fader, per cent and lumens.

import { useRef } from 'preact/hooks';
import { Fade, strokeLevel, switchOn, toLevel, toTravel, typeGroupLevel, typeLevel, type Strip } from './levels';
import { fold, folded, pickRow, type Row } from './lamps';
import { chosenLamps, hovered, selection } from './select';
import { groups, lamps, lumensOf, solo } from './store';
import type { Lamp } from './types';
import { css } from './swatch';
import { digits, format, percent, three } from './units';
import { Field } from './field';
import { penless } from './gesture';
import { Icon } from './icon';
import { Range } from './range';
import { soloLamps } from './highlight';

/** The colour of a lamp in a word. */
export function colorText(lamp: Lamp): string {
    const c = lamp.color;
    if (c.mode === 'kelvin') return `${digits(c.kelvin)} K`;
    return c.mode === 'rgb' ? 'RGB' : c.mode === 'xy' ? 'x y' : 'file';
}

export const cost = (lamp: Lamp): string =>
    lamp.free ? 're-mix: level and colour cost no ray' : 're-trace: its light is traced anew';

export function FaderRow({ row, index, count }: { row: Row; index: number; count: number }) {
    const fade = useRef<Fade | null>(null);
    const strip: Strip = { kind: row.kind, id: row.id };
    const lamp = row.kind === 'lamp' ? lamps.get(row.id) : undefined;
    const group = row.kind === 'group' ? groups.get(row.id) : undefined;
    const entry = lamp ?? group;
    if (!entry) return null;
    const members = group?.lamps ?? [row.id];
    const flux = lamp ? lamp.flux : members.reduce((sum, id) => sum + (lamps.get(id)?.flux ?? 0) * (lamps.get(id)?.level ?? 0), 0);
    const lumens = lumensOf(members);
    const selected = selection.value?.kind === row.kind && selection.value.ids.includes(row.id);
    const alone = members.length > 0 && members.every((id) => solo.value.includes(id));
    const muted = solo.value.length > 0 && !members.some((id) => solo.value.includes(id));
    const over = hovered.value?.kind === row.kind && hovered.value.id === row.id;
    const state = `${selected ? 'selected' : ''} ${entry.on && !lamp?.parked ? '' : 'off'} ${muted ? 'muted' : ''} ${over ? 'under' : ''}`;
    const locked = penless.value;
    // By Tab one comes to the name and the fader of each row, and to the rest of it once it is selected.
    const stop = selected ? 0 : -1;
    const drag = {
        begin: () => (fade.current = new Fade(strip)),
        end: () => {
            fade.current?.end();
            fade.current = null;
        },
        cancel: () => {
            fade.current?.cancel();
            fade.current = null;
        },
    };
    return (
        <div
            class={`fader-row depth-${row.depth} ${row.kind} ${state}`}
            role="listitem"
            aria-setsize={count}
            aria-posinset={index + 1}
            data-row={`${row.kind}-${row.id}`}
            onPointerEnter={() => (hovered.value = { kind: row.kind, id: row.id })}
            onPointerLeave={() => (hovered.value = null)}
        >
            <button class="icon power" tabIndex={stop} aria-pressed={entry.on} disabled={locked !== null} aria-label={`${entry.name} on`} title={locked ?? (entry.on ? 'On (O)' : 'Off (O)')} onClick={() => switchOn(strip, !entry.on)}>
                <Icon name="power" />
            </button>
            <div class="top">
                {group && (
                    <button class="icon fold" aria-expanded={!folded.value.has(row.id)} aria-label={`Members of ${entry.name}`} onClick={() => fold(row.id)}>
                        <Icon name={folded.value.has(row.id) ? 'right' : 'down'} />
                    </button>
                )}
                <button class="row-name" aria-pressed={selected} title={lamp ? `${lamp.name}: ${cost(lamp)}` : entry.name} onClick={(e) => pickRow(e, row.kind, row.id)}>
                    <span>{entry.name}</span>
                    {group && <small>{members.length}</small>}
                    {lamp?.parked && <small>parked</small>}
                    {lamp && !lamp.free && <small class="traced" title={cost(lamp)}>↻<span class="spoken">re-trace</span></small>}
                </button>
                {lamp && <span class="tint"><i class="swatch" style={{ background: css(lamp.swatch) }} />{colorText(lamp)}</span>}
                <button class="icon solo" tabIndex={stop} aria-pressed={alone} aria-label={`Solo ${entry.name}`} title="Solo (I)" onClick={() => soloLamps(members)}>
                    <Icon name="solo" />
                </button>
            </div>
            <div class="bottom">
                <Range
                    label={`${entry.name} level`}
                    class="level"
                    value={toTravel(entry.level)}
                    text={`${percent(entry.level)} %, ${three(lumens)} lumen`}
                    notch={0.01}
                disabled={locked !== null}
                    on={(t) => {
                        const level = toLevel(t);
                        if (fade.current) fade.current.to(level);
                        else strokeLevel(strip, level);
                    }}
                    reset={() => strokeLevel(strip, 1)}
                    {...drag}
                />
                <Field
                    label={`${entry.name} level, typed`}
                    quantity="level"
                    value={entry.level}
                    flux={flux}
                    step={0.01}
                    disabled={locked !== null}
                    why={locked}
                    tabIndex={stop}
                    set={(apply) => (lamp ? typeLevel(selected && chosenLamps.peek().length > 1 ? chosenLamps.peek() : [row.id], apply) : typeGroupLevel(row.id, apply))}
                />
                <span class="lumens">{format(lumens, 'flux')}</span>
            </div>
        </div>
    );
}
