// The tool that the next click in the view serves, and what lamps need of it: where they are, and how they are numbered.

import { signal } from '@preact/signals';
import { tool } from './select';
import type { Hit, Id, Lamp, LampKind, Vec } from './types';
import { middle } from './vec';

/** Which lamp the tool `add` hangs. */
export const adding = signal<LampKind>('spot');

/** What a click with a tool does; comes with the second file. */
let used: (hit: Hit | null) => void = () => {};
export const onTool = (does: typeof used): void => void (used = does);
export const applyTool = (hit: Hit | null): void => used(hit);

export function startTool(which: typeof tool.value): void {
    tool.value = tool.peek() === which ? null : which;
}

/** The next free number of a family. */
export const free = (slice: { ids: { peek(): Id[] } }): Id => Math.max(-1, ...slice.ids.peek()) + 1;

/** Where a lamp is: its own place, or the middle of what it occupies; null for sky and sun. */
export function positionOf(lamp: Lamp): Vec | null {
    if (lamp.kind === 'sky' || lamp.kind === 'parallel') return null;
    return lamp.place?.position ?? (lamp.box ? middle(lamp.box) : null);
}
