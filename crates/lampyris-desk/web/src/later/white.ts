// Whites: the locus of black bodies, for the groove of a slider. What a lamp really sends out the program reckons.

import { css, mired, type Vec } from '../desk';

/** Linear Rec. 709 of a chromaticity, of luminance 1; what the display cannot show is clipped. */
export function fromXy(x: number, y: number): Vec {
    const [X, Z] = [x / Math.max(y, 1e-6), (1 - x - y) / Math.max(y, 1e-6)];
    const rgb: Vec = [
        3.2404542 * X - 1.5371385 - 0.4985314 * Z,
        -0.969266 * X + 1.8760108 + 0.041556 * Z,
        0.0556434 * X - 0.2040259 + 1.0572252 * Z,
    ];
    return rgb.map((v) => Math.max(0, v)) as Vec;
}

/** Chromaticity of a black body, 1667 to 25 000 K: the cubic splines of Kim et al. (2002). */
export function planck(kelvin: number): [number, number] {
    const t = 1000 / Math.max(1667, Math.min(25000, kelvin));
    const x = kelvin <= 4000
        ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991
        : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039;
    const y = kelvin <= 2222
        ? -1.1063814 * x ** 3 - 1.3481102 * x ** 2 + 2.18555832 * x - 0.20219683
        : kelvin <= 4000
          ? -0.9549476 * x ** 3 - 1.37418593 * x ** 2 + 2.09137015 * x - 0.16748867
          : 3.081758 * x ** 3 - 5.8733867 * x ** 2 + 3.75112997 * x - 0.37001483;
    return [x, y];
}

/** The whites of a slider, even in mired, as a gradient. */
export function gradient(low: number, high: number, stops = 9): string {
    const colors = Array.from({ length: stops }, (_, k) => {
        const m = mired(low) + ((mired(high) - mired(low)) * k) / (stops - 1);
        return css(fromXy(...planck(1e6 / m)));
    });
    return `linear-gradient(to right, ${colors.join(', ')})`;
}
