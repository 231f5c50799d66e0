// «What lights this»: asks for the share of every lamp at a point, again whenever a lamp gives more or less.

import { effect, signal, untracked } from '@preact/signals';
import { lamps, output } from './store';
import type { Hit, Measured, Share } from './types';
import { ask } from './wire';

interface What {
    x: number;
    y: number;
    hit: Hit;
    lux: Measured | null;
    lamps: Share[];
    done: boolean;
}

export const what = signal<What | null>(null);
let stop = () => {};
let stopWatching = () => {};

export function openWhat(x: number, y: number, hit: Hit): void {
    closeWhat();
    what.value = { x, y, hit, lux: hit.lux, lamps: [], done: false };
    request(hit);
    let first = true;
    let timer = 0;
    // Whenever a lamp gives more or less, the shares are others.
    stopWatching = effect(() => {
        for (const [, lamp] of lamps.all()) void output(lamp);
        if (first) {
            first = false;
            return;
        }
        clearTimeout(timer);
        timer = window.setTimeout(() => {
            const now = untracked(() => what.value);
            if (now) request(now.hit);
        }, 250);
    });
}

function request(hit: Hit): void {
    stop();
    stop = ask('light', { point: hit.point, normal: hit.normal }, (answer) => {
        const now = what.peek();
        if (!now) return;
        what.value = {
            ...now,
            lux: (answer.lux as Measured) ?? now.lux,
            lamps: (answer.lamps as Share[]) ?? now.lamps,
            done: answer.done !== false,
        };
    });
}

export function closeWhat(): void {
    stop();
    stopWatching();
    what.value = null;
}
