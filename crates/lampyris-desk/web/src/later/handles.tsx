// What the handles hold: the lamps selected that have a place, the last of them under the hand.

import {
    chosenLamps, computed, editor, effect, fitted, Gesture, handles, lamps, lookOnly, pinhole, placed, positionOf, positions, role,
    selection, shown, titleOf, tool, useEffect, useRef, viewSize, type Lamp, type Vec,
} from '../desk';
import { mount, type Host, type Target } from './gizmo';

/** What is held: the last selected lamp that has a place. */
const target = computed<Target | null>(() => {
    if (selection.value?.kind !== 'lamp' && selection.value?.kind !== 'group') return null;
    if (lookOnly.value || role.value === 'watch' || !editor.value.you || tool.value === 'aim') return null;
    const ids = chosenLamps.value.filter((id) => positionOf(lamps.get(id) as Lamp));
    if (!ids.length) return null;
    const lamp = lamps.get(ids[ids.length - 1]) as Lamp;
    return {
        position: positionOf(lamp) as Vec,
        direction: lamp.place?.direction ?? null,
        aim: lamp.place?.aim ?? null,
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

const chosen = () => chosenLamps.peek().filter((id) => lamps.entry(id));

const host: Host = {
    effect,
    target,
    view,
    hold(what) {
        const ids = chosen();
        const verb = what === 'move' ? 'Move' : what === 'aim' ? 'Aim' : 'Turn';
        const gesture = new Gesture(`${verb} ${titleOf(ids)}`);
        const from = positions(ids);
        return {
            move: (by) => gesture.set(placed(ids, by, from)),
            turn: (direction, aim) => {
                const patch = Object.fromEntries(
                    ids.filter((id) => lamps.entry(id)?.shown.peek().place?.direction).map((id) => [id, { place: { direction, aim } }]),
                );
                gesture.set({ lamps: patch });
            },
            end: () => gesture.end(),
            cancel: () => gesture.cancel(),
        };
    },
};

export function Gizmo() {
    const svg = useRef<SVGSVGElement>(null);
    useEffect(() => mount(svg.current as SVGSVGElement, host).stop, []);
    return <svg id="handles" ref={svg} aria-hidden="true" />;
}
