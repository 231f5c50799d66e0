// What is said of figures beside the numbers: whether they have settled, and whether they reach their targets.

import { maintenance, status, type Grid, type Meter } from '../desk';
import { verdict, type Figure, type Verdict } from './verdict';

/** The picture does not show yet what was changed: figures are of before. */
const moving = () => status.value?.stage === 'moving' || status.value?.stage === 'loading';
const settling = () => moving() || status.value?.stage === 'refining';

/** Share of a figure that its ± may be before it counts as settled. That of an area's mean takes its points to be off all
 * the same way: it is wider than that of a meter. */
const NEAR = { meter: 0.02, grid: 0.05 };

function isPoor(value: number | null | undefined, error: number | null | undefined, near: number): boolean {
    return value == null || error == null || error > near * value || settling();
}

export const meterIsPoor = ({ lux }: Meter): boolean => isPoor(lux?.[0], lux?.[1], NEAR.meter);
export const gridIsPoor = ({ mean, error }: Grid): boolean => isPoor(mean, error, NEAR.grid);

const judged = (figures: Figure[], done: boolean | undefined): Verdict => (moving() ? 'open' : verdict(figures, done === true));

/** Whether a meter reaches its target; null where it has none or reads nothing yet. */
export function meterVerdict({ lux, target, done }: Meter): Verdict | null {
    if (!lux || !target) return null;
    const kept = maintenance.value;
    return judged([{ value: lux[0] * kept, error: lux[1] == null ? null : lux[1] * kept, least: target }], done);
}

/** Whether an area reaches its target, mean and uniformity; null where it has none or reads nothing yet. */
export function gridVerdict({ mean, error, uniformity, uniformity_error, target, done }: Grid): Verdict | null {
    if (!target || mean == null || uniformity == null) return null;
    const kept = maintenance.value;
    return judged([
        { value: mean * kept, error: error == null ? null : error * kept, least: target.lux },
        { value: uniformity, error: uniformity_error ?? null, least: target.uniformity },
    ], done);
}

const MARKS: Record<Verdict, [string, string]> = {
    met: ['✓', 'reaches its target'],
    missed: ['✗', 'misses its target'],
    open: ['≈', 'within its ± of the target: not decided yet'],
};

export function Mark({ of }: { of: Verdict | null }) {
    if (!of) return null;
    const [sign, words] = MARKS[of];
    return <b class={of} role="img" aria-label={words} title={words}>{sign}</b>;
}

/** The same in words. */
export function Said({ of }: { of: Verdict | null }) {
    if (!of) return null;
    const [sign, words] = MARKS[of];
    return <p class={of}>{`${sign} ${words[0].toUpperCase()}${words.slice(1)}`}</p>;
}
