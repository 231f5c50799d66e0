// What tools do with the point that was clicked: aiming, laying a meter, spanning a grid, hanging a lamp; and what is done
// to the places of lamps.

import {
    add, adding, chosenLamps, distance, dot, edit, effect, free, grids, lamps, meters, normal, onTool, positionOf, say, scale,
    select, step, sub, titleOf, tool, untracked, up, workPlane,
    type Hit, type Id, type Kind, type LampKind, type Patch, type Slice, type Vec,
} from '../desk';
import { between, floorLevel } from './area';

let corner: Hit | null = null;

/** How long an answer may take on a busy machine [ms]. */
const PATIENCE = 30_000;

/** What desks ask for. */
const TARGET = { lux: 500, uniformity: 0.6 };

// A corner waits for the other as long as its tool is in the hand.
effect(() => {
    if (tool.value !== 'grid') corner = null;
});

function apply(hit: Hit | null): void {
    if (!hit) return say('There is nothing at that point.', 'warn');
    switch (tool.peek()) {
        case 'aim':
            aim(chosenLamps.peek(), hit.point);
            tool.value = null;
            break;
        case 'place':
            putOn(chosenLamps.peek(), hit);
            tool.value = null;
            break;
        case 'meter':
            addMeter(hit.point, hit.normal);
            tool.value = null;
            break;
        case 'grid':
            if (!corner) {
                corner = hit;
                return;
            }
            addGrid(corner, hit);
            corner = null;
            tool.value = null;
            break;
        case 'add':
            hang(adding.peek(), hit);
            tool.value = null;
            break;
    }
}

onTool(apply);

/** Turns lamps toward a point; those that shine everywhere stay as they are. */
export function aim(ids: Id[], point: Vec): void {
    const patch: Record<string, unknown> = {};
    for (const id of ids) {
        const place = lamps.get(id)?.place;
        if (!place?.position || !place.direction) continue;
        patch[id] = { place: { aim: point, direction: normal(sub(point, place.position)) } };
    }
    if (!Object.keys(patch).length) return say('What is selected shines into all directions: it cannot be aimed.', 'warn');
    edit(`Aim ${titleOf(ids)}`, { lamps: patch });
}

/** Selects the next entry that comes into a family. */
export function selectNext(slice: Slice<object>, kind: Kind): void {
    const before = new Set(slice.ids.peek());
    const stop = slice.ids.subscribe((ids) => {
        const fresh = ids.filter((id) => !before.has(id));
        if (!fresh.length) return;
        select(kind, fresh[fresh.length - 1]);
        queueMicrotask(() => stop());
    });
    setTimeout(() => stop(), PATIENCE);
}

/** Puts the last of some lamps on a surface, clear of it, and the others beside it as they were. */
function putOn(ids: Id[], hit: Hit): void {
    const from = positions(ids);
    const lead = from.get(ids[ids.length - 1]);
    if (!lead) return say('What is selected has no place.', 'warn');
    const clear = (lamps.get(ids[ids.length - 1])?.place?.radius ?? 0) + 0.02;
    edit(`Put ${titleOf(ids)} on a surface`, placed(ids, sub(add(hit.point, scale(hit.normal, clear)), lead), from));
}

export function addMeter(point: Vec, axis: Vec): void {
    const id = free(meters);
    selectNext(meters as unknown as Slice<object>, 'meter');
    edit('Lay a meter', { meters: { [id]: { name: `Meter ${id + 1}`, kind: 'surface', point, normal: axis } } });
}

/** An area between two corners that were pointed at. */
function addGrid(a: Hit, b: Hit): void {
    const area = between(a, b, up.peek(), untracked(floorLevel), workPlane.peek());
    if (!area) return say('An area needs two corners that lie apart.', 'warn');
    const id = free(grids);
    selectNext(grids as unknown as Slice<object>, 'grid');
    edit('Lay a grid', { grids: { [id]: { name: `Area ${id + 1}`, ...area, target: TARGET } } });
}

const NAMES: Partial<Record<LampKind, string>> = { point: 'Point', spot: 'Spot', disc: 'Area', sphere: 'Sphere' };

/** Hangs a lamp: above what is level, before what is upright, under a ceiling. */
export function hang(kind: LampKind, at: { point: Vec; normal: Vec }): void {
    const above = up.peek();
    const level = dot(at.normal, above);
    const position = level > 0.7 ? add(at.point, scale(above, 1.2)) : add(at.point, scale(at.normal, 0.15));
    const direction = level > 0.7 || level < -0.7 ? scale(above, -1) : at.normal;
    const place: Patch = { position };
    if (kind !== 'point' && kind !== 'sphere') place.direction = direction;
    if (kind === 'spot') Object.assign(place, { inner: 24, outer: 36, ...(level > 0.7 ? { aim: at.point } : {}) });
    if (kind === 'disc') place.radius = 0.15;
    if (kind === 'sphere') place.radius = 0.08;
    const own = lamps.all().filter(([, lamp]) => lamp.own).length;
    selectNext(lamps as unknown as Slice<object>, 'lamp');
    step(`Add ${NAMES[kind]?.toLowerCase() ?? kind} lamp`, {
        do: 'add',
        lamp: { name: `${NAMES[kind] ?? kind} ${own + 1}`, kind, flux: 800, place },
    });
}

/** So many more of each, on a line. */
export function copyAlong(ids: Id[], count: number, stepBy: Vec): void {
    if (!ids.length || count < 1) return;
    step(`Copy ${titleOf(ids)}`, { do: 'copy', lamps: ids, count, step: stepBy });
}

export function removeLamps(ids: Id[]): void {
    if (ids.length) step(`Remove ${titleOf(ids)}`, { do: 'remove', lamps: ids });
}

/** Moves lamps by so much; what they aim at stays, and they follow it. */
export function placed(ids: Id[], by: Vec, from: Map<Id, Vec>): Patch {
    const patch: Record<string, unknown> = {};
    for (const id of ids) {
        const place = lamps.get(id)?.place;
        const start = from.get(id);
        if (!start) continue;
        const position = add(start, by);
        const toward = place?.aim && distance(place.aim, position) > 1e-6 ? { direction: normal(sub(place.aim, position)) } : {};
        patch[id] = { place: { position, ...toward } };
    }
    return { lamps: patch };
}

/** Places of the lamps that have one. */
export function positions(ids: Id[]): Map<Id, Vec> {
    const found = new Map<Id, Vec>();
    for (const id of ids) {
        const lamp = lamps.get(id);
        const position = lamp && positionOf(lamp);
        if (position) found.set(id, position);
    }
    return found;
}
