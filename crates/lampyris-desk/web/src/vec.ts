// Arithmetic of three numbers.

import type { Vec } from './types';

export const add = (a: Vec, b: Vec): Vec => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec, s: number): Vec => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec, b: Vec): Vec => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec): number => Math.hypot(a[0], a[1], a[2]);
export const distance = (a: Vec, b: Vec): number => length(sub(a, b));
export const mix = (a: Vec, b: Vec, t: number): Vec => add(scale(a, 1 - t), scale(b, t));

/** The direction of a vector; `otherwise` where it has none. */
export function normal(a: Vec, otherwise: Vec = [0, 0, 1]): Vec {
    const n = length(a);
    return n > 1e-12 ? scale(a, 1 / n) : otherwise;
}

/** Some unit vector across `a`. */
export function across(a: Vec): Vec {
    const axis: Vec = Math.abs(a[0]) < 0.7 * length(a) ? [1, 0, 0] : [0, 1, 0];
    return normal(cross(axis, a));
}

/** `a` turned about the unit `axis` by `angle` [radians]. */
export function turn(a: Vec, axis: Vec, angle: number): Vec {
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    return add(add(scale(a, c), scale(cross(axis, a), s)), scale(axis, dot(axis, a) * (1 - c)));
}

/** The eight corners of a box. */
export function corners([low, high]: [Vec, Vec]): Vec[] {
    return Array.from({ length: 8 }, (_, k) => [
        k & 1 ? high[0] : low[0],
        k & 2 ? high[1] : low[1],
        k & 4 ? high[2] : low[2],
    ]);
}

export const middle = ([low, high]: [Vec, Vec]): Vec => mix(low, high, 0.5);
