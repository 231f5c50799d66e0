// The bar on top: what scene this is, what can be taken back, how one looks at it.

import { act, drawer, exposeBy, namedViews, sheet, toggleFalse } from './actions';
import { before, comparing } from './before';
import { show } from './gesture';
import { go } from './navigate';
import { houseLights, lookOnly, theme, walking } from './prefs';
import { display, history, saved, scene } from './store';
import { Field } from './field';
import { Icon } from './icon';
import { Item, Menu } from './menu';
import { Range } from './range';
import { digits } from './units';
import { role, send } from './wire';

function ViewMenu() {
    const named = namedViews();
    return (
        <Menu id="view-menu" label={<>View <Icon name="down" /></>} title="View">
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
        </Menu>
    );
}

const TONES = ['linear', 'reinhard', 'filmic'];

function SeeingMenu() {
    const d = display.value;
    return (
        <Menu id="seeing-menu" label={<>Picture <Icon name="down" /></>} title="Tone and white">
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
                    <Field label="White" quantity="kelvin" value={d.white.kelvin} step={100} set={(apply) => show({ white: { ...d.white, kelvin: apply(d.white.kelvin) } })} />
                </label>
                <label class="line">
                    <span>Tint</span>
                    <Field label="Tint of white" quantity="number" value={d.white.tint} step={1} set={(apply) => show({ white: { ...d.white, tint: apply(d.white.tint) } })} />
                </label>
            </fieldset>
            <hr />
            {['expose', 'darker', 'brighter', 'false-colour', 'quantity', 'units', 'marks', 'fine', 'picture', 'command'].map((id) => <Item key={id} id={id} />)}
        </Menu>
    );
}

function PageMenu() {
    return (
        <Menu id="page-menu" label={<Icon name="menu" />} title="Page">
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
        </Menu>
    );
}

const DOTS: Record<string, string> = {
    clean: 'nothing changed', saved: 'saved', waiting: 'saving…', failed: 'not saved',
};

export function Bar() {
    const d = display.value;
    const undo = history.value.undo;
    const redo = history.value.redo;
    const s = saved.value;
    const metered = d.metered !== null && Math.abs(d.ev - d.metered) < 0.005;
    return (
        <header class="bar">
            <PageMenu />
            <h1 title={s.file || scene.value?.file}>
                {scene.value?.name ?? 'Lampyris'}
                <i class={`dot ${s.state}`} role="img" aria-label={DOTS[s.state]} title={`${DOTS[s.state]}${s.file ? `: ${s.file}` : ''}`} />
            </h1>
            <span class="group">
                <button class="icon" aria-label={undo ? `Undo: ${undo}` : 'Undo'} title={undo ? `Undo: ${undo} (Ctrl+Z)` : 'Nothing to undo'} aria-disabled={undo === null} onClick={() => act('undo')}>
                    <Icon name="undo" />
                </button>
                <button class="icon" aria-label={redo ? `Redo: ${redo}` : 'Redo'} title={redo ? `Redo: ${redo} (Ctrl+Shift+Z)` : 'Nothing to redo'} aria-disabled={redo === null} onClick={() => act('redo')}>
                    <Icon name="redo" />
                </button>
            </span>
            <ViewMenu />
            <span class="group wide">
                <button aria-pressed={false} onClick={() => act('preset-plan')} title="Plan (Shift+1)">Plan</button>
                <button onClick={() => act('inside')} title="Inside (Shift+0)">Inside</button>
            </span>
            <span class="gap" />
            <SeeingMenu />
            <button aria-pressed={d.false_color !== null} onClick={toggleFalse} title="False colour (B)">False colour</button>
            <button aria-pressed={comparing.value === 'wipe'} aria-disabled={before.value === null} onClick={() => act('wipe')} title="Wipe between before and now (C); hold \ to see before">
                Compare
            </button>
            <span class="group exposure" role="group" aria-label="Exposure">
                <button class="icon" aria-label="Darker" title="Darker by ⅓ (,)" onClick={() => exposeBy(1)}><Icon name="minus" /></button>
                <label>
                    <span aria-hidden="true">EV</span>
                    <Field label="Exposure value" quantity="ev" value={d.ev} step={1 / 3} set={(apply) => show({ ev: apply(d.ev) })} />
                </label>
                <button class="icon" aria-label="Brighter" title="Brighter by ⅓ (.)" onClick={() => exposeBy(-1)}><Icon name="plus" /></button>
                <button class="icon" aria-label="Meter once" title={`${metered ? 'As metered' : 'Meter once'} (/); it stays locked`} onClick={() => send({ do: 'expose' })}>
                    <Icon name={metered ? 'lock' : 'meter'} />
                </button>
            </span>
            <button
                class="icon look-lock"
                aria-pressed={lookOnly.value}
                aria-label="Look-only lock"
                title="Look-only lock: no finger changes anything"
                onClick={() => (lookOnly.value = !lookOnly.value)}
            >
                <Icon name={lookOnly.value ? 'lock' : 'unlock'} />
            </button>
            {role.value === 'edit' && <button class="wide" onClick={() => (sheet.value = 'share')}>Share</button>}
            <button class="icon" aria-label="All keys" title="All keys (?)" onClick={() => (sheet.value = 'help')}><Icon name="help" /></button>
            <button class="icon" aria-label="Command palette" title="Command palette (Ctrl+K)" onClick={() => (sheet.value = 'palette')}><Icon name="search" /></button>
            <button
                class="icon narrow"
                aria-label={drawer.value === 'inspector' ? 'Lamps' : 'Inspector'}
                title={drawer.value === 'inspector' ? 'Lamps' : 'Inspector'}
                onClick={() => (drawer.value = drawer.value === 'inspector' ? 'lamps' : 'inspector')}
            >
                <Icon name={drawer.value === 'inspector' ? 'lamps' : 'sliders'} />
            </button>
        </header>
    );
}
