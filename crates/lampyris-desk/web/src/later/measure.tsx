// Inspectors of meters and grids. Both are kept whole, so that an edit sends all that they are but their figures.

import {
    add, deselect, digits, dot, edit, grids, Icon, length, maintained, maintenance, meters, scale, selection, up, type Grid, type Meter,
} from '../desk';
import { gridIsPoor, gridVerdict, meterIsPoor, meterVerdict, Said } from './figures';
import { counts, floorLevel, inner } from './area';
import { changed, Line, Name, Section, Triple } from './parts';

const KINDS: [Meter['kind'], string][] = [['surface', 'on the surface'], ['horizontal', 'horizontal'], ['vertical', 'vertical'], ['cylindrical', 'cylindrical'], ['camera', 'toward the camera']];

export function MeterInspector() {
    const id = selection.value?.ids[0] as number;
    const meter = meters.get(id);
    if (!meter) return <p class="quiet empty">This meter is gone.</p>;
    const set = (label: string, change: Partial<Meter>) => {
        const { lux: _, done: __, ...kept } = { ...meter, ...change };
        edit(`${meter.name}: ${label}`, { meters: { [id]: kept } });
    };
    return (
        <>
            <header class="panel-head"><Name label="Name of the meter" value={meter.name} set={(name) => set('rename', { name })} /></header>
            <p class={`crumbs ${meterIsPoor(meter) ? 'unsettled' : 'known'}`}>{meter.lux?.[1] != null ? `${maintained(meter.lux[0])} ±${maintained(meter.lux[1], false)}` : 'measuring'}</p>
            <div class="scroll">
                <Section title="Meter">
                    <label class="line">
                        <span>Measures</span>
                        <select aria-label="Kind of the meter" value={meter.kind} onChange={(e) => set('kind', { kind: e.currentTarget.value as Meter['kind'] })}>
                            {KINDS.map(([kind, name]) => <option key={kind} value={kind}>{name}</option>)}
                        </select>
                    </label>
                    <Triple label="Point" quantity="length" step={0.01} value={meter.point} set={(axis, apply) => set('move', { point: changed(meter.point, axis, apply) })} />
                    <Line label="At least" quantity="lux" step={50} value={meter.target ?? 0} set={(apply) => set('target', { target: apply(meter.target ?? 0) || null })} />
                    <Said of={meterVerdict(meter)} />
                    <Triple label="Faces" quantity="number" step={0.1} value={meter.normal.map((v) => Math.round(v * 1e3) / 1e3)} set={(axis, apply) => set('turn', { normal: changed(meter.normal, axis, apply) })} />
                    <button class="plain full" onClick={() => {
                        deselect();
                        edit(`Remove ${meter.name}`, { meters: { [id]: null } });
                    }}><Icon name="bin" />Remove</button>
                </Section>
            </div>
        </>
    );
}

/** Classes of EN 12464-1 that are asked for most. */
const CLASSES: [string, number, number][] = [['corridor', 100, 0.4], ['stairs', 150, 0.4], ['filing', 300, 0.4], ['writing, reading', 500, 0.6], ['drawing', 750, 0.7]];

export function GridInspector() {
    const id = selection.value?.ids[0] as number;
    const grid = grids.get(id);
    if (!grid) return <p class="quiet empty">This grid is gone.</p>;
    const kept = maintenance.value;
    const set = (label: string, change: Partial<Grid>) => {
        const { name, corner, u, v, normal, columns, rows, border, target } = { ...grid, ...change };
        edit(`${grid.name}: ${label}`, { grids: { [id]: { name, corner, u, v, normal, columns, rows, border, target } } });
    };
    const standard = (label: string, border = grid.border) => {
        const [columns, rows] = counts([inner(length(grid.u), border), inner(length(grid.v), border)]);
        set(label, { columns, rows, border });
    };
    const height = dot(grid.corner, up.value) - floorLevel();
    const figure = (name: string, value: number | null | undefined, text: (v: number) => string) => <><dt>{name}</dt><dd>{value == null ? '…' : text(value)}</dd></>;
    const off = (value: number | null | undefined, text: (v: number) => string) => (value == null ? '' : ` ±${text(value)}`);
    const target = grid.target ?? { lux: 500, uniformity: 0.6 };
    return (
        <>
            <header class="panel-head"><Name label="Name of the grid" value={grid.name} set={(name) => set('rename', { name })} /></header>
            <p class="crumbs">{digits(length(grid.u), 2)} × {digits(length(grid.v), 2)} m, {digits(grid.columns * grid.rows)} points</p>
            <div class="scroll">
                <Section title="Figures" note={kept === 1 ? 'new' : `× ${digits(kept, 2)}`}>
                    <dl class={`figures ${gridIsPoor(grid) ? 'unsettled' : ''}`}>
                        {figure('Ē', grid.mean, (v) => maintained(v) + off(grid.error, (e) => maintained(e, false)))}
                        {figure('E min', grid.min, (v) => maintained(v))}
                        {figure('E max', grid.max, (v) => maintained(v))}
                        {figure('U₀ = min / mean', grid.uniformity, (v) => digits(v, 2) + off(grid.uniformity_error, (e) => digits(e, 2)))}
                        {figure('U d = min / max', grid.max ? (grid.min ?? 0) / grid.max : null, (v) => digits(v, 2))}
                    </dl>
                </Section>
                <Section title="Target">
                    <Said of={gridVerdict(grid)} />
                    <label class="line">
                        <span>Class</span>
                        <select aria-label="Class of the target" value="" onChange={(e) => {
                            const found = CLASSES[Number(e.currentTarget.value)];
                            set('target', { target: found ? { lux: found[1], uniformity: found[2] } : null });
                        }}>
                            <option value="">{grid.target ? 'choose…' : 'none'}</option>
                            {CLASSES.map(([name, lux, u], k) => <option key={name} value={k}>{name}: {lux} lx, U₀ {u}</option>)}
                            <option value="-1">no target</option>
                        </select>
                    </label>
                    <Line label="Ē at least" quantity="lux" step={50} value={target.lux} set={(apply) => set('target', { target: { ...target, lux: apply(target.lux) } })} />
                    <Line label="U₀ at least" quantity="share" step={0.05} value={target.uniformity} set={(apply) => set('target', { target: { ...target, uniformity: apply(target.uniformity) } })} />
                </Section>
                <Section title="Area">
                    <Triple label="Corner" quantity="length" step={0.01} value={grid.corner} set={(axis, apply) => set('move', { corner: changed(grid.corner, axis, apply) })} />
                    <Line label="Height" name="Height above the floor" quantity="length" step={0.01} value={height} set={(apply) => set('height', { corner: add(grid.corner, scale(up.value, apply(height) - height)) })} />
                    <Line label="Border" quantity="length" step={0.05} value={grid.border ?? 0} set={(apply) => standard('border', Math.max(0, apply(grid.border ?? 0)))} />
                    <Line label="Columns" quantity="number" step={1} value={grid.columns} set={(apply) => set('spacing', { columns: Math.max(1, Math.min(200, Math.round(apply(grid.columns)))) })} />
                    <Line label="Rows" quantity="number" step={1} value={grid.rows} set={(apply) => set('spacing', { rows: Math.max(1, Math.min(200, Math.round(apply(grid.rows)))) })} />
                    <button class="plain full" title="EN 12464-1: p = 0.2 · 5^log d" onClick={() => standard('standard spacing')}>Spacing of the standard</button>
                    <button class="plain full" onClick={() => {
                        deselect();
                        edit(`Remove ${grid.name}`, { grids: { [id]: null } });
                    }}><Icon name="bin" />Remove</button>
                </Section>
            </div>
        </>
    );
}
