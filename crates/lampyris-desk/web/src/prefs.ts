// What this browser remembers: theme, panels, hands. Nothing of a scene is kept here but its maintenance factor.

import { effect, signal, type Signal } from '@preact/signals';

const PREFIX = 'lampyris-';

function pref<T>(name: string, initial: T): Signal<T> {
    let value = initial;
    try {
        const text = localStorage.getItem(PREFIX + name);
        if (text !== null) value = JSON.parse(text) as T;
    } catch {
        // Storage that is shut off or spoiled leaves the default.
    }
    const kept = signal(value);
    effect(() => {
        const text = JSON.stringify(kept.value);
        try {
            localStorage.setItem(PREFIX + name, text);
        } catch {
            // Not remembered, that is all.
        }
    });
    return kept;
}

export type Hands = 'default' | 'blender' | 'maya' | 'trackpad';

export const theme = pref<'dark' | 'light' | 'system'>('theme', 'dark');
/** How bright everything around the picture is, 0.3 to 1. */
export const houseLights = pref('house-lights', 1);
export const hands = pref<Hands>('hands', 'default');
export const walking = pref<'walk' | 'fly'>('walking', 'walk');
export const panels = pref('panels', true);
export const listing = pref<'faders' | 'sheet'>('listing', 'faders');
/** Travel of faders: by the square law, near to how brightness is felt, or even. */
export const travel = pref<'square' | 'linear'>('travel', 'square');
export const candles = pref<'lx' | 'fc'>('candles', 'lx');
export const singleKeys = pref('single-keys', true);
export const lampMarks = pref('lamp-marks', true);
/** Maintenance factor; 1 is a new installation. */
export const maintenance = pref('maintenance', 1);
/** How far above the floor areas are laid [m]. */
export const workPlane = pref('work-plane', 0.75);
/** Full pixels of a fine display, or one per CSS pixel. */
export const fine = pref('fine', false);
/** Seconds of a cross-fade between looks. */
export const fade = pref('fade', 1);
const touch = typeof matchMedia === 'function' && matchMedia('(pointer: coarse)').matches;
/** Looks only: no finger changes anything. On at the first visit by touch. */
export const lookOnly = pref('look-only', touch);
