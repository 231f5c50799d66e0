// Areas to be measured: where they lie when two corners are pointed at, and where their points are, as the library's
// measuring has them.

import { ask, camera, cross, dot, effect, add, normal, scale, scene, selection, signal, sub, tool, type Grid, type Vec } from '../desk';

/** What is left off along the edges of a room [m]. */
export const BORDER = 0.5;
/** What lies higher above the floor is a surface of its own to work on [m]. */
const RAISED = 0.3;

/** Spacing of points on an area by EN 12464-1: p = 0.2 · 5^(log₁₀ d), at most 10 m. */
export function spacing(d: number): number {
    return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(d, 0.01)));
}

/** Length of an edge without its borders: they are left off where it is longer than two of them. */
export const inner = (length: number, border = 0): number => (length > 2 * border ? length - 2 * border : length);

/**
 * Points along both edges: the longer one says how close they are, the shorter one of areas at least twice as long as
 * wide; along the other they are as close as that.
 */
export function counts(lengths: [number, number]): [number, number] {
    const [short, long] = [Math.min(...lengths), Math.max(...lengths)];
    const leading = long >= 2 * short ? short : long;
    const cell = leading / Math.max(1, Math.round(leading / spacing(leading)));
    return lengths.map((length) => Math.max(1, Math.round(length / cell))) as [number, number];
}

interface Corner {
    point: Vec;
    normal: Vec;
}

/**
 * A level area between two corners. Both on a raised surface: on that, as high as the first; else on a work plane so far
 * above the floor, with the border that is left off in rooms. Null where they span none.
 */
export function between(a: Corner, b: Corner, above: Vec, floor: number, plane: number): Omit<Grid, 'name'> | null {
    const side: Vec = Math.abs(above[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
    const other = normal(cross(above, side));
    const d = sub(b.point, a.point);
    const [u, v] = [dot(d, side), dot(d, other)];
    if (Math.abs(u) < 0.05 || Math.abs(v) < 0.05) return null;
    const height = (p: Vec) => dot(p, above) - floor;
    const raised = [a, b].every((c) => dot(c.normal, above) > 0.7 && height(c.point) > RAISED);
    const border = raised ? 0 : BORDER;
    const lift = raised ? 0 : plane - height(a.point);
    const corner = add(add(a.point, scale(above, lift)), add(scale(side, Math.min(u, 0)), scale(other, Math.min(v, 0))));
    const lengths = [Math.abs(u), Math.abs(v)] as [number, number];
    const [columns, rows] = counts(lengths.map((length) => inner(length, border)) as [number, number]);
    return { corner, u: scale(side, lengths[0]), v: scale(other, lengths[1]), normal: above, columns, rows, border };
}

/** Where the floor is along the upward direction [m]: below the eye, or the lowest there is until that was asked. */
const found = signal<number | null>(null);
export function floorLevel(): number {
    const s = scene.value;
    return found.value ?? (s ? Math.min(dot(s.bounds[0], s.up), dot(s.bounds[1], s.up)) : 0);
}

/** Plans are seen from above the roof: what counts is the eye that was last in the room. */
let eye: Vec | null = null;
effect(() => {
    const now = camera.value;
    if (now && !now.height) eye = now.eye;
});
effect(() => {
    const above = scene.value?.up;
    if (!above || !eye || (tool.value !== 'grid' && selection.value?.kind !== 'grid')) return;
    ask('ray', { origin: eye, direction: scale(above, -1) }, (answer) => {
        if (answer.hit) found.value = dot(answer.point as Vec, above);
    });
});
