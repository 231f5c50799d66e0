// What is in the menus of the bar.

import {
    camera, digits, display, Field, go, houseLights, Item, Range, show, theme, walking,
} from '../desk';
import { namedViews } from './actions';

/** Half of a degree in radians. */
const HALF = Math.PI / 360;

function setAngle(fov: number): void {
    const eye = camera.peek();
    if (eye) go({ ...eye, fov: Math.max(3, Math.min(140, fov)) });
}

export function ViewItems() {
    const eye = camera.value;
    const named = namedViews();
    return (
        <>
            {['home', 'frame', 'inside', 'back', 'forth', 'store-view'].map((id) => <Item key={id} id={id} />)}
            <hr />
            {['plan', 'ceiling', 'north', 'east', 'south', 'west'].map((id) => <Item key={id} id={`preset-${id}`} />)}
            <hr />
            {named.length > 0 && <p class="quiet">Cameras of the file and saved views</p>}
            {named.map(({ name, camera }, k) => (
                <button key={k} class="item" onClick={() => go(camera, name)}><span>{name}</span></button>
            ))}
            {named.length > 0 && <hr />}
            {eye && !eye.height && (
                <>
                    <label class="line">
                        <span>Angle</span>
                        <Field label="Vertical angle of view" quantity="angle" value={eye.fov} step={1} set={(apply) => setAngle(apply(eye.fov))} />
                    </label>
                    <label class="line">
                        <span>Focal length</span>
                        <Field label="Focal length on 36 × 24 mm" quantity="number" value={Math.round(120 / Math.tan(eye.fov * HALF)) / 10} text={`${digits(12 / Math.tan(eye.fov * HALF), 1)} mm`} step={1} set={(apply) => setAngle(Math.atan(12 / Math.max(2, apply(12 / Math.tan(eye.fov * HALF)))) / HALF)} />
                    </label>
                    <hr />
                </>
            )}
            <Item id="walking" label={walking.value === 'walk' ? 'Walking; fly instead' : 'Flying; walk instead'} />
            <Item id="from-lamp" />
            {['default', 'blender', 'maya', 'trackpad'].map((id) => <Item key={id} id={`hands-${id}`} />)}
        </>
    );
}

const TONES = ['linear', 'reinhard', 'filmic'];

export function SeeingItems() {
    const d = display.value;
    const white = d.white ?? { kelvin: 6500, tint: 0 };
    return (
        <>
            <fieldset>
                <legend>Tone curve</legend>
                <div class="segments">
                    {TONES.map((tone) => (
                        <button key={tone} aria-pressed={d.tone === tone} onClick={() => show({ tone })}>{tone}</button>
                    ))}
                </div>
            </fieldset>
            <fieldset>
                <legend>White balance</legend>
                <label class="line">
                    <span>White</span>
                    <Field label="White" quantity="kelvin" value={white.kelvin} step={100} set={(apply) => show({ white: { ...white, kelvin: apply(white.kelvin) } })} />
                </label>
                <label class="line">
                    <span>Tint</span>
                    <Field label="Tint of white" quantity="number" value={white.tint} step={1} set={(apply) => show({ white: { ...white, tint: apply(white.tint) } })} />
                </label>
            </fieldset>
            <hr />
            {['expose', 'darker', 'brighter', 'false-colour', 'quantity', 'clamped', 'units', 'marks', 'fine', 'picture', 'command'].map((id) => <Item key={id} id={id} />)}
        </>
    );
}

export function PageItems() {
    return (
        <>
            <label class="line">
                <span>House lights</span>
                <Range label="House lights" value={houseLights.value} text={`${digits(houseLights.value * 100)} %`} on={(t) => (houseLights.value = Math.max(0.3, t))} />
            </label>
            <div class="segments" role="group" aria-label="Theme">
                {(['dark', 'light', 'system'] as const).map((name) => (
                    <button key={name} aria-pressed={theme.value === name} onClick={() => (theme.value = name)}>{name}</button>
                ))}
            </div>
            <hr />
            {['panels', 'travel', 'listing', 'lock', 'palette', 'help', 'save', 'share'].map((id) => <Item key={id} id={id} />)}
        </>
    );
}
