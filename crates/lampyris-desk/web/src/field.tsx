// A number that is typed, with units and sums, or scrubbed by dragging it. Wrong text is explained and changes nothing.

import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { format, parse, type Quantity } from './units';

export interface FieldProps {
    label: string;
    quantity: Quantity;
    /** Null where several differ. */
    value: number | null;
    /** Applies what was typed to each old value. */
    set: (apply: (old: number) => number) => void;
    /** What 100 % are [lm], so that a level may be typed in lumens. */
    flux?: number;
    /** A step of scrubbing and of the arrow keys; 0 for none. */
    step?: number;
    /** Scrubbing as one gesture; absent: each step is an edit of its own. */
    scrub?: { begin: () => void; on: (by: number) => void; end: () => void; cancel: () => void };
    disabled?: boolean;
    why?: string | null;
    /** Text that opens the field, for levels typed without a mouse. */
    open?: string;
    opened?: () => void;
    id?: string;
    tabIndex?: number;
    text?: string;
}

export function Field(props: FieldProps) {
    const draft = useSignal<string | null>(null);
    const wrong = useSignal<string | null>(null);
    const input = useRef<HTMLInputElement>(null);
    const drag = useRef<{ x: number; last: number; moved: boolean } | null>(null);
    const shown = draft.value ?? props.text ?? (props.value === null ? 'mixed' : format(props.value, props.quantity));

    useEffect(() => {
        if (!props.open || !input.current) return;
        draft.value = props.open;
        input.current.focus();
        input.current.setSelectionRange(props.open.length, props.open.length);
        props.opened?.();
    }, [props.open]);

    const commit = () => {
        if (draft.value === null) return;
        const wish = parse(draft.value, props.quantity, props.flux);
        if ('why' in wish) {
            wrong.value = wish.why;
            return;
        }
        draft.value = null;
        wrong.value = null;
        props.set(wish.apply);
    };
    const key = (e: KeyboardEvent) => {
        if (e.key === 'Enter') {
            e.preventDefault();
            commit();
            if (draft.value === null) input.current?.select();
        } else if (e.key === 'Escape') {
            e.stopPropagation();
            if (draft.value === null) input.current?.blur();
            draft.value = null;
            wrong.value = null;
        } else if ((e.key === 'ArrowUp' || e.key === 'ArrowDown') && props.step && draft.value === null) {
            e.preventDefault();
            const by = (e.key === 'ArrowUp' ? 1 : -1) * props.step * (e.shiftKey ? 10 : e.ctrlKey ? 0.1 : 1);
            props.set((old) => old + by);
        }
    };
    const down = (e: PointerEvent) => {
        if (!props.scrub || props.disabled || e.button !== 0 || document.activeElement === input.current) return;
        drag.current = { x: e.clientX, last: e.clientX, moved: false };
        input.current?.setPointerCapture(e.pointerId);
        e.preventDefault();
    };
    const move = (e: PointerEvent) => {
        const held = drag.current;
        if (!held || !props.scrub) return;
        if (!held.moved && Math.abs(e.clientX - held.x) < 4) return;
        if (!held.moved) props.scrub.begin();
        held.moved = true;
        props.scrub.on(((e.clientX - held.last) * (props.step ?? 1)) * (e.shiftKey ? 0.1 : e.altKey ? 10 : 1));
        held.last = e.clientX;
    };
    const up = (e: PointerEvent) => {
        const held = drag.current;
        drag.current = null;
        if (!held) return;
        if (!held.moved) {
            input.current?.focus();
            input.current?.select();
        } else if (e.type === 'pointercancel') props.scrub?.cancel();
        else props.scrub?.end();
    };
    return (
        <span class={`field ${wrong.value ? 'wrong' : ''} ${props.scrub ? 'scrubs' : ''}`}>
            <input
                ref={input}
                id={props.id}
                tabIndex={props.tabIndex}
                type="text"
                inputMode="text"
                autoComplete="off"
                spellcheck={false}
                value={shown}
                disabled={props.disabled}
                title={props.why ?? undefined}
                aria-label={props.label}
                aria-invalid={wrong.value ? true : undefined}
                aria-errormessage={wrong.value ? `${props.id ?? props.label}-why`.replace(/\s/g, '-') : undefined}
                onInput={(e) => {
                    draft.value = e.currentTarget.value;
                    wrong.value = null;
                }}
                onFocus={(e) => draft.value === null && e.currentTarget.select()}
                onBlur={() => {
                    commit();
                    if (wrong.value) {
                        // Leaving a field with wrong text leaves the value as it was, and still says why.
                        draft.value = null;
                        setTimeout(() => (wrong.value = null), 4000);
                    }
                }}
                onKeyDown={key}
                onPointerDown={down}
                onPointerMove={move}
                onPointerUp={up}
                onPointerCancel={up}
            />
            {wrong.value && (
                <span class="why" role="alert" id={`${props.id ?? props.label}-why`.replace(/\s/g, '-')}>{wrong.value}</span>
            )}
        </span>
    );
}
