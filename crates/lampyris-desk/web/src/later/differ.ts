// The difference to a look: false colour of how much more or less light surfaces receive.

import type { FalseColor, Id } from '../desk';

/** Now less the look, from -500 to +500 lx. */
export const difference = (look: Id): FalseColor => ({
    quantity: 'difference', against: look, low: -500, high: 500, scale: 'linear', palette: 'diverging', lines: false,
});

/** A legend about zero with an end elsewhere: the other goes with it. */
export function about(f: FalseColor): FalseColor {
    const high = Math.min(1e6, Math.max(0.01, f.high));
    return { ...f, low: -high, high, scale: 'linear' };
}
