// «What lights this»: the point that was asked about, and what is known of it; the second file does the asking.

import { signal } from '@preact/signals';
import type { Hit, Measured, Share } from './types';

export interface What {
    x: number;
    y: number;
    hit: Hit;
    lux: Measured | null;
    lamps: Share[];
    done: boolean;
}

export const what = signal<What | null>(null);

export const openWhat = (x: number, y: number, hit: Hit): void =>
    void (what.value = { x, y, hit, lux: hit.lux, lamps: [], done: false });

export const closeWhat = (): void => void (what.value = null);
