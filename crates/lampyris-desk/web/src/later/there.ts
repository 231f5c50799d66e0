// Walking to a point of the floor that was pointed at.

import { add, dot, go, here, moved, scale, spot, sub, up, walking, EYE_HEIGHT, type Camera, type Vec } from '../desk';

/** How far below the eye a floor is at least [m]: nobody climbs tables. */
const BELOW = 1.2;

/** Where the eye is over a point that one may stand on; null where one may not. */
export function standing(camera: Camera, above: Vec, at: { point: Vec; normal: Vec }): Camera | null {
    const by = sub(at.point, camera.eye);
    if (camera.height || dot(at.normal, above) < 0.9 || dot(by, above) > -BELOW) return null;
    return moved(camera, add(by, scale(above, EYE_HEIGHT)));
}

function next(): Camera | null {
    const [camera, at] = [here(), spot.value];
    return camera && at && walking.value === 'walk' ? standing(camera, up.value, at) : null;
}

export const whyNotThere = (): string | null => (next() ? null : 'Point at the floor first, walking.');

export function goThere(): void {
    const there = next();
    if (there) go(there, 'there');
}
