// Fetches the second file: with the first picture, or when something is selected before.

import { effect, signal } from '@preact/signals';
import { shown } from './frames';
import { selection } from './select';

type Parts = typeof import('./later/index');
const parts = signal<Parts | null>(null);
let asked = false;

/** A part of the second file, nothing as long as it is not there. */
export function Later({ part }: { part: keyof Parts }) {
    const Part = parts.value?.[part];
    return Part ? <Part /> : null;
}

export function loadWhen(): void {
    effect(() => {
        if (asked || !(shown.value ?? selection.value)) return;
        asked = true;
        // A name in a variable, for the bundler shall leave it alone.
        const file = './gizmo.js';
        setTimeout(() => void import(file).then((module: Parts) => (parts.value = module)), 0);
    });
}
