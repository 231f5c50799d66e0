// What must be known is said over the view, with the way out beside it.

import type { ComponentChildren } from 'preact';
import { act, copyText, sheet } from './actions';
import { edit } from './gesture';
import { notes, unsay } from './say';
import { broken, loading, lostEdits, state, taken } from './states';
import { editor, groups, history, lamps, saved, scene, solo } from './store';
import { adding, startTool } from './tools';
import { retryIn, send } from './wire';
import { clearSolo } from './highlight';
import { Icon } from './icon';
import { digits } from './units';
import { fine } from './prefs';

function Strip({ tone, children }: { tone: 'calm' | 'warn'; children: ComponentChildren }) {
    return (
        <div class={`banner ${tone}`} role={tone === 'warn' ? 'alert' : 'status'}>
            {children}
        </div>
    );
}

/** The command that starts the program again, as far as the page can know it. */
const again = (): string => `lampyris view ${scene.peek()?.file ?? 'SCENE'} --port ${location.port || 80}`;

function turnOn(): void {
    const off = lamps.all().filter(([, lamp]) => !lamp.on || lamp.level === 0 || lamp.parked);
    const shut = groups.all().filter(([, group]) => !group.on || group.level === 0);
    edit('All lamps on', {
        lamps: Object.fromEntries(off.map(([id, lamp]) => [id, { on: true, parked: false, ...(lamp.level === 0 ? { level: 1 } : {}) }])),
        groups: Object.fromEntries(shut.map(([id, group]) => [id, { on: true, ...(group.level === 0 ? { level: 1 } : {}) }])),
    });
}

function words(): ComponentChildren {
    switch (state.value) {
        case 'starting':
            return <Strip tone="calm">Entering…</Strip>;
        case 'loading': {
            const now = loading.value;
            return (
                <Strip tone="calm">
                    Reading {now?.file ?? scene.value?.file ?? 'the scene'}…
                    {now?.bytes ? ` ${digits(now.bytes / 1e6, 1)} MB` : ''}
                    {now?.progress != null && <progress value={now.progress} max={1} aria-label="Reading" />}
                </Strip>
            );
        }
        case 'lost':
            return (
                <Strip tone="warn">
                    Connection lost, trying again{retryIn.value ? ` (${retryIn.value} s)` : '…'}. Until then nothing can be changed.
                </Strip>
            );
        case 'ended':
            return (
                <Strip tone="warn">
                    <span>The program has ended. Start it again with <code>{again()}</code>: this page comes back by itself.</span>
                    <button onClick={() => void copyText(again())}>Copy</button>
                </Strip>
            );
        case 'denied':
            return (
                <Strip tone="warn">
                    This link is not valid (any more). Open the one that the program has printed, or ask for a new one.
                </Strip>
            );
        case 'renewed':
            return (
                <Strip tone="warn">
                    New version. <button onClick={() => location.reload()}>Reload</button>
                </Strip>
            );
        case 'unsaved':
            return (
                <Strip tone="warn">
                    Edits are not being saved: {saved.value.why ?? 'unknown reason'}.
                    <button onClick={() => (sheet.value = 'save')}>Save elsewhere</button>
                </Strip>
            );
        case 'broken':
            return <Strip tone="warn">{broken.value} Still showing what was read before.</Strip>;
        case 'control-lost':
            return (
                <Strip tone="warn">
                    <span>Control moved to <em>{taken.value}</em>.</span> <button onClick={() => send({ do: 'edit', what: 'take' })}>Take it back</button>
                </Strip>
            );
        case 'watching':
            return (
                <Strip tone="calm">
                    <span>You are watching{editor.value.name ? <>; <em>{editor.value.name}</em> edits</> : ''}.</span>
                    <button onClick={() => send({ do: 'edit', what: 'take' })}>Ask for control</button>
                </Strip>
            );
        case 'no-lamps':
            return (
                <Strip tone="calm">
                    This scene has no light. Add:
                    <button
                        onClick={() => {
                            adding.value = 'disc';
                            startTool('add');
                        }}
                    >
                        ceiling lamp
                    </button>
                    <button disabled title="Photometric files come with a later version">IES file</button>
                </Strip>
            );
        case 'all-off':
            return (
                <Strip tone="warn">
                    All lamps are off.
                    {history.value.undo && <button onClick={() => act('undo')}>Undo</button>}
                    <button onClick={turnOn}>Turn on</button>
                </Strip>
            );
        case 'slow':
            return (
                <Strip tone="calm">
                    Slow connection.
                    <button aria-pressed={fine.value} onClick={() => (fine.value = true)}>Sharper</button>
                    <button aria-pressed={!fine.value} onClick={() => (fine.value = false)}>Faster</button>
                </Strip>
            );
        default:
            return null;
    }
}

export function Banner() {
    const alone = solo.value;
    return (
        <div class="banners" data-scroll>
            {words()}
            {lostEdits.value.length > 0 && (
                <Strip tone="calm">
                    <details>
                        <summary>{lostEdits.value.length} edits no longer find what they changed</summary>
                        <ul>{lostEdits.value.map((edit) => <li key={edit}>{edit}</li>)}</ul>
                    </details>
                    <button onClick={() => (lostEdits.value = [])}>Good</button>
                </Strip>
            )}
            {alone.length > 0 && (
                <div class="banner badge" role="status">
                    Solo: {alone.length === 1 ? lamps.get(alone[0])?.name ?? 'one lamp' : `${alone.length} lamps`}
                    <button onClick={clearSolo}>End solo</button>
                </div>
            )}
            <div class="notes" role="status" aria-live="polite">
                {notes.value.map((note) => (
                    <div key={note.id} class={`banner ${note.tone === 'warn' ? 'warn' : 'calm'}`}>
                        {note.text}
                        <button class="icon" aria-label="Close" onClick={() => unsay(note.id)}><Icon name="close" /></button>
                    </div>
                ))}
            </div>
        </div>
    );
}

