// The view: the canvas that frames are drawn on, the overlay over it, and what the pointer asks of the point under it.

import { signal, useSignalEffect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { drawOn, shown } from './frames';
import { followPointer } from './pointer';
import { viewName } from './navigate';
import { lampsSeen, overlayOn } from './overlay';
import { probe, probeAt } from './probe';
import { hovered, select, selectHit, selection, spot, tool } from './select';
import { scene } from './store';
import type { Id } from './types';
import { applyTool } from './tools';
import { act, drawer, whyNotTo } from './actions';
import { openWhat } from './lights';
import { Later } from './load';
import { Banner } from './banner';

const marquee = signal<{ from: [number, number]; to: [number, number] } | null>(null);

function pickMarks(from: [number, number], to: [number, number]): Id[] {
    const through = lampsSeen();
    if (!through) return [];
    const [x0, x1] = [Math.min(from[0], to[0]), Math.max(from[0], to[0])];
    const [y0, y1] = [Math.min(from[1], to[1]), Math.max(from[1], to[1])];
    return through.filter(({ at }) => at[0] >= x0 && at[0] <= x1 && at[1] >= y0 && at[1] <= y1).map(({ id }) => id);
}

const clicks = {
    click(x: number, y: number, how: 'only' | 'add' | 'toggle') {
        const mark = markAt(x, y);
        if (tool.peek() === null && mark) return select(mark.kind, mark.id, how);
        probeAt(x, y, (hit) => {
            if (hit) spot.value = { point: hit.point, normal: hit.normal };
            if (tool.peek() !== null) return applyTool(hit);
            selectHit(hit, how);
            if (selection.peek()) drawer.value = 'inspector';
        });
    },
    menu(x: number, y: number) {
        probeAt(x, y, (hit) => {
            if (hit) openWhat(x, y, hit);
        });
    },
    double(x: number, y: number) {
        if (markAt(x, y)) return act('frame');
        probeAt(x, y, (hit) => {
            if (hit) spot.value = { point: hit.point, normal: hit.normal };
            act(hit && !whyNotTo('there') ? 'there' : 'frame');
        });
    },
    hover(x: number, y: number) {
        const mark = markAt(x, y);
        if (mark?.kind === 'lamp') hovered.value = { kind: 'lamp', id: mark.id };
        probeAt(x, y, (hit) => {
            probe.value = hit;
            if (hit) spot.value = { point: hit.point, normal: hit.normal };
            if (hit?.lamp != null) hovered.value = { kind: 'lamp', id: hit.lamp };
        });
    },
    unhover() {
        if (hovered.peek()) hovered.value = null;
    },
    marquee(from: [number, number], to: [number, number], done: boolean) {
        marquee.value = done ? null : { from, to };
        if (!done) return;
        const ids = pickMarks(from, to);
        selection.value = ids.length ? { kind: 'lamp', ids } : null;
        tool.value = null;
    },
};

/** A mark of the overlay near a point: marks are small, fingers and hands are not exact. */
function markAt(x: number, y: number): { kind: 'lamp' | 'meter' | 'grid'; id: Id } | null {
    const svg = document.getElementById('overlay');
    let best: { kind: 'lamp' | 'meter' | 'grid'; id: Id } | null = null;
    let nearest = 11;
    for (const mark of svg?.querySelectorAll<SVGGElement>('.mark:not([display])') ?? []) {
        const at = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(mark.getAttribute('transform') ?? '');
        if (!at) continue;
        const far = Math.hypot(Number(at[1]) - x, Number(at[2]) - y);
        if (far < nearest) {
            nearest = far;
            best = { kind: mark.dataset.kind as 'lamp', id: Number(mark.dataset.id) };
        }
    }
    return best;
}

const TOOL_WORDS: Record<string, string> = {
    aim: 'Click what shall be lit. Esc to leave.',
    place: 'Click the surface on which the lamp shall be. Esc to leave.',
    meter: 'Click where the meter shall lie. Esc to leave.',
    grid: 'Click two opposite corners of the area. Esc to leave.',
    add: 'Click where the lamp shall hang. Esc to leave.',
    marquee: 'Drag around the lamps to select. Esc to leave.',
};

export function View() {
    const area = useRef<HTMLDivElement>(null);
    const canvas = useRef<HTMLCanvasElement>(null);
    const svg = useRef<SVGSVGElement>(null);
    useEffect(() => {
        drawOn(canvas.current);
        const stopOverlay = overlayOn(svg.current as SVGSVGElement);
        const stopPointer = followPointer(area.current as HTMLDivElement, clicks);
        return () => {
            drawOn(null);
            stopOverlay();
            stopPointer();
        };
    }, []);
    useSignalEffect(() => {
        const picture = shown.value;
        canvas.current?.setAttribute('data-kind', picture?.head.kind ?? 'none');
    });
    return (
        <main class="view" aria-label="View">
            <div
                class={tool.value ? 'stage tooled' : 'stage'}
                id="view"
                ref={area}
                tabIndex={0}
                role="application"
                aria-label={`View of ${scene.value?.name ?? 'the scene'}${viewName.value ? `, ${viewName.value}` : ''}`}
                aria-describedby="view-keys"
                data-tool={tool.value ?? ''}
            >
                <canvas ref={canvas} width={640} height={480} aria-hidden="true" />
                <svg id="overlay" ref={svg} aria-hidden="true" />
                <Later part="Gizmo" />
                <Later part="Compare" />
                <Marquee />
            </div>
            <p id="view-keys" class="spoken">
                Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection,
                Escape leaves the view.
            </p>
            {tool.value && <p class="hint" role="status">{TOOL_WORDS[tool.value]}</p>}
            <Banner />
            <Later part="TypedHint" />
            <Later part="Legend" />
            <Later part="CutBar" />
            <Later part="ViewStrip" />
            <Later part="WalkPad" />
            <Later part="What" />
        </main>
    );
}

function Marquee() {
    const now = marquee.value;
    if (!now) return null;
    const { from, to } = now;
    return (
        <svg class="rubber" aria-hidden="true">
            <rect
                x={Math.min(from[0], to[0])}
                y={Math.min(from[1], to[1])}
                width={Math.abs(to[0] - from[0])}
                height={Math.abs(to[1] - from[1])}
            />
        </svg>
    );
}
