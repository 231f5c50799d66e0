// What the handles hold: the lamps selected that have a place, or things that are not locked; the last under the hand.

import {
    add, chosenLamps, computed, editor, effect, fitted, Gesture, handles, lamps, lookOnly, middle, nameOf, normal,
    pinhole, positionOf, role, selection, shown, sub, things, titleOf, tool, turn, useEffect, useRef, viewSize,
    type Id, type Lamp, type Place, type Vec,
} from '../desk';
import { placed, positions } from './tools';
import { mount, type Hold, type Host, type Target } from './gizmo';

type Quaternion = [number, number, number, number];

/** A turn after another. */
export function after([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion {
    return [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ];
}

const may = () => !lookOnly.value && role.value !== 'watch' && editor.value.you && tool.value !== 'aim';

/** Lamps, or things that are not locked. */
const held = computed<{ kind: 'lamps' | 'things'; ids: Id[] } | null>(() => {
    const now = selection.value;
    if (!now || !may()) return null;
    if (now.kind === 'thing') {
        const ids = now.ids.filter((id) => things.get(id) && !things.get(id)?.locked);
        return ids.length ? { kind: 'things', ids } : null;
    }
    const ids = chosenLamps.value.filter((id) => positionOf(lamps.get(id) as Lamp));
    return ids.length ? { kind: 'lamps', ids } : null;
});

const thingAt = (id: Id): Vec | null => {
    const thing = things.get(id);
    return thing?.place?.position ?? (thing?.box ? middle(thing.box) : null);
};

/** The last selected one is under the hand. */
const target = computed<Target | null>(() => {
    const now = held.value;
    if (!now) return null;
    const id = now.ids[now.ids.length - 1];
    const position = now.kind === 'lamps' ? positionOf(lamps.get(id) as Lamp) : thingAt(id);
    if (!position) return null;
    const place = now.kind === 'lamps' ? lamps.get(id)?.place : null;
    return {
        position,
        direction: place?.direction ?? null,
        aim: place?.aim ?? null,
        turns: now.kind === 'things' || !!place?.direction || !!place?.rotation,
        mode: handles.value,
    };
});

const view = computed(() => {
    const picture = shown.value;
    void viewSize.value;
    if (!picture) return null;
    const { width, height } = picture.head;
    return { hole: pinhole(picture.camera, width, height), fit: fitted(width, height) };
});

const host: Host = {
    effect,
    target,
    view,
    hold(what) {
        const now = held.peek();
        const ids = now?.ids ?? [];
        const kind = now?.kind ?? 'lamps';
        const title = kind === 'lamps' ? titleOf(ids) : ids.length === 1 ? nameOf('thing', ids[0]) : `${ids.length} things`;
        const gesture = new Gesture(`${what === 'move' ? 'Move' : what === 'aim' ? 'Aim' : 'Turn'} ${title}`);
        const from = kind === 'lamps' ? positions(ids) : new Map(ids.map((id) => [id, thingAt(id) as Vec]));
        const places = new Map(ids.map((id) => [id, (kind === 'lamps' ? lamps : things).get(id)?.place]));
        const set = (of: (id: Id) => Place | null) => {
            const entries = ids.map((id) => [id, of(id)] as const).filter(([, place]) => place);
            gesture.set({ [kind]: Object.fromEntries(entries.map(([id, place]) => [id, { place }])) });
        };
        return {
            move: (by) => (kind === 'lamps' ? gesture.set(placed(ids, by, from)) : set((id) => ({ position: add(from.get(id) as Vec, by) }))),
            turn: (direction, aim) => set((id) => (places.get(id)?.direction ? { direction, ...(aim ? { aim } : {}) } : null)),
            rotate: (axis, by) => set((id) => {
                const place = places.get(id);
                if (place?.direction) {
                    const direction = normal(turn(place.direction, axis, by));
                    const arm = place.aim && place.position ? turn(sub(place.aim, place.position), axis, by) : null;
                    return { direction, ...(arm ? { aim: add(place.position as Vec, arm) } : {}) };
                }
                const s = Math.sin(by / 2);
                const now: Quaternion = [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(by / 2)];
                return { rotation: after(now, place?.rotation ?? [0, 0, 0, 1]) };
            }),
            end: () => gesture.end(),
            cancel: () => gesture.cancel(),
        };
    },
};

/** What the handles hold, taken by other means; null where they hold nothing. */
export const take = (what: 'move' | 'turn'): Hold | null => (target.peek() ? host.hold(what) : null);

export function Gizmo() {
    const svg = useRef<SVGSVGElement>(null);
    useEffect(() => mount(svg.current as SVGSVGElement, host).stop, []);
    return <svg id="handles" ref={svg} aria-hidden="true" />;
}
