// A plain slider from 0 to 1: native, so that keys and assistive technology know it; the hand may drag finely with Shift.

import { useRef } from 'preact/hooks';

export interface RangeProps {
    label: string;
    /** 0 to 1. */
    value: number;
    /** The value in words, for those who hear it. */
    text: string;
    on: (value: number) => void;
    begin?: () => void;
    end?: () => void;
    cancel?: () => void;
    /** Double click. */
    reset?: () => void;
    /** What one notch of the wheel and one key stroke are. */
    notch?: number;
    disabled?: boolean;
    class?: string;
    vertical?: boolean;
    /** Colours of the groove. */
    gradient?: string;
    id?: string;
}

let scrolled = -1e9;
addEventListener('scroll', () => (scrolled = performance.now()), { capture: true, passive: true });

const clamp = (t: number) => Math.max(0, Math.min(1, t));

export function Range(props: RangeProps) {
    const element = useRef<HTMLInputElement>(null);
    const drag = useRef<{ id: number; x: number; y: number; at: number } | null>(null);
    const notch = props.notch ?? 0.01;

    const down = (e: PointerEvent) => {
        if (e.button !== 0 || props.disabled) return;
        const box = (e.currentTarget as HTMLElement).getBoundingClientRect();
        const t = props.vertical ? (box.bottom - e.clientY - 8) / (box.height - 16) : (e.clientX - box.left - 6) / (box.width - 12);
        // A finger takes hold where it lands and moves from there; a mouse goes where it points, unless Shift is held.
        const jump = e.pointerType !== 'touch' && !e.shiftKey;
        drag.current = { id: e.pointerId, x: e.clientX, y: e.clientY, at: jump ? clamp(t) : props.value };
        element.current?.setPointerCapture(e.pointerId);
        element.current?.focus();
        props.begin?.();
        if (jump) props.on(clamp(t));
    };
    const move = (e: PointerEvent) => {
        const held = drag.current;
        if (!held || held.id !== e.pointerId) return;
        const box = (e.currentTarget as HTMLElement).getBoundingClientRect();
        const by = props.vertical ? (held.y - e.clientY) / (box.height - 16) : (e.clientX - held.x) / (box.width - 12);
        held.x = e.clientX;
        held.y = e.clientY;
        held.at += by * (e.shiftKey ? 0.1 : 1);
        props.on(clamp(held.at));
    };
    const up = (e: PointerEvent) => {
        if (drag.current?.id !== e.pointerId) return;
        drag.current = null;
        if (e.type === 'pointercancel') props.cancel?.();
        else props.end?.();
    };
    const key = (e: KeyboardEvent) => {
        if (e.key === 'Escape' && drag.current) {
            drag.current = null;
            props.cancel?.();
            e.stopPropagation();
            return;
        }
        const step = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[e.key];
        let t: number | null = null;
        if (step) t = clamp(props.value + step * notch * (e.shiftKey ? 10 : 1));
        if (e.key === 'Home') t = 0;
        if (e.key === 'End') t = 1;
        if (t === null || e.altKey || e.ctrlKey || e.metaKey) return;
        e.preventDefault();
        e.stopPropagation();
        props.on(t);
    };
    const wheel = (e: WheelEvent) => {
        // Whoever scrolls a list past a fader does not mean the fader.
        if (performance.now() - scrolled < 400 || e.ctrlKey) return;
        e.preventDefault();
        const down = Math.abs(e.deltaY) >= Math.abs(e.deltaX) ? e.deltaY : e.deltaX;
        if (down) props.on(clamp(props.value - Math.sign(down) * notch * (e.shiftKey ? 0.2 : 1)));
    };
    return (
        <input
            ref={element}
            type="range"
            id={props.id}
            class={`range ${props.class ?? ''} ${props.vertical ? 'upright' : ''}`}
            min={0}
            max={1}
            step="any"
            value={props.value}
            disabled={props.disabled}
            aria-label={props.label}
            aria-valuetext={props.text}
            style={{ '--t': clamp(props.value), '--gradient': props.gradient ?? '' }}
            onPointerDown={down}
            onPointerMove={move}
            onPointerUp={up}
            onPointerCancel={up}
            onMouseDown={(e) => e.preventDefault()}
            onTouchStart={(e) => e.cancelable && e.preventDefault()}
            onKeyDown={key}
            onWheel={wheel}
            onDblClick={() => props.reset?.()}
            onInput={(e) => {
                if (!drag.current) props.on(Number(e.currentTarget.value));
                else e.currentTarget.value = String(props.value);
            }}
        />
    );
}
