// The bar on top: what scene this is, what can be taken back, how one looks at it.

import { act, drawer, exposeBy, sheet, toggleFalse } from './actions';
import { before, comparing } from './before';
import { show } from './gesture';
import { Later } from './load';
import { lookOnly } from './prefs';
import { display, history, saved, scene } from './store';
import { Field } from './field';
import { Icon } from './icon';
import { Menu } from './menu';
import { role, send } from './wire';

const DOTS: Record<string, string> = {
    clean: 'nothing changed', saved: 'saved', waiting: 'saving…', failed: 'not saved',
};

export function Bar() {
    const d = display.value;
    const undo = history.value.undo;
    const redo = history.value.redo;
    const s = saved.value;
    const metered = d.metered;
    return (
        <header class="bar">
            <Menu id="page-menu" label={<Icon name="menu" />} title="Page"><Later part="PageItems" /></Menu>
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
            <Menu id="view-menu" label={<>View <Icon name="down" /></>} title="View"><Later part="ViewItems" /></Menu>
            <span class="group wide">
                <button aria-pressed={false} onClick={() => act('preset-plan')} title="Plan (Shift+1)">Plan</button>
                <button onClick={() => act('inside')} title="Inside (Shift+0)">Inside</button>
            </span>
            <span class="gap" />
            <Menu id="seeing-menu" label={<>Picture <Icon name="down" /></>} title="Picture: tone, white, figures"><Later part="SeeingItems" /></Menu>
            <button aria-pressed={d.false_color !== null} onClick={toggleFalse} title="False colour (B)">False colour</button>
            <button aria-pressed={comparing.value === 'wipe'} aria-disabled={before.value === null} onClick={() => act('wipe')} title="Wipe between before and now (C); hold \ to see before">
                Compare
            </button>
            <span class="group exposure" role="group" aria-label="Exposure">
                <button class="icon" aria-label="Darker" title="Darker by ⅓ (,)" onClick={() => exposeBy(1)}><Icon name="minus" /></button>
                <label>
                    <span aria-hidden="true">EV</span>
                    <Field label="Exposure value" quantity="ev" value={d.ev ?? 0} step={1 / 3} set={(apply) => show({ ev: apply(d.ev ?? 0) })} />
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
