// Asks for the share of every lamp at the point of «what lights this», again whenever a lamp gives more or less.

import { ask, computed, effect, lamps, output, untracked, what, type Hit, type Measured, type Share } from '../desk';

const point = computed(() => what.value?.hit ?? null);

const request = (hit: Hit): (() => void) => ask('light', { point: hit.point, normal: hit.normal }, (answer) => {
    const now = what.peek();
    if (now?.hit !== hit) return;
    what.value = {
        ...now,
        lux: (answer.lux as Measured) ?? now.lux,
        lamps: (answer.lamps as Share[]) ?? now.lamps,
        done: answer.done !== false,
    };
});

effect(() => {
    const hit = point.value;
    if (!hit) return;
    let stop = untracked(() => request(hit));
    let timer: number | null = null;
    let first = true;
    const stopWatching = effect(() => {
        for (const [, lamp] of lamps.all()) void output(lamp);
        if (timer !== null) clearTimeout(timer);
        if (!first) {
            timer = window.setTimeout(() => {
                stop();
                stop = request(hit);
            }, 250);
        }
        first = false;
    });
    return () => {
        stop();
        stopWatching();
        if (timer !== null) clearTimeout(timer);
    };
});
