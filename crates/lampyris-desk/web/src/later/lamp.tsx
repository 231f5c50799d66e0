// The inspector of lamps: light, beam, place, what is done with them.

import {
    act, chosenLamps, dot, edit, format, groups, handles, Icon, lamps, layers, lumensOf, normal, output, percent, positionOf,
    selection, signal, spot, sub, titleOf, tool, toLevel, toTravel, typeLevel, up, Fade, Field, wantLevel, compass,
    add, scale, length, Range, strokeLevel, typeGroupLevel, useRef, type Lamp, type Place, type Strip, type Vec,
} from '../desk';
import { copyAlong, placed, positions } from './tools';
import { ColorPart } from './color';
import { whyNotGroup, whyNotUngroup } from './grouping';
import { changed, common, Line, Name, Section, Triple } from './parts';

const count = signal(1);
const offset = signal<Vec>([1, 0, 0]);
const STOPS: [number, string][] = [[-1, '−1'], [-1 / 3, '−⅓'], [1 / 3, '+⅓'], [1, '+1']];
const DEGREES = 180 / Math.PI;

/** Where a direction points: about the vertical from the plan's upward edge, and down from the level [degrees]. */
export function panTilt(direction: Vec, above: Vec): [number, number] {
    const { right, ahead } = compass(above);
    const down = -dot(direction, above);
    return [Math.atan2(dot(direction, right), dot(direction, ahead)) * DEGREES, Math.asin(Math.max(-1, Math.min(1, down))) * DEGREES];
}

export function fromPanTilt(pan: number, tilt: number, above: Vec): Vec {
    const { right, ahead } = compass(above);
    const [p, t] = [pan / DEGREES, tilt / DEGREES];
    const level = add(scale(right, Math.sin(p)), scale(ahead, Math.cos(p)));
    return normal(add(scale(level, Math.cos(t)), scale(above, -Math.sin(t))));
}

function Tools({ ids, all }: { ids: number[]; all: Lamp[] }) {
    const aimable = all.some((lamp) => lamp.place?.direction);
    const grouped = selection.value?.kind === 'group';
    return (
        <div class="tools" role="toolbar" aria-label="Lamps">
            <button aria-pressed={tool.value === 'aim'} aria-disabled={!aimable} title="Aim by pointing (T): then click what shall be lit" onClick={() => act('aim')}><Icon name="aim" />Aim</button>
            <button class="icon" aria-label="Solo" title="Solo (I)" onClick={() => act('solo')}><Icon name="solo" /></button>
            <button class="icon" aria-label="View from the lamp" title="View from the lamp (Shift+L)" aria-disabled={!aimable} onClick={() => act('from-lamp')}><Icon name="eye" /></button>
            <button class="icon" aria-label="Frame" title="Frame (F)" onClick={() => act('frame')}><Icon name="frame" /></button>
            <span class="gap" />
            {whyNotGroup() === null && <button title="Group (Ctrl+G): one master for all of them" onClick={() => act('group')}>Group</button>}
            {whyNotUngroup() === null && (
                <button title={grouped ? 'Dissolve the group (Ctrl+Shift+G): its lamps stay' : 'Take out of the group (Ctrl+Shift+G)'} onClick={() => act('ungroup')}>
                    {grouped ? 'Dissolve' : 'Take out'}
                </button>
            )}
            <button title="Off, and not traced (Shift+O)" aria-pressed={all.every((lamp) => lamp.parked)} onClick={() => act('park')}>Park</button>
            <button class="icon" aria-label={`Remove ${titleOf(ids)}`} title="Remove (Del)" onClick={() => act('remove')}><Icon name="bin" /></button>
        </div>
    );
}

function LightPart({ ids, all }: { ids: number[]; all: Lamp[] }) {
    const level = common(all.map((lamp) => lamp.level));
    const sum = lumensOf(ids);
    const free = all.every((lamp) => lamp.free);
    const lead = ids[ids.length - 1];
    return (
        <Section title="Light" note={free ? 're-mix' : 're-trace'}>
            <div class="line slide">
                <span>Level</span>
                <LevelSlide id={lead} />
            </div>
            <label class="line">
                <span />
                <Field
                    label="Level of the selection"
                    quantity="level"
                    value={level}
                    flux={common(all.map((lamp) => lamp.flux)) ?? undefined}
                    step={0.01}
                    set={(apply) => typeLevel(ids, apply)}
                    open={wantLevel.value}
                    opened={() => (wantLevel.value = '')}
                    id="level"
                />
            </label>
            <Line
                label="Flux"
                quantity="flux"
                value={ids.length === 1 ? all[0].flux * all[0].level : null}
                set={(apply) => typeLevel(ids, (old, flux) => apply(old * flux) / flux)}
            />
            <div class="line">
                <span>Stops</span>
                <div class="steps" role="group" aria-label="Level by stops">
                    {STOPS.map(([by, name]) => (
                        <button key={name} aria-label={`${name} stop`} onClick={() => typeLevel(ids, (old) => Math.min(1000, old * 2 ** by))}>{name}</button>
                    ))}
                </div>
            </div>
            <p class="sum">
                {format(sum, 'flux')} now
                {ids.length > 1 ? `, all ${ids.length} together` : ''}
                {all.length === 1 && all[0].group !== null && (groups.get(all[0].group)?.level ?? 1) !== 1 && ` (${percent(all[0].level)} % × ${percent(groups.get(all[0].group)?.level ?? 1)} % of the group)`}
            </p>
            <ColorPart />
        </Section>
    );
}

function LevelSlide({ id }: { id: number }) {
    const fade = useRef<Fade | null>(null);
    const lamp = lamps.get(id);
    if (!lamp) return null;
    const strip: Strip = { kind: 'lamp', id };
    const over = (how: 'end' | 'cancel') => () => {
        fade.current?.[how]();
        fade.current = null;
    };
    return (
        <Range
            label="Level"
            value={toTravel(lamp.level)}
            text={`${percent(lamp.level)} %, ${format(lamp.flux * output(lamp), 'flux')}`}
            begin={() => (fade.current = new Fade(strip))}
            on={(t) => (fade.current ? fade.current.to(toLevel(t)) : strokeLevel(strip, toLevel(t)))}
            end={over('end')}
            cancel={over('cancel')}
            reset={() => strokeLevel(strip, 1)}
        />
    );
}

/** Sets fields of each lamp's place. */
function setPlace(ids: number[], label: string, change: (place: Place, lamp: Lamp) => Place | null): void {
    const patch: Record<string, unknown> = {};
    for (const id of ids) {
        const lamp = lamps.get(id) as Lamp;
        const place = change(lamp.place ?? {}, lamp);
        if (place) patch[id] = { place };
    }
    if (Object.keys(patch).length) edit(`${titleOf(ids)}: ${label}`, { lamps: patch });
}

function BeamPart({ ids, all }: { ids: number[]; all: Lamp[] }) {
    const value = (field: 'inner' | 'outer' | 'radius') => common(all.map((lamp) => lamp.place?.[field] ?? null));
    const has = (field: 'inner' | 'outer' | 'radius') => all.some((lamp) => lamp.place?.[field] != null);
    if (!has('outer') && !has('radius')) return null;
    return (
        <Section title="Beam" note="re-trace">
            {has('outer') && (
                <>
                    <Line label="Full to" quantity="angle" step={1} value={value('inner')} set={(apply) => setPlace(ids, 'beam', (p) => (p.outer == null ? null : { inner: Math.max(0.1, Math.min(p.outer, apply(p.inner ?? p.outer))) }))} />
                    <Line label="Ends at" quantity="angle" step={1} value={value('outer')} set={(apply) => setPlace(ids, 'beam', (p) => {
                        if (p.outer == null) return null;
                        const outer = Math.max(0.2, Math.min(179, apply(p.outer)));
                        return { outer, inner: Math.min(p.inner ?? outer, outer) };
                    })} />
                </>
            )}
            {has('radius') && (
                <Line label="Radius" quantity="length" step={0.01} value={value('radius')} set={(apply) => setPlace(ids, 'radius', (p) => (p.radius == null ? null : { radius: Math.max(0.001, apply(p.radius)) }))} />
            )}
        </Section>
    );
}

function PlacePart({ ids, all }: { ids: number[]; all: Lamp[] }) {
    const movable = all.filter((lamp) => positionOf(lamp) !== null);
    if (!movable.length) return null;
    const at = movable.map((lamp) => positionOf(lamp) as Vec);
    const axis = (k: number, list: Vec[]) => common(list.map((v) => Math.round(v[k] * 1e4) / 1e4));
    const aimed = all.filter((lamp) => lamp.place?.direction);
    const above = up.value;
    const angles = aimed.map((lamp) => panTilt(lamp.place?.direction as Vec, above).map((v) => Math.round(v * 10) / 10) as [number, number]);
    const aims = all.map((lamp) => lamp.place?.aim).filter((aim): aim is Vec => !!aim);
    const move = (k: number, apply: (old: number) => number) => {
        const from = positions(ids);
        const patch: Record<string, unknown> = {};
        for (const [id, position] of from) {
            const by: Vec = [0, 0, 0];
            by[k] = apply(position[k]) - position[k];
            Object.assign(patch, placed([id], by, from).lamps as object);
        }
        edit(`Move ${titleOf(ids)}`, { lamps: patch });
    };
    const turnTo = (k: 0 | 1, apply: (old: number) => number) => setPlace(ids, k ? 'tilt' : 'pan', (p) => {
        if (!p.direction) return null;
        const now = panTilt(p.direction, above);
        now[k] = apply(now[k]);
        const direction = fromPanTilt(now[0], Math.max(-90, Math.min(90, now[1])), above);
        // What it aims at swings round with it, and stays as far away.
        const far = p.aim && p.position ? length(sub(p.aim, p.position)) : 0;
        return { direction, ...(far && p.position ? { aim: add(p.position, scale(direction, far)) } : {}) };
    });
    return (
        <Section title="Place" note="re-trace">
            <Triple label="Position" quantity="length" step={0.01} value={[0, 1, 2].map((k) => axis(k, at))} set={move} />
            {aimed.length > 0 && (
                <>
                    <Line label="Pan" quantity="angle" step={1} value={common(angles.map((a) => a[0]))} set={(apply) => turnTo(0, apply)} />
                    <Line label="Tilt" quantity="angle" step={1} value={common(angles.map((a) => a[1]))} set={(apply) => turnTo(1, apply)} />
                    <Triple
                        label="Aims at"
                        quantity="length"
                        step={0.01}
                        value={aims.length ? [0, 1, 2].map((k) => axis(k, aims)) : [NaN, NaN, NaN]}
                        set={(k, apply) => setPlace(ids, 'aim', (p) => {
                            if (!p.direction || !p.position) return null;
                            const aim = changed(p.aim ?? add(p.position, scale(p.direction, 2)), k, apply);
                            return { aim, direction: normal(sub(aim, p.position)) };
                        })}
                    />
                </>
            )}
            <div class="line">
                <span>Handles</span>
                <div class="segments" role="group" aria-label="Handles">
                    <button aria-pressed={handles.value === 'move'} onClick={() => (handles.value = 'move')}>Move</button>
                    <button aria-pressed={handles.value === 'turn'} onClick={() => (handles.value = 'turn')}>Turn</button>
                </div>
            </div>
            <button class="plain full" aria-pressed={tool.value === 'place'} onClick={() => act('place')}>Put on a surface by pointing</button>
            {aimed.length > 0 && spot.value && (
                <button class="plain full" onClick={() => act('aim-here')}>Aim at the last point</button>
            )}
        </Section>
    );
}

function CopyPart({ ids, all }: { ids: number[]; all: Lamp[] }) {
    if (all.some((lamp) => lamp.kind === 'surface' || lamp.kind === 'sky')) return null;
    return (
        <Section title="Copies along a line">
            <Line label="How many" quantity="number" step={1} value={count.value} set={(apply) => (count.value = Math.max(1, Math.min(100, Math.round(apply(count.value)))))} />
            <Triple label="Step" quantity="length" step={0.05} value={offset.value} set={(k, apply) => (offset.value = changed(offset.value, k, apply))} />
            <button class="plain full" onClick={() => copyAlong(ids, count.value, offset.value)}>
                <Icon name="copy" />{count.value === 1 ? 'One copy' : `${count.value} copies`}
            </button>
        </Section>
    );
}

export function LampInspector() {
    const ids = chosenLamps.value;
    const all = ids.map((id) => lamps.get(id)).filter((lamp): lamp is Lamp => !!lamp);
    if (!all.length) return <p class="quiet empty">This lamp is gone.</p>;
    const one = all.length === 1 ? all[0] : null;
    const group = one && groups.get(one.group);
    const now = selection.value;
    const asGroup = now?.kind === 'group' && now.ids.length === 1 ? groups.get(now.ids[0]) : undefined;
    const layer = one?.layer != null ? layers.value[one.layer] : undefined;
    return (
        <>
            <header class="panel-head">
                {asGroup && now ? <Name label="Name of the group" value={asGroup.name} set={(name) => edit(`Rename ${asGroup.name}`, { groups: { [now.ids[0]]: { name } } })} />
                    : one ? <Name label="Name of the lamp" value={one.name} set={(name) => edit(`Rename ${one.name}`, { lamps: { [ids[0]]: { name } } })} />
                        : <h2>{all.length} lamps</h2>}
            </header>
            <p class="crumbs">
                {one ? `${one.kind}${group && group.lamps.length > 1 ? ` ▸ ${group.name}` : ''}${layer ? ` ▸ ${layer.name}` : ''}` : `${all.filter((l) => l.on).length} of ${all.length} on`}
            </p>
            <div class="scroll">
                <Tools ids={ids} all={all} />
                {asGroup && now && (
                    <Section title="Group" note="re-mix">
                        <Line label="Master" name="Master of the group" quantity="level" step={0.01} value={asGroup.level} set={(apply) => typeGroupLevel(now.ids[0], apply)} />
                    </Section>
                )}
                <LightPart ids={ids} all={all} />
                <Section title="Photometry">
                    <button class="plain full" disabled title="Photometric files (IES, LDT) come with a later version">IES or LDT file… comes later</button>
                </Section>
                <BeamPart ids={ids} all={all} />
                <PlacePart ids={ids} all={all} />
                <CopyPart ids={ids} all={all} />
                <p class="cost">{all.every((l) => l.free) ? 'Level and colour are a re-mix: no ray. Place and beam are traced anew.' : 'Some of these share no layer of their own: their level is traced anew.'}</p>
            </div>
        </>
    );
}

