// Numbers with units, as people type them: `2700K`, `450 lm`, `30°`, `80 %`, `*0.8`, `+10`, `-1/2 stop`, `2.4m`, `8'2"`.
// A field that does not understand says why and keeps what it had.

import { candles, maintenance } from './prefs';

export type Quantity = 'level' | 'flux' | 'kelvin' | 'angle' | 'length' | 'lux' | 'share' | 'number' | 'ev' | 'seconds';
/** What a text wants: a value, or a change of each value that there is. */
export type Wish = { apply: (old: number) => number } | { why: string };

interface Rules {
    /** What a bare number is multiplied by. */
    bare: number;
    /** Units and what they are worth. */
    units: Record<string, number>;
    low: number;
    high: number;
    say: string;
}

const FOOT = 0.3048;
const RULES: Record<Quantity, Rules> = {
    level: { bare: 0.01, units: { '%': 0.01, x: 1, '×': 1 }, low: 0, high: 1000, say: 'a level such as 80 % or 450 lm' },
    flux: { bare: 1, units: { lm: 1, klm: 1000 }, low: 0, high: 1e9, say: 'a flux such as 450 lm' },
    kelvin: { bare: 1, units: { k: 1 }, low: 1000, high: 25000, say: 'a colour temperature such as 2700 K' },
    angle: { bare: 1, units: { '°': 1, deg: 1, rad: 180 / Math.PI }, low: -36000, high: 36000, say: 'an angle such as 30°' },
    length: {
        bare: 1,
        units: { m: 1, cm: 0.01, mm: 0.001, km: 1000, ft: FOOT, "'": FOOT, in: FOOT / 12, '"': FOOT / 12 },
        low: -1e6, high: 1e6, say: 'a length such as 2.4 m, 75 cm or 8\'2"',
    },
    lux: { bare: 1, units: { lx: 1, klx: 1000, fc: 10.7639 }, low: 0, high: 1e9, say: 'an illuminance such as 500 lx' },
    share: { bare: 1, units: { '%': 0.01 }, low: 0, high: 1, say: 'a share from 0 to 1 or 0 to 100 %' },
    number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: 'a number' },
    ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: 'an exposure such as 8.3' },
    seconds: { bare: 1, units: { s: 1, ms: 0.001, min: 60 }, low: 0, high: 3600, say: 'a time such as 2 s' },
};

const NUMBER = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;

/** A number, perhaps a fraction such as 1/2, at the start of a text. */
function leading(text: string): { value: number; rest: string } | null {
    const found = NUMBER.exec(text);
    if (!found) return null;
    const [above, below] = found[0].split('/').map(Number);
    if (below === 0) return null;
    return { value: below === undefined ? above : above / below, rest: text.slice(found[0].length).trimStart() };
}

/** Sums such as 8'2" or 2.4m + 30cm; null if it is none. */
function amount(text: string, rules: Rules, bare: number): number | null {
    let rest = text.trim();
    let sum = 0;
    let first = true;
    while (rest) {
        let sign = 1;
        const operator = /^[+-]\s*/.exec(rest);
        if (operator && !first) {
            sign = rest[0] === '-' ? -1 : 1;
            rest = rest.slice(operator[0].length);
        }
        const number = leading(rest);
        if (!number) return null;
        const unit = /^[a-zµ°%'"×]+/i.exec(number.rest)?.[0] ?? '';
        // 8'2" runs together: a unit of one sign ends where digits begin.
        const factor = unit === '' ? bare : rules.units[unit.toLowerCase()];
        if (factor === undefined) return null;
        sum += sign * number.value * factor;
        rest = number.rest.slice(unit.length).trim();
        first = false;
    }
    return first ? null : sum;
}

/**
 * What a text means for a quantity. `flux` is what 100 % of a level are [lm]. A sign in front makes it relative where
 * `signed` is false, for nobody types a level of minus ten; lengths and angles have signs of their own, there `+=` and
 * `-=` are relative.
 */
export function parse(text: string, quantity: Quantity, flux?: number): Wish {
    const rules = RULES[quantity];
    const source = text.trim().replace(/,(?=\d)/g, '.').replace(/[\u2009\u202f\u00a0]/g, '').replace(/−/g, '-');
    const wrong: Wish = { why: `“${text.trim()}” is not ${rules.say}` };
    const within = (apply: (old: number) => number): Wish => ({
        apply: (old) => Math.min(rules.high, Math.max(rules.low, apply(old))),
    });
    if (!source) return { why: `Type ${rules.say}` };
    const word = source.toLowerCase();
    if (quantity === 'level' && word === 'full') return within(() => 1);
    if (quantity === 'level' && (word === 'out' || word === 'off')) return within(() => 0);

    const stops = /^(.*?)\s*(?:stops?|ev)$/i.exec(source);
    if (stops && quantity !== 'ev') {
        const by = leading(stops[1].trim());
        if (!by || by.rest || !['level', 'flux', 'lux', 'number'].includes(quantity)) return wrong;
        return within((old) => old * 2 ** by.value);
    }
    const times = /^([*/×÷])\s*(.+)$/.exec(source);
    if (times) {
        const by = leading(times[2]);
        if (!by) return wrong;
        const percent = by.rest === '%' ? 0.01 : by.rest === '' ? 1 : NaN;
        const factor = by.value * percent;
        if (!Number.isFinite(factor) || (factor === 0 && /[/÷]/.test(times[1]))) return wrong;
        return within((old) => (/[/÷]/.test(times[1]) ? old / factor : old * factor));
    }
    const signed = quantity === 'length' || quantity === 'angle' || quantity === 'ev' || quantity === 'number';
    const relative = signed ? /^([+-])=\s*(.+)$/.exec(source) : /^([+-])=?\s*(.+)$/.exec(source);
    const body = relative ? relative[2] : source;

    let value = amount(body, rules, rules.bare);
    if (value === null && quantity === 'level' && flux) {
        const lumens = amount(body, { ...RULES.flux }, NaN);
        value = lumens === null || Number.isNaN(lumens) ? null : lumens / flux;
    }
    if (value === null || !Number.isFinite(value)) return wrong;
    const wanted = value;
    if (relative) return within((old) => (relative[1] === '-' ? old - wanted : old + wanted));
    if (wanted < rules.low || wanted > rules.high) {
        return { why: `${text.trim()} is out of range: ${rules.say}` };
    }
    return within(() => wanted);
}

/** Digits in groups of three, with a fixed number of decimals. */
export function digits(value: number, decimals = 0): string {
    if (!Number.isFinite(value)) return '–';
    const [whole, part] = Math.abs(value).toFixed(decimals).split('.');
    const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole;
    const sign = value < 0 && Number(Math.abs(value).toFixed(decimals)) !== 0 ? '−' : '';
    return sign + grouped + (part ? `.${part}` : '');
}

/** As many decimals as three digits need. */
export function three(value: number): string {
    const size = Math.abs(value);
    return digits(value, size >= 99.95 || size === 0 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 ? 2 : 3);
}

/** A level in per cent: whole, but with decimals below one. */
export function percent(level: number): string {
    const p = level * 100;
    return digits(p, p >= 9.95 || p === 0 ? 0 : p >= 0.95 ? 1 : 2);
}

export function format(value: number, quantity: Quantity): string {
    switch (quantity) {
        case 'level':
            return `${percent(value)} %`;
        case 'flux':
            return `${three(value)} lm`;
        case 'kelvin':
            return `${digits(value)} K`;
        case 'angle':
            return `${digits(value, 1)}°`;
        case 'length':
            return `${digits(value, 2)} m`;
        case 'lux':
            return `${three(value)} lx`;
        case 'seconds':
            return `${digits(value, 1)} s`;
        case 'ev':
            return digits(value, 1);
        case 'share':
            return digits(value, 2);
        case 'number':
            return String(Math.round(value * 1e4) / 1e4);
    }
}

/** A difference of illuminance, with its sign. */
export const signed = (lux: number): string => (lux > 0 ? '+' : '') + luxText(lux);

/** Illuminance in the unit that the user has chosen. */
export function luxText(lux: number, unit = true): string {
    const fc = candles.value === 'fc';
    const value = fc ? lux / 10.7639 : lux;
    return three(value) + (unit ? (fc ? ' fc' : ' lx') : '');
}

/** Illuminance that was measured, as it is maintained. */
export const maintained = (lux: number, unit = true): string => luxText(lux * maintenance.value, unit);
