// Pieces that all inspectors are made of: sections, lines with a number, sliders that are one gesture.

import { Field, Gesture, Range, stroke, useRef, type Patch, type Quantity, type Vec } from '../desk';
import type { ComponentChildren } from 'preact';

export function Section({ title, note, children }: { title: string; note?: string; children: ComponentChildren }) {
    return (
        <section class="part" aria-label={title}>
            <h3>{title}{note && <small title={note}>{note}</small>}</h3>
            {children}
        </section>
    );
}

/** The one value of several, or null where they differ. */
export function common<T>(values: T[]): T | null {
    return values.length && values.every((v) => v === values[0]) ? values[0] : null;
}

interface NumberLine {
    label: string;
    /** What it is called where the label stands a line above. */
    name?: string;
    quantity: Quantity;
    value: number | null;
    set: (apply: (old: number) => number) => void;
    step?: number;
    flux?: number;
    disabled?: boolean;
    why?: string;
}

export function Line(props: NumberLine) {
    return (
        <label class="line">
            <span>{props.label}</span>
            <Field {...props} label={props.name ?? props.label} />
        </label>
    );
}

/** Where three stand in a row there is no room for units; a number that is none is a dash. */
function tripleText(value: number | null, quantity: Quantity): string | undefined {
    if (value === null) return undefined;
    if (Number.isNaN(value)) return '–';
    return quantity === 'length' ? value.toFixed(2) : undefined;
}

/** Three numbers in a row. */
export function Triple({ label, names, quantity, value, set, step, disabled }: {
    label: string;
    names?: [string, string, string];
    quantity: Quantity;
    value: (number | null)[];
    set: (axis: number, apply: (old: number) => number) => void;
    step?: number;
    disabled?: boolean;
}) {
    const axes = names ?? ['X', 'Y', 'Z'];
    return (
        <div class="line" role="group" aria-label={label}>
            <span>{label}</span>
            <span class="triple">
                {axes.map((name, k) => (
                    <Field
                        key={name}
                        label={`${label} ${name}`}
                        quantity={quantity}
                        value={value[k]}
                        text={tripleText(value[k], quantity)}
                        step={step}
                        disabled={disabled}
                        set={(apply) => set(k, apply)}
                    />
                ))}
            </span>
        </div>
    );
}

/** A slider whose drag is one step of undo, and whose key strokes are one if they follow each other. */
export function Slide({ label, name, value, text, patch, reset, notch, class: classes, style, disabled }: {
    label: string;
    /** What the step of undo is called. */
    name: string;
    value: number;
    text: string;
    patch: (t: number) => Patch;
    reset?: number;
    notch?: number;
    class?: string;
    style?: string;
    disabled?: boolean;
}) {
    const gesture = useRef<Gesture | null>(null);
    const over = (how: 'end' | 'cancel') => () => {
        gesture.current?.[how]();
        gesture.current = null;
    };
    const set = (t: number) => (gesture.current ? gesture.current.set(patch(t)) : stroke(label + name, name, patch(t)));
    return (
        <Range
            label={label}
            value={value}
            text={text}
            notch={notch}
            class={classes}
            gradient={style}
            disabled={disabled}
            begin={() => (gesture.current = new Gesture(name))}
            on={set}
            end={over('end')}
            cancel={over('cancel')}
            reset={reset === undefined ? undefined : () => set(reset)}
        />
    );
}

/** A name that can be changed. */
export function Name({ value, label, set }: { value: string; label: string; set: (name: string) => void }) {
    return (
        <span class="field name-field">
            <input
                type="text"
                aria-label={label}
                value={value}
                maxLength={120}
                spellcheck={false}
                onChange={(e) => {
                    const name = e.currentTarget.value.trim();
                    if (name && name !== value) set(name);
                    else e.currentTarget.value = value;
                }}
                onKeyDown={(e) => {
                    if (e.key === 'Enter') e.currentTarget.blur();
                    if (e.key !== 'Escape') return;
                    e.stopPropagation();
                    e.currentTarget.value = value;
                    e.currentTarget.blur();
                }}
            />
        </span>
    );
}

/** A vector with one of its numbers changed. */
export const changed = (v: Vec, axis: number, apply: (old: number) => number): Vec =>
    v.map((old, k) => (k === axis ? apply(old) : old)) as Vec;
