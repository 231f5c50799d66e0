// The picture before the last edit, kept in the page: held to see, or wiped over the present one.

import { signal } from '@preact/signals';
import { same } from './camera';
import { shown, snapshot } from './frames';
import { onBegin } from './gesture';
import { say } from './say';
import type { Camera } from './types';

interface Before {
    picture: HTMLCanvasElement;
    camera: Camera;
}
export const before = signal<Before | null>(null);
/** Shown whole, wiped at a share of the width, or not at all. */
export const comparing = signal<'held' | 'wipe' | null>(null);
export const wipeAt = signal(0.5);

/** Keeps the present picture as what was before. */
export function keepBefore(): void {
    const picture = shown.peek();
    const copy = snapshot();
    if (picture && copy) before.value = { picture: copy, camera: picture.camera };
}

/** Before a change; with the wipe open one compares with what was when it was opened. */
export function keepUnlessWiped(): void {
    if (comparing.peek() !== 'wipe') keepBefore();
}

onBegin(keepUnlessWiped);

function usable(): boolean {
    const now = before.peek();
    const picture = shown.peek();
    if (!now || !picture) say('Nothing has been changed yet.');
    else if (!same(now.camera, picture.camera)) say('The picture before was taken from another place: go back there with Alt+←.', 'warn');
    else return true;
    return false;
}

export function compareHeld(held: boolean): void {
    if (!held) {
        if (comparing.peek() === 'held') comparing.value = null;
    } else if (comparing.peek() === null && usable()) comparing.value = 'held';
}

export function toggleWipe(): void {
    comparing.value = comparing.peek() === 'wipe' ? null : usable() ? 'wipe' : null;
}
