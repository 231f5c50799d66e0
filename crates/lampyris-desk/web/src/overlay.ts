// What is drawn over the picture, with the camera of the frame that is shown: lamps, their aims, boxes, meters, grids.
//
// Nodes are made once and moved by attributes; nothing is drawn anew while neither camera nor entries change.

import { effect, untracked } from '@preact/signals';
import { pinhole, project, type Pinhole } from './camera';
import { shown } from './frames';
import { fitted, viewSize } from './navigate';
import { lampMarks } from './prefs';
import { hovered, selection } from './select';
import { grids, lamps, meters, output, things } from './store';
import type { Grid, Id, Meter, Vec } from './types';
import { add, corners, length, scale } from './vec';
import { positionOf } from './tools';
import { maintained } from './units';

const SVG = 'http://www.w3.org/2000/svg';
type Point = [number, number];

export function node(name: string, attributes: Record<string, string | number> = {}, parent?: Element): SVGElement {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
    parent?.append(made);
    return made;
}

/** Takes points of the scene to points of the view [CSS pixels]; null behind the eye. */
export class Lens {
    private view: Pinhole;
    private fit: { x: number; y: number; scale: number };
    constructor(view: Pinhole) {
        this.view = view;
        this.fit = fitted(view.width, view.height);
    }
    at(point: Vec): Point | null {
        const [x, y, depth] = project(this.view, point);
        if (depth < 0.02 && !this.view.parallel) return null;
        return [this.fit.x + x * this.fit.scale, this.fit.y + y * this.fit.scale];
    }
    /** A line of the scene as a path, as much of it as lies before the eye. */
    line(a: Vec, b: Vec): string {
        const [, , da] = project(this.view, a);
        const [, , db] = project(this.view, b);
        const near = 0.05;
        let [from, to] = [a, b];
        if (!this.view.parallel) {
            if (da < near && db < near) return '';
            const t = (near - da) / (db - da);
            const cut = add(scale(a, 1 - t), scale(b, t));
            if (da < near) from = cut;
            if (db < near) to = cut;
        }
        const [p, q] = [this.at(from), this.at(to)];
        if (!p || !q) return '';
        return `M${p[0].toFixed(1)} ${p[1].toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}`;
    }
}

/** The lens of the frame that is shown. */
export function lens(): Lens | null {
    const picture = shown.value;
    void viewSize.value;
    return picture ? new Lens(pinhole(picture.camera, picture.head.width, picture.head.height)) : null;
}

/** Each lamp that has a place, and where it is seen now. */
export function lampsSeen(): { id: Id; at: Point }[] | null {
    const through = untracked(lens);
    if (!through) return null;
    return lamps.all().flatMap(([id, lamp]) => {
        const point = lampPoint(lamp);
        const at = point && through.at(point);
        return at ? [{ id, at }] : [];
    });
}

/** Where a lamp is, for a mark. */
export const lampPoint = positionOf;

const EDGES = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

export function boxPath(lens: Lens, box: [Vec, Vec]): string {
    const points = corners(box);
    return EDGES.map(([a, b]) => lens.line(points[a], points[b])).join('');
}

/** Of more lamps than these only those that are selected or pointed at are marked. */
const MANY = 150;

interface Mark {
    group: SVGElement;
    label: SVGElement;
}

/** Keeps one mark for each number, and takes away those whose number is gone. */
class Marks {
    private marks = new Map<Id, Mark>();
    constructor(private parent: Element, private kind: string, private shape: (group: SVGElement) => void) {}
    draw(list: { id: Id; at: Point | null; label: string; state: string }[]): void {
        const seen = new Set<Id>();
        for (const { id, at, label, state } of list) {
            seen.add(id);
            let mark = this.marks.get(id);
            if (!mark) {
                const group = node('g', { 'data-kind': this.kind, 'data-id': id }, this.parent);
                this.shape(group);
                const text = node('text', { x: 10, y: 4 }, group);
                mark = { group, label: text };
                this.marks.set(id, mark);
            }
            if (!at) {
                mark.group.setAttribute('display', 'none');
                continue;
            }
            mark.group.removeAttribute('display');
            mark.group.setAttribute('transform', `translate(${at[0].toFixed(1)} ${at[1].toFixed(1)})`);
            mark.group.setAttribute('class', `mark ${this.kind} ${state}`);
            if (mark.label.textContent !== label) mark.label.textContent = label;
        }
        for (const [id, mark] of this.marks) {
            if (seen.has(id)) continue;
            mark.group.remove();
            this.marks.delete(id);
        }
    }
}

/** Fills an SVG element and keeps it true; returns how to stop. */
export function overlayOn(svg: SVGSVGElement): () => void {
    const lines = node('path', { class: 'aims' }, svg);
    const boxes = node('path', { class: 'boxes' }, svg);
    const hover = node('path', { class: 'boxes hover' }, svg);
    const gridLines = node('path', { class: 'grid-lines' }, svg);
    const lampMarksAt = new Marks(node('g', {}, svg), 'lamp', (g) => node('circle', { r: 4.5 }, g));
    const gridMarks = new Marks(node('g', {}, svg), 'grid', () => undefined);
    const meterMarks = new Marks(node('g', {}, svg), 'meter', (g) => {
        node('circle', { r: 5.5 }, g);
        node('path', { d: 'M-9 0H9M0 -9V9' }, g);
    });

    const stopLamps = effect(() => {
        const through = lens();
        if (!through) return;
        const now = selection.value;
        const over = hovered.value;
        let aims = '';
        let selectedBoxes = '';
        const few = lamps.ids.value.length <= MANY;
        const list = lamps.all().map(([id, lamp]) => {
            const selected = now?.kind === 'lamp' ? now.ids.includes(id) : now?.kind === 'group' && now.ids.includes(lamp.group ?? -1);
            const under = over?.kind === 'lamp' ? over.id === id : over?.kind === 'group' && over.id === lamp.group;
            const point = lampPoint(lamp);
            const movable = lamp.place?.position;
            if (selected && lamp.box) selectedBoxes += boxPath(through, lamp.box);
            if (movable && lamp.place?.direction && (selected || under)) {
                const to = lamp.place.aim ?? add(movable, lamp.place.direction);
                aims += through.line(movable, to);
            }
            const visible = selected || under || (few && lampMarks.value && (lamp.own || lamp.place?.position));
            const state = `${selected ? 'selected' : ''} ${under ? 'under' : ''} ${output(lamp) ? '' : 'off'}`;
            return { id, at: point && visible ? through.at(point) : null, label: selected || under ? lamp.name : '', state };
        });
        lampMarksAt.draw(list);
        lines.setAttribute('d', aims);
        if (now?.kind === 'thing') {
            for (const id of now.ids) {
                const box = things.get(id)?.box;
                if (box) selectedBoxes += boxPath(through, box);
            }
        }
        boxes.setAttribute('d', selectedBoxes);
        const overBox = over?.kind === 'lamp' ? lamps.get(over.id)?.box : over?.kind === 'thing' ? things.get(over.id)?.box : null;
        hover.setAttribute('d', overBox ? boxPath(through, overBox) : '');
    });

    const stopMeters = effect(() => {
        const through = lens();
        if (!through) return;
        const now = selection.value;
        const state = (kind: string, id: Id) => (now?.kind === kind && now.ids.includes(id) ? 'selected' : '');
        meterMarks.draw(meters.all().map(([id, meter]: [Id, Meter]) => ({
            id, at: through.at(meter.point), label: meter.lux ? maintained(meter.lux[0]) : '…', state: state('meter', id),
        })));
        let mesh = '';
        gridMarks.draw(grids.all().map(([id, grid]: [Id, Grid]) => {
            mesh += gridPath(through, grid);
            const label = grid.mean == null ? '…' : `${grid.name} ${maintained(grid.mean)}`;
            return { id, at: through.at(grid.corner), label, state: state('grid', id) };
        }));
        gridLines.setAttribute('d', mesh);
    });
    return () => {
        stopLamps();
        stopMeters();
        svg.replaceChildren();
    };
}

/** Where a point of a grid is. */
export function gridPoint({ corner, u, v, columns, rows, border = 0 }: Grid, column: number, row: number): Vec {
    const along = (edge: Vec, k: number, count: number): Vec => {
        const off = length(edge) > 2 * border ? border / length(edge) : 0;
        return scale(edge, off + ((1 - 2 * off) * (k + 0.5)) / count);
    };
    return add(corner, add(along(u, column, columns), along(v, row, rows)));
}

/** The outline of a grid and a cross at each of its points. */
function gridPath(lens: Lens, grid: Grid): string {
    const at = (s: number, t: number): Vec => add(grid.corner, add(scale(grid.u, s), scale(grid.v, t)));
    let path = lens.line(at(0, 0), at(1, 0)) + lens.line(at(1, 0), at(1, 1)) + lens.line(at(1, 1), at(0, 1))
        + lens.line(at(0, 1), at(0, 0));
    for (let row = 0; row < grid.rows; row++) {
        for (let column = 0; column < grid.columns; column++) {
            const p = lens.at(gridPoint(grid, column, row));
            if (p) path += `M${(p[0] - 2).toFixed(1)} ${p[1].toFixed(1)}h4m-2 -2v4`;
        }
    }
    return path;
}
