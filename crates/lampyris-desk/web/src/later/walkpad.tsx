// Where there are fingers and no keys: a pad to walk with, at the left lower corner of the view.

import { padWalk, useRef } from '../desk';

export function WalkPad() {
    const knob = useRef<HTMLSpanElement>(null);
    const at = (e: PointerEvent) => {
        const pad = e.currentTarget as HTMLElement;
        e.stopPropagation();
        if (e.type === 'pointerdown') pad.setPointerCapture(e.pointerId);
        const over = e.type === 'pointerup' || e.type === 'pointercancel';
        if (!over && !pad.hasPointerCapture(e.pointerId)) return;
        const box = pad.getBoundingClientRect();
        const clamp = (v: number) => Math.max(-1, Math.min(1, v));
        const x = over ? 0 : clamp((e.clientX - box.left) / (box.width / 2) - 1);
        const y = over ? 0 : clamp(1 - (e.clientY - box.top) / (box.height / 2));
        knob.current?.style.setProperty('transform', `translate(${x * 28}px, ${-y * 28}px)`);
        padWalk(y, x);
    };
    return (
        <div class="walkpad" aria-hidden="true" onPointerDown={at} onPointerMove={at} onPointerUp={at} onPointerCancel={at}>
            <span ref={knob} />
        </div>
    );
}
