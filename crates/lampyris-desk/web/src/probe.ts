// What is under the pointer, asked of the frame that was seen, and in words.

import { signal } from '@preact/signals';
import { toFrame } from './navigate';
import { candles, maintenance } from './prefs';
import { lamps, materials, things } from './store';
import type { Hit } from './types';
import { maintained, signed, three } from './units';
import { ask } from './wire';

export const probe = signal<Hit | null>(null);

export function probeAt(x: number, y: number, then: (hit: Hit | null) => void): void {
    const at = toFrame(x, y);
    if (!at) return then(null);
    ask('point', at, (answer) => then(answer.hit ? (answer as unknown as Hit) : null));
}

/** The probe in words. */
export function probeText(hit: Hit | null): string {
    if (!hit) return '';
    const parts: string[] = [];
    const lamp = lamps.get(hit.lamp)?.name;
    const thing = things.get(hit.thing)?.name;
    const material = materials.get(hit.material)?.name;
    if (lamp) parts.push(lamp);
    if (thing && thing !== lamp) parts.push(thing);
    if (material && material !== thing) parts.push(material);
    if (hit.lux) parts.push(`${maintained(hit.lux[0])} ±${maintained(hit.lux[1], false)}`);
    if (hit.change != null) parts.push(`Δ ${signed(hit.change * maintenance.peek())}`);
    if (hit.luminance) {
        const value = hit.luminance[0] * (candles.value === 'fc' ? 0.2919 : 1);
        parts.push(`${three(value)} ${candles.value === 'fc' ? 'fL' : 'cd/m²'}`);
    }
    return parts.join(' · ');
}
