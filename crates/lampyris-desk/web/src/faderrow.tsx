// A lamp or a group as a fader: on, name, solo, colour; under them the fader, per cent and lumens.

import { useRef } from 'preact/hooks';
import { Fade, strokeLevel, toLevel, toTravel } from './levels';
import { fold, folded, pickRow, type Row } from './lamps';
import { cost, colorText, LevelField, listed, Power } from './row';
import { solo } from './store';
import { css } from './swatch';
import { format, percent, three } from './units';
import { penless } from './gesture';
import { Icon } from './icon';
import { Range } from './range';
import { soloLamps } from './highlight';

export function FaderRow({ row, index, count }: { row: Row; index: number; count: number }) {
    const fade = useRef<Fade | null>(null);
    const own = listed(row, index, count);
    if (!own) return null;
    const { lamp, group, entry, members, lumens } = own;
    const alone = members.length > 0 && members.every((id) => solo.value.includes(id));
    const over = (how: 'end' | 'cancel') => () => {
        fade.current?.[how]();
        fade.current = null;
    };
    return (
        <div class={`fader-row ${own.state}`} {...own.frame}>
            <Power of={own} />
            <div class="top">
                {group && (
                    <button class="icon fold" aria-expanded={!folded.value.has(row.id)} aria-label={`Members of ${entry.name}`} onClick={() => fold(row.id)}>
                        <Icon name={folded.value.has(row.id) ? 'right' : 'down'} />
                    </button>
                )}
                <button class="row-name" aria-pressed={own.selected} title={lamp ? `${lamp.name}: ${cost(lamp)}` : entry.name} onClick={(e) => pickRow(e, row.kind, row.id)}>
                    <span>{entry.name}</span>
                    {group && <small>{members.length}</small>}
                    {lamp?.parked && <small>parked</small>}
                    {lamp && !lamp.free && <small class="traced" title={cost(lamp)}>↻<span class="spoken">re-trace</span></small>}
                </button>
                {lamp && <span class="tint"><i class="swatch" style={{ background: css(lamp.swatch) }} />{colorText(lamp)}</span>}
                <button class="icon solo" tabIndex={own.stop} aria-pressed={alone} aria-label={`Solo ${entry.name}`} title="Solo (I)" onClick={() => soloLamps(members)}>
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
                    disabled={penless.value !== null}
                    on={(t) => {
                        const level = toLevel(t);
                        if (fade.current) fade.current.to(level);
                        else strokeLevel(row, level);
                    }}
                    reset={() => strokeLevel(row, 1)}
                    begin={() => (fade.current = new Fade(row))}
                    end={over('end')}
                    cancel={over('cancel')}
                />
                <LevelField of={own} label="level, typed" tabIndex={own.stop} />
                <span class="lumens">{format(lumens, 'flux')}</span>
            </div>
        </div>
    );
}
