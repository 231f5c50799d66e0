// Fetches the second file: with the first picture, or when something is selected before.

import { effect, signal } from '@preact/signals';
import { shown } from './frames';
import { selection } from './select';

type Parts = typeof import('./later/index');
const parts = signal<Parts | null>(null);
let asked = false;
let tries = 0;

/** A part of the second file, or nothing as long as it is not there. */
export const part = <K extends keyof Parts>(name: K): Parts[K] | undefined => parts.value?.[name];

/** The same, where it needs nothing to be shown. */
export function Later({ part: name }: { part: Exclude<keyof Parts, 'SheetRow'> }) {
    const Part = part(name);
    return Part ? <Part /> : null;
}

export function loadWhen(): void {
    effect(() => {
        if (asked || !(shown.value ?? selection.value)) return;
        asked = true;
        // A name in a variable, for the bundler shall leave it alone. Where it does not come, as when the program ends just
        // then, the next picture asks again, by another name: browsers may keep that the first failed.
        const file = `./gizmo.js${tries++ ? `?${tries}` : ''}`;
        setTimeout(() => void import(file).then((module: Parts) => (parts.value = module), () => (asked = false)), 0);
    });
}
