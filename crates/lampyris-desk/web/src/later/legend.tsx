// The legend of false colour: always in the picture, its ends are dragged or typed, and nothing ever moves it by itself.

import { asked, candles, DEFAULT_FALSE, display, Field, looks, show, three, useRef, type FalseColor } from '../desk';
import { about } from './differ';

/** The share of light that clamping takes from virtual lights [%]. */
export const CLAMPED: FalseColor = { quantity: 'clamped', low: 0, high: 50, scale: 'linear', palette: 'even', lines: false };

const STEPS = [1, 2, 5];

/** Values of the 1-2-5 series from one end to the other. */
export function ticks(low: number, high: number, scale: 'log' | 'linear'): number[] {
    const out: number[] = [];
    if (scale === 'linear') {
        const rough = (high - low) / 5;
        const ten = 10 ** Math.floor(Math.log10(rough));
        const step = ten * (STEPS.find((s) => s * ten >= rough) ?? 10);
        for (let v = Math.ceil(low / step) * step; v <= high * 1.0001; v += step) out.push(v);
        return out;
    }
    for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); e++) {
        for (const s of STEPS) {
            const v = s * 10 ** e;
            if (v >= low * 0.999 && v <= high * 1.001) out.push(v);
        }
    }
    return out.length > 10 ? out.filter((v) => Math.abs(Math.log10(v) % 1) < 1e-6) : out;
}

export function place(value: number, f: FalseColor): number {
    if (f.scale === 'linear') return (value - f.low) / (f.high - f.low);
    return Math.log(value / f.low) / Math.log(f.high / f.low);
}

const set = (f: FalseColor, change: Partial<FalseColor>) => {
    let next = asked({ ...f, ...change });
    if (next.against != null) next = about(next);
    if (next.scale === 'log') next.low = Math.max(next.low, 1e-3);
    if (next.high > next.low * 1.01) show({ false_color: next });
};

/** 1, 2, 5, 10 …: an end moves by these. */
function along(value: number, by: number): number {
    const e = Math.round(Math.log10(value) * 3) + by;
    const step = ((e % 3) + 3) % 3;
    return STEPS[step] * 10 ** ((e - step) / 3);
}

export function Legend() {
    const f = display.value.false_color;
    const drag = useRef<{ y: number; end: 'low' | 'high'; from: number } | null>(null);
    if (!f) return null;
    const fc = candles.value === 'fc';
    const differs = f.quantity === 'difference';
    const share = f.quantity === 'clamped';
    const illuminance = f.quantity !== 'luminance';
    const unit = share ? '%' : illuminance ? (fc ? 'fc' : 'lx') : fc ? 'fL' : 'cd/m²';
    const factor = fc && !share ? (illuminance ? 1 / 10.7639 : 0.2919) : 1;
    const bar = f.colors?.length ? `linear-gradient(to top, ${f.colors.join(', ')})` : undefined;
    const marks = f.ticks ?? ticks(f.low, f.high, f.scale).map((v) => [v, place(v, f)]);

    const label = (v: number) => {
        const text = String(Number(v.toPrecision(2)));
        return differs ? text.replace('-', '−').replace(/^(?=[1-9]|0\.)/, '+') : text;
    };
    /** Where an end is after so many steps up; of a difference both go apart by them. */
    const moved = (end: 'low' | 'high', from: number, by: number) =>
        differs ? { high: along(Math.abs(from), end === 'low' ? -by : by) } : { [end]: along(from, by) };

    const ends = (end: 'low' | 'high') => ({
        onPointerDown: (e: PointerEvent) => {
            (e.currentTarget as Element).setPointerCapture(e.pointerId);
            drag.current = { y: e.clientY, end, from: f[end] };
        },
        onPointerMove: (e: PointerEvent) => {
            const held = drag.current;
            if (held?.end === end) set(f, moved(end, held.from, Math.round((held.y - e.clientY) / 14)));
        },
        onPointerUp: () => (drag.current = null),
        onPointerCancel: () => (drag.current = null),
        onKeyDown: (e: KeyboardEvent) => {
            const by = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[e.key];
            if (!by) return;
            e.preventDefault();
            e.stopPropagation();
            set(f, moved(end, f[end], by));
        },
    });
    const End = ({ end }: { end: 'low' | 'high' }) => (
        <div class="end">
            {share && end === 'low' ? null : <span
                class="grip"
                role="slider"
                tabIndex={0}
                aria-label={end === 'low' ? 'Lower end of the legend' : 'Upper end of the legend'}
                aria-valuenow={f[end]}
                aria-valuemin={differs ? -1000000 : 0.001}
                aria-valuemax={1000000}
                aria-valuetext={`${three(f[end] * factor)} ${unit}`}
                {...ends(end)}
            />}
            {(differs || share) && end === 'low' ? <output>{label(f.low * factor)}</output> : <Field
                label={end === 'low' ? 'Lower end' : 'Upper end'}
                quantity="number"
                value={Number((f[end] * factor).toPrecision(3))}
                set={(apply) => set(f, { [end]: apply(f[end] * factor) / factor })}
            />}
        </div>
    );
    return (
        <aside class="legend" aria-label="Legend of false colour" data-scroll>
            <header>
                <button
                    aria-label={`${unit}: ${differs ? 'difference' : f.quantity}, change`}
                    onClick={() => (differs || share ? show({ false_color: DEFAULT_FALSE }) : set(f, { quantity: illuminance ? 'luminance' : 'illuminance' }))}
                >
                    {differs ? `Δ ${unit}` : unit}
                </button>
                {!differs && !share && <button aria-pressed={f.scale === 'log'} onClick={() => set(f, { scale: f.scale === 'log' ? 'linear' : 'log' })}>log</button>}
                <button aria-pressed={f.lines} onClick={() => set(f, { lines: !f.lines })}>lines</button>
            </header>
            {share && <p class="quiet" title="What clamping takes from virtual lights close by, of all that comes to the eye. The picture has it: short rays pay it back. While something moves, pictures lack it.">clamped</p>}
            {differs && (
                <p class="quiet" title={f.exact === false ? 'Lamps that differ in the look share a layer of light: what is shown of them is their mean.' : undefined}>
                    {f.exact === false ? '≈ ' : ''}now − {looks.get(f.against)?.name ?? 'look'}
                </p>
            )}
            <End end="high" />
            <div class="scale" style={{ background: bar }}>
                {marks.map(([v, at]) => (
                    <span key={v} style={{ bottom: `${100 * at}%` }}>{label(v * factor)}</span>
                ))}
            </div>
            <End end="low" />
            <footer>
                {differs ? (
                    [50, 500].map((high) => <button key={high} onClick={() => set(f, { high })}>±{high}</button>)
                ) : share ? (
                    [10, 50].map((high) => <button key={high} onClick={() => set(f, { low: 0, high })}>0–{high}</button>)
                ) : (
                    <>
                        <button onClick={() => set(f, { low: 0.1, high: 100, scale: 'log' })}>0.1–100</button>
                        <button onClick={() => set(f, { low: 1, high: 1000, scale: 'log' })}>1–1000</button>
                    </>
                )}
                <select
                    aria-label="Palette"
                    value={f.palette}
                    onChange={(e) => set(f, { palette: e.currentTarget.value })}
                >
                    {f.palettes?.map((name) => <option key={name}>{name}</option>)
                        ?? <option>{f.palette}</option>}
                </select>
            </footer>
        </aside>
    );
}
