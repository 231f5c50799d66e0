// Handles to move, turn and aim a lamp: arrows, plane squares, rings and the aim point, of constant size on the screen.
//
// It is some thirty nodes of SVG whose coordinates are set when
// camera or lamp have changed; what is dragged follows the pointer and not the frame, which is a little older.

import { project, ray, type Pinhole } from '../desk';
import type { Vec } from '../types';
import { across, add, cross, distance, dot, length, normal, scale, sub } from '../desk';

export interface Target {
    position: Vec;
    direction: Vec | null;
    /** Without a direction it may still be turned. */
    turns: boolean;
    aim: Vec | null;
    mode: 'move' | 'turn';
}
export interface Hold {
    move(by: Vec): void;
    turn(direction: Vec, aim: Vec | null): void;
    /** About an axis through where it stands [radians]. */
    rotate(axis: Vec, by: number): void;
    end(): void;
    cancel(): void;
}
export interface Host {
    effect(run: () => void): () => void;
    target: { value: Target | null; peek(): Target | null };
    view: { value: Seen | null; peek(): Seen | null };
    hold(what: 'move' | 'turn' | 'aim'): Hold;
}
export interface Mounted {
    stop(): void;
}
interface Seen {
    hole: Pinhole;
    fit: { x: number; y: number; scale: number };
}

const SVG = 'http://www.w3.org/2000/svg';
/** Length of an arrow and radius of a ring [CSS pixels]. */
const REACH = 84;
const AXES: Vec[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const NAMES = ['x', 'y', 'z'];
/** Steps of snapping [m, radians]. */
const STEP = 0.1;
const NOTCH = (5 * Math.PI) / 180;
const ARC = 48;

export function mount(svg: SVGSVGElement, host: Host): Mounted {
    const make = (name: string, parent: Element, classes: string): SVGElement => {
        const made = document.createElementNS(SVG, name);
        made.setAttribute('class', classes);
        parent.append(made);
        return made;
    };
    /** A handle is what is seen and, wider, what is hit. */
    const handle = (kind: string, axis: number, name: string) => {
        const group = make('g', svg, `handle ${kind} ${NAMES[axis] ?? ''}`);
        group.setAttribute('data-handle', name);
        return { group, hit: make('path', group, 'hit'), seen: make('path', group, 'seen') };
    };
    const aimLine = make('path', svg, 'aim-line');
    const rings = AXES.map((_, axis) => handle('ring', axis, `ring-${NAMES[axis]}`));
    const planes = AXES.map((_, axis) => handle('plane', axis, `plane-${NAMES[axis]}`));
    const arrows = AXES.map((_, axis) => handle('arrow', axis, `move-${NAMES[axis]}`));
    const centre = handle('centre', -1, 'move-view');
    const aim = handle('aim', -1, 'aim');
    const text = make('text', svg, 'handle-text');

    const spot = (seen: Seen, p: Vec): [number, number] | null => {
        const [x, y, depth] = project(seen.hole, p);
        if (depth < 0.02 && !seen.hole.parallel) return null;
        return [seen.fit.x + x * seen.fit.scale, seen.fit.y + y * seen.fit.scale];
    };
    /** Metres that `REACH` is where the lamp is. */
    const reach = (seen: Seen, p: Vec): number => {
        const depth = project(seen.hole, p)[2];
        return (REACH / seen.fit.scale) * seen.hole.pixel * (seen.hole.parallel ? 1 : Math.max(depth, 0.02));
    };
    const path = (element: SVGElement, points: ([number, number] | null)[], close = false) => {
        const known = points.filter((p): p is [number, number] => p !== null);
        const d = known.length < points.length || known.length < 2 ? '' : `M${known.map((p) => `${p[0].toFixed(1)} ${p[1].toFixed(1)}`).join('L')}${close ? 'Z' : ''}`;
        element.setAttribute('d', d);
    };
    const circle = (element: SVGElement, at: [number, number] | null, r: number) => {
        element.setAttribute('d', at ? `M${at[0] - r} ${at[1]}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0` : '');
    };
    const show = (list: { group: SVGElement }[], on: boolean) => list.forEach((h) => h.group.classList.toggle('gone', !on));

    function draw(now: Target, seen: Seen): void {
        const p = now.position;
        const o = spot(seen, p);
        const size = reach(seen, p);
        const moving = now.mode === 'move';
        show([...arrows, ...planes, centre], moving && o !== null);
        show(rings, !moving && o !== null && now.turns);
        const aimed = now.aim ?? (now.direction ? add(p, scale(now.direction, 3 * size)) : null);
        show([aim], aimed !== null && o !== null);
        if (!o) {
            aimLine.setAttribute('d', '');
            return;
        }
        AXES.forEach((axis, k) => {
            const tip = spot(seen, add(p, scale(axis, size)));
            const short = tip ? Math.hypot(tip[0] - o[0], tip[1] - o[1]) < 12 : true;
            arrows[k].group.classList.toggle('gone', !moving || short);
            if (tip && moving) {
                const [dx, dy] = [(tip[0] - o[0]) / REACH, (tip[1] - o[1]) / REACH];
                const n = Math.hypot(dx, dy) || 1;
                const [ux, uy] = [dx / n, dy / n];
                const base: [number, number] = [o[0] + 14 * ux, o[1] + 14 * uy];
                path(arrows[k].hit, [base, tip]);
                arrows[k].seen.setAttribute('d', `M${base[0].toFixed(1)} ${base[1].toFixed(1)}L${tip[0].toFixed(1)} ${tip[1].toFixed(1)}`
                    + `M${(tip[0] - 9 * ux - 4.5 * uy).toFixed(1)} ${(tip[1] - 9 * uy + 4.5 * ux).toFixed(1)}L${tip[0].toFixed(1)} ${tip[1].toFixed(1)}`
                    + `L${(tip[0] - 9 * ux + 4.5 * uy).toFixed(1)} ${(tip[1] - 9 * uy - 4.5 * ux).toFixed(1)}`);
            }
            const [a, b] = [AXES[(k + 1) % 3], AXES[(k + 2) % 3]];
            // A plane that is seen from its edge cannot be dragged in.
            const edge = Math.abs(dot(axis, seen.hole.parallel ? seen.hole.forward : normal(sub(p, seen.hole.eye)))) < 0.15;
            planes[k].group.classList.toggle('gone', !moving || edge);
            const at = (s: number, t: number) => spot(seen, add(p, add(scale(a, s * size), scale(b, t * size))));
            const square = [at(0.3, 0.3), at(0.5, 0.3), at(0.5, 0.5), at(0.3, 0.5)];
            path(planes[k].hit, square, true);
            path(planes[k].seen, square, true);
            if (!moving) {
                const round = Array.from({ length: ARC + 1 }, (_, i) => {
                    const angle = (2 * Math.PI * i) / ARC;
                    return spot(seen, add(p, add(scale(a, Math.cos(angle) * size), scale(b, Math.sin(angle) * size))));
                });
                path(rings[k].hit, round);
                path(rings[k].seen, round);
            }
        });
        circle(centre.hit, o, 13);
        circle(centre.seen, o, 7);
        const to = aimed && spot(seen, aimed);
        path(aimLine, [o, to]);
        circle(aim.hit, to, 16);
        aim.seen.setAttribute('d', to ? `M${to[0] - 8} ${to[1]}h16M${to[0]} ${to[1] - 8}v16M${to[0] - 5} ${to[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : '');
    }

    const stop = host.effect(() => {
        const now = host.target.value;
        const seen = host.view.value;
        svg.classList.toggle('empty', !now || !seen);
        if (now && seen) draw(now, seen);
    });

    const rayAt = (seen: Seen, e: PointerEvent, box: DOMRect) =>
        ray(seen.hole, (e.clientX - box.left - seen.fit.x) / seen.fit.scale, (e.clientY - box.top - seen.fit.y) / seen.fit.scale);

    function drag(element: SVGElement, what: 'move' | 'turn' | 'aim', follow: (seen: Seen) => (at: { origin: Vec; direction: Vec }, snap: boolean, hold: Hold) => string): void {
        element.addEventListener('pointerdown', (e: PointerEvent) => {
            if (e.button !== 0) return;
            e.preventDefault();
            e.stopPropagation();
            const seen = host.view.peek();
            if (!seen || !host.target.peek()) return;
            const box = svg.getBoundingClientRect();
            const step = follow(seen);
            const hold = host.hold(what);
            const first = rayAt(seen, e, box);
            step(first, false, { ...hold, move: () => {}, turn: () => {}, rotate: () => {} });
            element.setPointerCapture(e.pointerId);
            element.classList.add('held');
            const move = (event: PointerEvent) => {
                text.textContent = step(rayAt(seen, event, box), event.ctrlKey || event.metaKey, hold);
                text.setAttribute('x', String(event.clientX - box.left + 16));
                text.setAttribute('y', String(event.clientY - box.top - 12));
            };
            const over = (keep: boolean) => {
                element.removeEventListener('pointermove', move);
                element.removeEventListener('pointerup', up);
                element.removeEventListener('pointercancel', lost);
                removeEventListener('keydown', key, true);
                element.classList.remove('held');
                text.textContent = '';
                if (keep) hold.end();
                else hold.cancel();
            };
            const up = () => over(true);
            const lost = () => over(false);
            const key = (event: KeyboardEvent) => {
                if (event.key !== 'Escape') return;
                event.stopPropagation();
                over(false);
            };
            element.addEventListener('pointermove', move);
            element.addEventListener('pointerup', up);
            element.addEventListener('pointercancel', lost);
            addEventListener('keydown', key, true);
        });
    }

    const snapped = (value: number, step: number, snap: boolean) => (snap ? Math.round(value / step) * step : value);
    const metres = (by: Vec) => by.map((v) => v.toFixed(2)).join('  ') + ' m';

    AXES.forEach((axis, k) => {
        drag(arrows[k].group, 'move', () => {
            const from = (host.target.peek() as Target).position;
            let start: number | null = null;
            return (at, snap, hold) => {
                const t = alongLine(from, axis, at);
                start ??= t;
                const by = scale(axis, snapped(t - start, STEP, snap));
                hold.move(by);
                return metres(by);
            };
        });
        drag(planes[k].group, 'move', () => inPlane(axis));
        drag(rings[k].group, 'turn', () => {
            const now = host.target.peek() as Target;
            const start: { at: Vec | null } = { at: null };
            return (at, snap, hold) => {
                const p = onPlane(now.position, axis, at);
                const arm = p && normal(sub(p, now.position), across(axis));
                if (!arm) return '';
                start.at ??= arm;
                const angle = Math.atan2(dot(axis, cross(start.at, arm)), dot(start.at, arm));
                const by = snapped(angle, NOTCH, snap);
                hold.rotate(axis, by);
                return `${((by * 180) / Math.PI).toFixed(1)}°`;
            };
        });
    });
    drag(centre.group, 'move', (seen) => inPlane(seen.hole.forward));
    drag(aim.group, 'aim', (seen) => {
        const now = host.target.peek() as Target;
        const from = now.aim ?? add(now.position, scale(now.direction as Vec, 3 * reach(seen, now.position)));
        const move = inPlaneAt(from, seen.hole.forward);
        return (at, snap, hold) => {
            const by = move(at, snap);
            const to = add(from, by);
            if (distance(to, now.position) > 1e-3) hold.turn(normal(sub(to, now.position)), to);
            return metres(to);
        };
    });

    function inPlane(axis: Vec) {
        const move = inPlaneAt((host.target.peek() as Target).position, axis);
        return (at: { origin: Vec; direction: Vec }, snap: boolean, hold: Hold) => {
            const by = move(at, snap);
            hold.move(by);
            return metres(by);
        };
    }
    function inPlaneAt(from: Vec, axis: Vec) {
        let start: Vec | null = null;
        return (at: { origin: Vec; direction: Vec }, snap: boolean): Vec => {
            const p = onPlane(from, axis, at);
            if (!p) return [0, 0, 0];
            start ??= p;
            return sub(p, start).map((v) => snapped(v, STEP, snap)) as Vec;
        };
    }
    return { stop };
}

/** How far along a line the point is that is nearest to a ray. */
export function alongLine(from: Vec, axis: Vec, at: { origin: Vec; direction: Vec }): number {
    const w = sub(from, at.origin);
    const b = dot(axis, at.direction);
    const denominator = 1 - b * b;
    if (denominator < 1e-6) return 0;
    return (b * dot(at.direction, w) - dot(axis, w)) / denominator;
}

/** Where a ray meets a plane, or null; never so far away that it could only be an accident. */
export function onPlane(from: Vec, axis: Vec, at: { origin: Vec; direction: Vec }): Vec | null {
    const slope = dot(axis, at.direction);
    if (Math.abs(slope) < 1e-4 * length(axis)) return null;
    const t = dot(sub(from, at.origin), axis) / slope;
    if (t < 0 || t > 1e6) return null;
    return add(at.origin, scale(at.direction, t));
}
