// Inspectors of things and of what they are made of.

import {
    digits, edit, fromHex, hex, Icon, materials, middle, select, selection, things, type Material, type Thing, type Vec,
} from '../desk';
import { changed, common, Line, Section, Slide, Triple } from './parts';

const DEGREES = 180 / Math.PI;

/** The angle of a turn about the vertical that a quaternion is, as near as it is one [degrees]. */
export function turnOf(q: readonly number[] | null | undefined, axis: number): number {
    return q ? 2 * Math.atan2(q[axis], q[3]) * DEGREES : 0;
}

export function about(axis: number, angle: number): [number, number, number, number] {
    const q: [number, number, number, number] = [0, 0, 0, Math.cos(angle / DEGREES / 2)];
    q[axis] = Math.sin(angle / DEGREES / 2);
    return q;
}

export function ThingInspector() {
    const ids = (selection.value?.ids ?? []).filter((id) => things.get(id));
    const all = ids.map((id) => things.get(id) as Thing);
    if (!all.length) return <p class="quiet empty">This thing is gone.</p>;
    const one = all[0];
    const title = ids.length === 1 ? one.name : `${ids.length} things`;
    const locked = all.some((thing) => thing.locked);
    const set = (label: string, of: (thing: Thing) => object) =>
        edit(`${title}: ${label}`, { things: Object.fromEntries(ids.map((id, k) => [id, of(all[k])])) });
    const at = all.map((thing) => thing.place?.position ?? (thing.box ? middle(thing.box) : ([0, 0, 0] as Vec)));
    const size = one.box ? [0, 1, 2].map((k) => one.box![1][k] - one.box![0][k]) : null;
    return (
        <>
            <header class="panel-head"><h2>{title}</h2></header>
            {size && <p class="crumbs">{size.map((v) => digits(v, 2)).join(' × ')} m</p>}
            <div class="scroll">
                <div class="tools" role="toolbar" aria-label="Thing">
                    <button aria-pressed={all.every((thing) => thing.hidden)} onClick={() => set(one.hidden ? 'show' : 'hide', () => ({ hidden: !one.hidden }))}>
                        <Icon name={one.hidden ? 'eye-off' : 'eye'} />{one.hidden ? 'Hidden' : 'Hide'}
                    </button>
                    <button aria-pressed={locked} onClick={() => set(locked ? 'unlock' : 'lock', () => ({ locked: !locked }))}>
                        <Icon name={locked ? 'lock' : 'unlock'} />{locked ? 'Locked' : 'Lock'}
                    </button>
                </div>
                <Section title="Place" note="re-trace">
                    {locked && <p class="quiet">Locked, as all that the file brings. Unlock it to move it.</p>}
                    <Triple
                        label="Position"
                        quantity="length"
                        step={0.01}
                        disabled={locked}
                        value={[0, 1, 2].map((k) => common(at.map((p) => Math.round(p[k] * 1e4) / 1e4)))}
                        set={(axis, apply) => set('move', (thing) => ({ place: { position: changed(thing.place?.position ?? middle(thing.box as [Vec, Vec]), axis, apply) } }))}
                    />
                    {[0, 1, 2].map((axis) => (
                        <Line
                            key={axis}
                            label={`Turn ${'XYZ'[axis]}`}
                            quantity="angle"
                            step={5}
                            disabled={locked}
                            value={common(all.map((thing) => Math.round(turnOf(thing.place?.rotation, axis) * 10) / 10))}
                            set={(apply) => set('turn', (thing) => ({ place: { rotation: about(axis, apply(turnOf(thing.place?.rotation, axis))) } }))}
                        />
                    ))}
                    <Line
                        label="Scale"
                        quantity="number"
                        step={0.05}
                        disabled={locked}
                        value={common(all.map((thing) => thing.place?.scale ?? 1))}
                        set={(apply) => set('scale', (thing) => ({ place: { scale: Math.max(0.001, apply(thing.place?.scale ?? 1)) } }))}
                    />
                </Section>
                <Section title="Materials">
                    <ul class="buttons">
                        {one.materials.map((id) => (
                            <li key={id}><button onClick={() => select('material', id)}>{materials.get(id)?.name ?? `material ${id}`}</button></li>
                        ))}
                    </ul>
                </Section>
            </div>
        </>
    );
}

export function MaterialInspector() {
    const id = selection.value?.ids[0] as number;
    const m = materials.get(id);
    if (!m) return <p class="quiet empty">This material is gone.</p>;
    const set = (label: string, fields: Partial<Material>) => edit(`${m.name}: ${label}`, { materials: { [id]: fields } });
    const tone = m.transmittance ? 'transmittance' : 'color';
    const color = (m.transmittance ?? m.color ?? [0.5, 0.5, 0.5]) as Vec;
    const luminance = (c: Vec) => 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    const rho = luminance(color);
    /** The same hue, of another reflectance; no channel beyond one. */
    const scaled = (to: number): Vec => color.map((v) => Math.max(0, Math.min(1, rho > 1e-4 ? (v / rho) * to : to))) as Vec;
    const share = (label: string, field: 'roughness' | 'specular') => m[field] != null && (
        <>
            <div class="line slide">
                <span>{label}</span>
                <Slide label={label} name={`${m.name}: ${label.toLowerCase()}`} value={m[field] as number} text={digits(m[field] as number, 2)} patch={(t) => ({ materials: { [id]: { [field]: Math.round(t * 1000) / 1000 } } })} />
            </div>
            <Line label="" name={`${label}, typed`} quantity="share" step={0.01} value={m[field] as number} set={(apply) => set(label.toLowerCase(), { [field]: Math.max(0, Math.min(1, apply(m[field] as number))) })} />
        </>
    );
    return (
        <>
            <header class="panel-head"><h2>{m.name}</h2></header>
            <p class="crumbs">{m.kind}</p>
            <div class="scroll">
                <Section title={m.transmittance ? 'What passes' : 'What is sent back'} note="re-trace">
                    <div class="line slide">
                        <span>{m.transmittance ? 'Transmittance' : 'Reflectance'}</span>
                        <Slide label={m.transmittance ? 'Transmittance' : 'Reflectance'} name={`${m.name}: ${m.transmittance ? 'transmittance' : 'reflectance'}`} value={rho} text={digits(rho, 2)} patch={(t) => ({ materials: { [id]: { [tone]: scaled(Math.min(0.95, t)) } } })} />
                    </div>
                    <Line label="" name="Reflectance, typed" quantity="share" step={0.01} value={Math.round(rho * 1e3) / 1e3} set={(apply) => set('reflectance', { [tone]: scaled(Math.min(0.98, apply(rho))) })} />
                    <label class="line">
                        <span>Colour</span>
                        <input type="color" class="pick" aria-label="Colour" value={hex(color)} onChange={(e) => set('colour', { [tone]: fromHex(e.currentTarget.value) })} />
                    </label>
                    {share('Roughness', 'roughness')}
                    {share('Gloss', 'specular')}
                </Section>
                <Section title="On">
                    <ul class="buttons">
                        {things.all().filter(([, thing]) => thing.materials.includes(id)).slice(0, 40).map(([thing, own]) => (
                            <li key={thing}><button onClick={() => select('thing', thing)}>{own.name}</button></li>
                        ))}
                    </ul>
                </Section>
            </div>
        </>
    );
}
