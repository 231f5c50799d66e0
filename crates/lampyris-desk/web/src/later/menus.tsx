// What is in the menus of the bar.

import {
    digits, display, Field, go, houseLights, Item, Range, show, theme, walking,
} from '../desk';
import { namedViews } from './actions';

export function ViewItems() {
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
            {['expose', 'darker', 'brighter', 'false-colour', 'quantity', 'units', 'marks', 'fine', 'picture', 'command'].map((id) => <Item key={id} id={id} />)}
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
