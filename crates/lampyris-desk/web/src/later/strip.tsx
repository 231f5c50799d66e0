// The strip under the view: looks, and what meters and grids say.

import {
    act, command, digits, display, fade, Field, grids, Icon, looks, luxText, maintained, maintenance, meters, select, selection, show,
    signal, signed, storeLook,
} from '../desk';
import { difference } from './differ';
import { most } from './most';
import { saveCsv } from './csv';
import { gridIsPoor, gridVerdict, Mark, meterIsPoor, meterVerdict } from './figures';

const tab = signal<'looks' | 'meters'>('looks');

function Looks() {
    return (
        <section class="looks" aria-label="Looks">
            <header>
                <h2>Looks</h2>
                <button class="tab" onClick={() => (tab.value = 'meters')}>Meters</button>
                <button class="icon" aria-label="Store a look" title="Store a look (Ctrl+Enter)" onClick={storeLook}><Icon name="plus" /></button>
                <span class="gap" />
                <label class="tint">
                    Fade
                    <Field label="Cross-fade" quantity="seconds" value={fade.value} step={0.5} set={(apply) => (fade.value = Math.max(0, apply(fade.value)))} />
                </label>
            </header>
            <ul>
                {looks.all().map(([id, look], k) => (
                    <li class="look" key={id}>
                        <button class="recall" title={`${look.name}: recall (J ${k + 1})`} onClick={() => command({ do: 'look', id, what: 'recall', seconds: fade.peek() })}>
                            {look.picture && <img src={look.picture} alt={look.name} width={96} height={72} />}
                            <span aria-hidden={look.picture ? 'true' : undefined}>{look.name}</span>
                        </button>
                        <LookMenu id={id} name={look.name} />
                    </li>
                ))}
                {!looks.ids.value.length && <li class="quiet">Levels, colours, on and off, kept under a name: + stores what is set now.</li>}
            </ul>
        </section>
    );
}

function LookMenu({ id, name }: { id: number; name: string }) {
    const menu = `look-${id}`;
    const place = (button: HTMLElement) => {
        const box = button.getBoundingClientRect();
        const sheet = document.getElementById(menu);
        sheet?.style.setProperty('left', `${Math.min(box.left, innerWidth - 296)}px`);
        sheet?.style.setProperty('bottom', `${innerHeight - box.top + 4}px`);
        sheet?.style.setProperty('top', 'auto');
    };
    const compared = display.value.false_color?.against === id;
    const attributes = { popovertarget: menu } as Record<string, string>;
    const close = () => document.getElementById(menu)?.hidePopover();
    const give = (what: string, more: Record<string, unknown> = {}) => {
        close();
        command({ do: 'look', id, what, ...more });
    };
    return (
        <>
            <button class="icon more" {...attributes} aria-label={`More of ${name}`} onPointerDown={(e) => place(e.currentTarget)} onFocus={(e) => place(e.currentTarget)}>
                <Icon name="more" />
            </button>
            <div id={menu} popover="auto" class="menu">
                <label class="line">
                    <span>Name</span>
                    <span class="field">
                        <input type="text" aria-label="Name of the look" value={name} onChange={(e) => give('rename', { name: e.currentTarget.value })} />
                    </span>
                </label>
                <button class="item" onClick={() => give('update')}><span>Update to what is set now</span></button>
                <button class="item" onClick={() => give('recall', { seconds: 0 })}><span>Recall at once</span></button>
                <button
                    class="item"
                    onClick={() => {
                        close();
                        show({ false_color: compared ? null : difference(id) });
                    }}
                >
                    <span>{compared ? 'End the difference' : 'Difference to now'}</span>
                </button>
                <button class="item" onClick={() => give('remove')}><span>Remove</span></button>
            </div>
        </>
    );
}

/** By how much a reading is more than in the look that is compared with. */
const change = (by: number | null | undefined, kept: number) => (by == null ? '' : ` · Δ ${signed(by * kept)}`);

function Readings() {
    const kept = maintenance.value;
    return (
        <section class="readings" aria-label="Meters and grids">
            <header>
                <h2>Meters</h2>
                <button class="tab" onClick={() => (tab.value = 'looks')}>Looks</button>
                <button class="icon" aria-label="Lay a meter" title="Lay a meter by pointing" onClick={() => act('meter-tool')}><Icon name="meter" /></button>
                <button class="icon" aria-label="Lay a grid" title="Lay a grid by two corners" onClick={() => act('grid')}><Icon name="grid" /></button>
                <button onClick={() => act('reach')} title="Set levels so that meters and areas come nearest to their targets">Reach targets</button>
                <label class="tint" title="How high levels may be set, of each lamp's flux">
                    up to
                    <Field label="Highest level to reach targets" quantity="level" value={most.value} step={0.1} set={(apply) => (most.value = Math.min(10, Math.max(1, apply(most.value))))} />
                </label>
                <button onClick={saveCsv} title="Save all figures as CSV">CSV</button>
                <span class="gap" />
                <span class="quiet">{kept === 1 ? 'new installation' : `× ${digits(kept, 2)} maintained`}</span>
            </header>
            <ul>
                {meters.all().map(([id, meter]) => {
                    const lux = meter.lux;
                    return (
                        <li key={`m${id}`}>
                            <button class="reading" aria-pressed={selection.value?.kind === 'meter' && selection.value.ids.includes(id)} onClick={() => select('meter', id)}>
                                <span class="tint"><Icon name="meter" />{meter.name} <Mark of={meterVerdict(meter)} /></span>
                                <strong class={meterIsPoor(meter) ? 'unsettled' : ''}>{lux ? maintained(lux[0]) : '…'}</strong>
                                <small>
                                    {lux?.[1] != null ? `±${maintained(lux[1], false)}` : 'measuring'} {meter.kind}
                                    {change(meter.change, kept)}
                                    {meter.target ? ` · wants ${luxText(meter.target)}` : ''}
                                </small>
                            </button>
                        </li>
                    );
                })}
                {grids.all().map(([id, grid]) => {
                    const target = grid.target;
                    return (
                        <li key={`g${id}`}>
                            <button class="reading" aria-pressed={selection.value?.kind === 'grid' && selection.value.ids.includes(id)} onClick={() => select('grid', id)}>
                                <span class="tint"><Icon name="grid" />{grid.name} <Mark of={gridVerdict(grid)} /></span>
                                <strong class={gridIsPoor(grid) ? 'unsettled' : ''}>
                                    {grid.mean == null ? '…' : `Ē ${maintained(grid.mean)}${grid.error == null ? '' : ` ±${maintained(grid.error, false)}`}`}
                                </strong>
                                <small>
                                    U₀ {grid.uniformity == null ? '…' : digits(grid.uniformity, 2)} · {grid.min == null ? '…' : maintained(grid.min, false)} to{' '}
                                    {grid.max == null ? '…' : maintained(grid.max, false)}
                                    {change(grid.change, kept)}
                                    {target ? ` · wants ${luxText(target.lux)}, U₀ ${digits(target.uniformity, 2)}` : ''}
                                </small>
                            </button>
                        </li>
                    );
                })}
                {!meters.ids.value.length && !grids.ids.value.length && <li class="quiet">P lays a meter under the pointer.</li>}
            </ul>
        </section>
    );
}

export function Strip() {
    return (
        <div class="strip-parts" data-tab={tab.value}>
            <Looks />
            <Readings />
        </div>
    );
}

