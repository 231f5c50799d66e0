// Whether figures reach what was asked of them, as far as their ± allows that to be said.

export type Verdict = 'met' | 'missed' | 'open';

/** A figure that is to be `least` or more, and how far off it may be; null where that is not known. */
export interface Figure {
    value: number;
    error: number | null;
    least: number;
}

/**
 * Met where all figures are, wherever within their ± the truth lies; missed where one is missed wherever it lies; open
 * between. Figures that no batch will change (`final`) are compared as they are.
 */
export function verdict(figures: Figure[], final: boolean): Verdict {
    const single = ({ value, error, least }: Figure): Verdict => {
        const off = final ? 0 : (error ?? Infinity);
        if (value - off >= least) return 'met';
        return value + off < least ? 'missed' : 'open';
    };
    const all = figures.map(single);
    if (all.includes('missed')) return 'missed';
    return all.includes('open') ? 'open' : 'met';
}
