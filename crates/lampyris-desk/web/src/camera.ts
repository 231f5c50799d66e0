// The pinhole and the parallel camera, the same as the renderer's, and the ways to move them. Nothing here knows the page.

import type { Camera, Vec } from './types';
import { add, cross, distance, dot, length, middle, normal, across, scale, sub, turn } from './vec';

const RADIANS = Math.PI / 180;
/** How near to straight up or down one may look. */
const STEEPEST = 89 * RADIANS;

/** A camera made ready for a picture of a size: unit axes and what one pixel is, at distance 1 or everywhere. */
export interface Pinhole {
    eye: Vec;
    forward: Vec;
    side: Vec;
    up: Vec;
    width: number;
    height: number;
    pixel: number;
    parallel: boolean;
}

export function pinhole(camera: Camera, width: number, height: number): Pinhole {
    const forward = normal(sub(camera.target, camera.eye), [0, 0, -1]);
    const side = normal(cross(forward, camera.up), across(forward));
    const up = cross(side, forward);
    const parallel = camera.height != null && camera.height > 0;
    const pixel = parallel ? (camera.height as number) / height : (2 * Math.tan(camera.fov * RADIANS * 0.5)) / height;
    return { eye: camera.eye, forward, side, up, width, height, pixel, parallel };
}

/** Where a point is to be seen [pixels from the upper left corner] and how far it is along the axis [m]. */
export function project(view: Pinhole, point: Vec): [number, number, number] {
    const d = sub(point, view.eye);
    const depth = dot(d, view.forward);
    const size = view.parallel ? view.pixel : view.pixel * depth;
    return [view.width / 2 + dot(d, view.side) / size, view.height / 2 - dot(d, view.up) / size, depth];
}

/** The ray through a picture point; unit direction. */
export function ray(view: Pinhole, x: number, y: number): { origin: Vec; direction: Vec } {
    const right = (x - view.width / 2) * view.pixel;
    const above = (view.height / 2 - y) * view.pixel;
    const offset = add(scale(view.side, right), scale(view.up, above));
    if (view.parallel) return { origin: add(view.eye, offset), direction: view.forward };
    return { origin: view.eye, direction: normal(add(view.forward, offset)) };
}

/** Metres that a pixel spans where a point is. */
export function metres(view: Pinhole, point: Vec): number {
    return view.parallel ? view.pixel : view.pixel * Math.max(dot(sub(point, view.eye), view.forward), 1e-3);
}

/** Turns the head: to the left by `yaw`, upward by `pitch` [radians]. The horizon becomes level. */
export function look(camera: Camera, up: Vec, yaw: number, pitch: number): Camera {
    const axis = sub(camera.target, camera.eye);
    const reach = Math.max(length(axis), 1e-3);
    const before = Math.asin(Math.max(-1, Math.min(1, dot(normal(axis), up))));
    const flat = sub(axis, scale(up, dot(axis, up)));
    const level = normal(length(flat) > 1e-6 * reach ? flat : sub(camera.up, scale(up, dot(camera.up, up))), across(up));
    const after = Math.max(-STEEPEST, Math.min(STEEPEST, before + pitch));
    const ahead = turn(level, up, yaw);
    const direction = add(scale(ahead, Math.cos(after)), scale(up, Math.sin(after)));
    return { ...camera, up, target: add(camera.eye, scale(direction, reach)) };
}

/** Steps: ahead and sideways on the level, and upward [m]. */
export function walk(camera: Camera, up: Vec, ahead: number, sideways: number, upward: number): Camera {
    const axis = sub(camera.target, camera.eye);
    const flat = sub(axis, scale(up, dot(axis, up)));
    const level = normal(length(flat) > 1e-6 ? flat : camera.up, across(up));
    const side = normal(cross(level, up));
    const step = add(add(scale(level, ahead), scale(side, sideways)), scale(up, upward));
    return moved(camera, step);
}

/** As `walk`, but ahead is where one looks. */
export function fly(camera: Camera, up: Vec, ahead: number, sideways: number, upward: number): Camera {
    const axis = normal(sub(camera.target, camera.eye));
    const side = normal(cross(axis, camera.up), across(axis));
    return moved(camera, add(add(scale(axis, ahead), scale(side, sideways)), scale(up, upward)));
}

export function moved(camera: Camera, step: Vec): Camera {
    return { ...camera, eye: add(camera.eye, step), target: add(camera.target, step) };
}

/** Goes round a point: by `yaw` about the vertical and by `pitch` about the horizontal [radians], never over the top. */
export function orbit(camera: Camera, up: Vec, pivot: Vec, yaw: number, pitch: number): Camera {
    const axis = normal(sub(camera.target, camera.eye));
    const before = Math.asin(Math.max(-1, Math.min(1, dot(axis, up))));
    const after = Math.max(-STEEPEST, Math.min(STEEPEST, before + pitch));
    const side = normal(cross(axis, up), normal(cross(axis, camera.up), across(axis)));
    const swing = (p: Vec): Vec => turn(turn(p, side, after - before), up, yaw);
    return {
        ...camera,
        up,
        eye: add(pivot, swing(sub(camera.eye, pivot))),
        target: add(pivot, swing(sub(camera.target, pivot))),
    };
}

/** Moves in the picture's plane so that a point at `depth` [m] follows the hand by so many pixels. */
export function pan(camera: Camera, view: Pinhole, dx: number, dy: number, depth: number): Camera {
    const size = view.parallel ? view.pixel : view.pixel * depth;
    return moved(camera, add(scale(view.side, -dx * size), scale(view.up, dy * size)));
}

/**
 * Goes toward a point, by a factor on the distance; the point stays where it is in the picture. Never through it nor
 * nearer than `nearest` [m]: with `through` one goes on at the pace of half a metre.
 */
export function dolly(camera: Camera, point: Vec, factor: number, nearest: number, through: boolean): Camera {
    const to = sub(point, camera.eye);
    const far = length(to);
    if (far < 1e-9) return camera;
    let step = far * (1 - factor);
    if (through) step = Math.sign(step) * Math.max(Math.abs(step), 0.5 * Math.abs(1 - factor));
    else if (step > 0) step = Math.max(0, Math.min(step, far - nearest));
    return moved(camera, scale(to, step / far));
}

/** The parallel camera's zoom: a factor on what is seen, about a picture point. */
export function zoom(camera: Camera, view: Pinhole, x: number, y: number, factor: number): Camera {
    const height = Math.max(0.05, Math.min(1e5, (camera.height ?? 1) * factor));
    const shift = (1 - height / (camera.height ?? 1)) * view.pixel;
    const step = add(
        scale(view.side, (x - view.width / 2) * shift),
        scale(view.up, (view.height / 2 - y) * shift),
    );
    return { ...moved(camera, step), height };
}

/** From the same direction, so far away that a box fills two thirds of the picture. */
export function frame(camera: Camera, box: [Vec, Vec], nearest = 0.4): Camera {
    const centre = middle(box);
    // A lamp that is a point is seen with what is around it.
    const radius = Math.max(distance(box[0], box[1]) / 2, 0.5);
    const back = normal(sub(camera.eye, camera.target));
    if (camera.height) {
        const reach = dot(sub(camera.eye, centre), back);
        return { ...camera, eye: add(centre, scale(back, reach)), target: centre, height: radius * 3 };
    }
    const away = Math.max((1.5 * radius) / Math.tan(camera.fov * RADIANS * 0.5), nearest + radius);
    return { ...camera, eye: add(centre, scale(back, away)), target: centre };
}

export type Preset = 'plan' | 'ceiling' | 'north' | 'east' | 'south' | 'west';
export const PRESETS: Preset[] = ['plan', 'ceiling', 'north', 'east', 'south', 'west'];

/** Right and ahead on a plan of a scene with this upward direction. */
export function compass(up: Vec): { right: Vec; ahead: Vec } {
    const axis: Vec = Math.abs(up[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
    const ahead = normal(cross(up, axis));
    return { right: normal(cross(ahead, up)), ahead };
}

/** A parallel camera before one side of the bounds, with a cut that opens the room: `cut` of the depth is taken away. */
export function preset(which: Preset, bounds: [Vec, Vec], up: Vec, aspect: number): Camera {
    const { right, ahead } = compass(up);
    const centre = middle(bounds);
    const span = (axis: Vec): number => Math.abs(dot(sub(bounds[1], bounds[0]), axis));
    const table: Record<Preset, { forward: Vec; up: Vec; side: Vec; cut: number }> = {
        plan: { forward: scale(up, -1), up: ahead, side: right, cut: 0.15 },
        ceiling: { forward: up, up: scale(ahead, -1), side: right, cut: 0.35 },
        north: { forward: ahead, up, side: right, cut: 0.25 },
        south: { forward: scale(ahead, -1), up, side: right, cut: 0.25 },
        east: { forward: right, up, side: ahead, cut: 0.25 },
        west: { forward: scale(right, -1), up, side: ahead, cut: 0.25 },
    };
    const view = table[which];
    const depth = span(view.forward);
    const margin = 1;
    const eye = sub(centre, scale(view.forward, depth / 2 + margin));
    const height = 1.08 * Math.max(span(view.up), span(view.side) / aspect, 0.1);
    return { eye, target: centre, up: view.up, fov: 50, height, near: margin + depth * view.cut };
}

/** True if two cameras see the same, near enough that no eye can tell. */
export function same(a: Camera, b: Camera): boolean {
    const near = (p: Vec, q: Vec) => distance(p, q) < 1e-4;
    const value = (p?: number | null, q?: number | null) => Math.abs((p ?? -1) - (q ?? -1)) < 1e-4;
    return near(a.eye, b.eye) && near(a.target, b.target) && near(a.up, b.up) && value(a.fov, b.fov)
        && value(a.height, b.height) && value(a.near, b.near);
}
