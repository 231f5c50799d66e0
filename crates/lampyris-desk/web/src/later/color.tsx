// The colour of lamps: as the file says, by temperature and tint, by RGB, or by chromaticity. Each way keeps its values,
// and all but the first keep the lamp's lumens.

import {
    chosenLamps, digits, edit, fromHex, hex, lamps, mired, titleOf,
    type Color, type ColorMode, type Id, type Lamp, type Patch, type Vec,
} from '../desk';
import { gradient } from './white';
import { common, Line, Slide, Triple } from './parts';

const WARM = 1800;
const COLD = 10000;
const WHITES: [number, string][] = [[2200, 'candle'], [2700, 'warm'], [3000, 'warm white'], [4000, 'neutral'], [5000, 'cool'], [6500, 'daylight']];
const MODES: [ColorMode, string][] = [['file', 'File'], ['kelvin', 'White'], ['rgb', 'RGB'], ['xy', 'x y']];
const whites = gradient(WARM, COLD);

/** The same change of colour for all. */
const each = (ids: Id[], change: (color: Color) => Partial<Color>): Patch => ({
    lamps: Object.fromEntries(ids.map((id) => [id, { color: change((lamps.get(id) as Lamp).color) }])),
});

const toKelvin = (t: number): number => {
    const kelvin = 1e6 / (mired(WARM) + (mired(COLD) - mired(WARM)) * t);
    return Math.round(kelvin / 10) * 10;
};
const toTravel = (kelvin: number): number => (mired(kelvin) - mired(WARM)) / (mired(COLD) - mired(WARM));

export function ColorPart() {
    const ids = chosenLamps.value;
    const colors = ids.map((id) => lamps.get(id)?.color).filter((c) => c !== undefined);
    if (!colors.length) return null;
    const mode = common(colors.map((c) => c.mode));
    const first = colors[0];
    const title = titleOf(ids);
    const set = (label: string, change: (color: Color) => Partial<Color>) => edit(`${title}: ${label}`, each(ids, change));
    return (
        <>
            <div class="line">
                <span>Colour</span>
                <div class="segments" role="group" aria-label="Colour by">
                    {MODES.map(([id, name]) => (
                        <button key={id} aria-pressed={mode === id} onClick={() => set(`colour by ${name}`, () => ({ mode: id }))}>{name}</button>
                    ))}
                </div>
            </div>
            {mode === 'kelvin' && (
                <>
                    <div class="line slide">
                        <span>White</span>
                        <Slide
                            label="Colour temperature"
                            name={`${title}: white`}
                            class="mired"
                            style={whites}
                            value={toTravel(first.kelvin)}
                            text={`${digits(first.kelvin)} kelvin`}
                            patch={(t) => each(ids, () => ({ mode: 'kelvin', kelvin: toKelvin(t) }))}
                        />
                    </div>
                    <Line
                        label=""
                        name="Colour temperature, typed"
                        quantity="kelvin"
                        value={common(colors.map((c) => c.kelvin))}
                        step={50}
                        set={(apply) => set('white', (c) => ({ mode: 'kelvin', kelvin: apply(c.kelvin) }))}
                    />
                    <div class="whites" role="group" aria-label="Whites">
                        {WHITES.map(([kelvin, name]) => (
                            <button key={kelvin} title={name} aria-label={`${kelvin} kelvin, ${name}`} onClick={() => set(`${kelvin} K`, () => ({ mode: 'kelvin', kelvin }))}>{kelvin}</button>
                        ))}
                    </div>
                    <div class="line slide">
                        <span title="Duv × 1000: below magenta, above green">Tint</span>
                        <Slide
                            label="Tint, magenta to green"
                            name={`${title}: tint`}
                            class="tints"
                            value={(first.tint + 20) / 40}
                            text={`${digits(first.tint, 1)} thousandths`}
                            notch={0.025}
                            reset={0.5}
                            patch={(t) => each(ids, () => ({ tint: Math.round((t * 40 - 20) * 2) / 2 }))}
                        />
                    </div>
                    <Line label="" name="Tint, typed" quantity="number" value={common(colors.map((c) => c.tint))} step={1} set={(apply) => set('tint', (c) => ({ tint: Math.max(-50, Math.min(50, apply(c.tint))) }))} />
                </>
            )}
            {mode === 'rgb' && (
                <>
                    <label class="line">
                        <span>Colour</span>
                        <input type="color" class="pick" aria-label="Colour" value={hex(first.rgb)} onChange={(e) => set('colour', () => ({ mode: 'rgb', rgb: fromHex(e.currentTarget.value) }))} />
                    </label>
                    <Triple
                        label="Linear"
                        names={['R', 'G', 'B']}
                        quantity="number"
                        step={0.01}
                        value={first.rgb}
                        set={(axis, apply) => set('colour', (c) => ({ rgb: c.rgb.map((v, k) => (k === axis ? Math.max(0, apply(v)) : v)) as Vec }))}
                    />
                </>
            )}
            {mode === 'xy' && (
                <div class="line" role="group" aria-label="Chromaticity">
                    <span>x, y</span>
                    <span class="triple">
                        {[0, 1].map((axis) => (
                            <Line
                                key={axis}
                                label={'xy'[axis]}
                                quantity="number"
                                step={0.001}
                                value={common(colors.map((c) => c.xy[axis]))}
                                set={(apply) => set('chromaticity', (c) => ({ xy: c.xy.map((v, k) => (k === axis ? Math.max(0.01, Math.min(0.9, apply(v))) : v)) as [number, number] }))}
                            />
                        ))}
                    </span>
                </div>
            )}
            {mode === null && <p class="quiet">Colours are given in several ways; choosing one sets it for all.</p>}
        </>
    );
}
