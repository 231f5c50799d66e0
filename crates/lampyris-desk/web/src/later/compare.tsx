// «Before» over the view: whole while a key is held, or left of a line that is dragged.

import { before, comparing, digits, fitted, useEffect, useRef, viewSize, wipeAt } from '../desk';

export function Compare() {
    const mode = comparing.value;
    const kept = before.value;
    const canvas = useRef<HTMLCanvasElement>(null);
    useEffect(() => {
        const target = canvas.current;
        if (!target || !kept) return;
        target.width = kept.picture.width;
        target.height = kept.picture.height;
        target.getContext('2d', { alpha: false })?.drawImage(kept.picture, 0, 0);
    }, [kept, mode]);
    if (!mode || !kept) return null;
    const [width] = viewSize.value;
    const at = wipeAt.value;
    const fit = fitted(kept.picture.width, kept.picture.height);
    const part = Math.max(0, Math.min(1, (at * width - fit.x) / (kept.picture.width * fit.scale)));
    const drag = (e: PointerEvent) => {
        const line = e.currentTarget as HTMLElement;
        e.stopPropagation();
        if (e.type === 'pointerdown') line.setPointerCapture(e.pointerId);
        else if (line.hasPointerCapture(e.pointerId)) {
            const box = (line.parentElement as HTMLElement).getBoundingClientRect();
            wipeAt.value = Math.max(0, Math.min(1, (e.clientX - box.left) / box.width));
        }
    };
    const key = (e: KeyboardEvent) => {
        const by = { ArrowLeft: -0.02, ArrowRight: 0.02 }[e.key];
        if (!by) return;
        e.stopPropagation();
        e.preventDefault();
        wipeAt.value = Math.max(0, Math.min(1, at + by));
    };
    return (
        <>
            <canvas
                ref={canvas}
                class="before"
                aria-hidden="true"
                style={{ clipPath: mode === 'wipe' ? `inset(0 ${100 - 100 * part}% 0 0)` : 'none' }}
            />
            <span class="tag left">before</span>
            {mode === 'wipe' && (
                <div
                    class="wipe"
                    data-handle="wipe"
                    role="slider"
                    tabIndex={0}
                    aria-label="Wipe between before and now"
                    aria-valuemin={0}
                    aria-valuemax={100}
                    aria-valuenow={Math.round(at * 100)}
                    aria-valuetext={`${digits(at * 100)} % before`}
                    style={{ left: `${100 * at}%` }}
                    onPointerDown={drag}
                    onPointerMove={drag}
                    onKeyDown={key}
                />
            )}
        </>
    );
}
