// Begins: the page is laid out, the keys are heard, the line is opened.

import './css/desk.css';
import { effect } from '@preact/signals';
import { render } from 'preact';
import { Bar } from './bar';
import { drawer } from './actions';
import { followKeys } from './keys';
import { Later, loadWhen } from './load';
import { Lamps } from './lamps';
import { fine, houseLights, lookOnly, panels, theme } from './prefs';
import { state } from './states';
import { StatusLine } from './status';
import { editor, scene } from './store';
import { View } from './view';
import { viewSize } from './navigate';
import { connect, line, role, send } from './wire';

function Desk() {
    return (
        <>
            <Bar />
            <Lamps />
            <View />
            <section class="panel inspector" aria-label="Inspector"><Later part="Inspector" /></section>
            <section class="strip" aria-label="Looks and meters"><Later part="Strip" /></section>
            <StatusLine />
            <Later part="Sheets" />
        </>
    );
}

const root = document.getElementById('desk') as HTMLElement;
root.replaceChildren();
render(<Desk />, root);

effect(() => {
    root.dataset.state = state.value;
    root.dataset.line = line.value;
    root.dataset.pen = role.value === 'edit' && editor.value.you && !lookOnly.value ? 'yes' : 'no';
});
effect(() => {
    root.dataset.panels = panels.value ? 'yes' : 'no';
    root.dataset.drawer = drawer.value ?? 'none';
});
effect(() => {
    document.documentElement.dataset.theme = theme.value;
    document.documentElement.style.setProperty('--house', String(houseLights.value));
});
effect(() => {
    if (scene.value) document.title = `${scene.value.name} – Lampyris`;
});

// The picture has as many pixels as the view; all changes of size but the first wait until it has come to rest.
let sized = 0;
effect(() => {
    const [w, h] = viewSize.value;
    const by = fine.value ? Math.min(devicePixelRatio, 2) : 1;
    if (line.value !== 'open' || role.value === 'watch' || !editor.value.you) return;
    clearTimeout(sized);
    sized = window.setTimeout(() => send({ do: 'size', width: Math.round(w * by), height: Math.round(h * by) }), sized && 60);
});

export * from './desk';

loadWhen();
followKeys();
void connect();
