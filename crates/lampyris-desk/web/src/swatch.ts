// Light on a display: linear Rec. 709 to what CSS wants, and the way back from `#rrggbb`.

import type { Vec } from './types';

const encode = (x: number): number => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
const decode = (x: number): number => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
const byte = (x: number): number => Math.round(255 * encode(Math.max(0, Math.min(1, x))));

/** A colour as `#rrggbb`, as bright as the display can show it; black stays black. */
export function css(color: Vec): string {
    const most = Math.max(...color, 1e-6);
    return hex(color.map((x) => x / most) as Vec);
}

export function hex(color: Vec): string {
    return `#${color.map((x) => byte(x).toString(16).padStart(2, '0')).join('')}`;
}

export function fromHex(text: string): Vec {
    const part = (k: number) => decode(parseInt(text.slice(1 + 2 * k, 3 + 2 * k), 16) / 255);
    return [part(0), part(1), part(2)];
}

export const mired = (kelvin: number): number => 1e6 / kelvin;
