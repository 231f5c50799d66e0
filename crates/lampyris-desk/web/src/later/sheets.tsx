// Sheets that lie over the page: keys, palette, links, saving.

import {
    allActions, act, ask, command, copyText, digits, go, hear, lamps, say, select, send, sheet, shown, signal,
    useEffect, useLayoutEffect, useRef, walkNames, whyNotTo, type LinkEntry,
} from '../desk';
import type { ComponentChildren } from 'preact';
import { namedViews } from './actions';
import { saveFile } from './csv';
import { qr } from './qr';

function Sheet({ title, wide, children }: { title: string; wide?: boolean; children: ComponentChildren }) {
    const dialog = useRef<HTMLDialogElement>(null);
    // Before the next key: whoever types on at once types into it.
    useLayoutEffect(() => {
        const element = dialog.current as HTMLDialogElement;
        const from = document.activeElement as HTMLElement | null;
        if (!element.open) element.showModal();
        return () => from?.focus();
    }, []);
    const shut = () => (sheet.value = null);
    return (
        <dialog
            ref={dialog}
            class={wide ? 'sheet wide-sheet' : 'sheet'}
            aria-label={title}
            onClose={shut}
            onClick={(e) => e.target === dialog.current && shut()}
        >
            <div class="sheet-body">
                <header>
                    <h2>{title}</h2>
                    <span class="gap" />
                    <button onClick={shut}>Close</button>
                </header>
                {children}
            </div>
        </dialog>
    );
}

const BY_HAND: [string, string, string, string][] = [
    ['Look around', 'right or left drag', 'arrows', 'one finger'],
    ['Walk, up and down', '', 'walking keys, Q E; Shift fast, Alt slow', 'pad at the left'],
    ['Orbit about a point', 'middle or Alt+left drag', 'Shift+arrows', ''],
    ['Pan', 'Shift+middle, Space+left drag', 'Ctrl+arrows', 'two fingers'],
    ['Nearer, farther', 'wheel; Shift goes through', '+ −', 'pinch'],
    ['Select; add; toggle', 'click; Shift; Ctrl', 'Tab in the list, [ ]', 'tap'],
    ['Deeper: group, thing behind', 'click again', '', 'tap again'],
    ['Lux under the pointer', 'hover', 'P lays a meter', ''],
    ['What lights this', 'right click', 'Shift+P', 'long press'],
    ['Level', 'fader, wheel on it; Shift is fine', 'digits Enter; arrows, Shift 10 %', 'fader, two at once'],
    ['Default level', 'double click on the fader', '', ''],
    ['Leave what is open', '', 'Esc', ''],
];

function Help() {
    const groups = [...new Set(allActions().map((action) => action.group))];
    return (
        <Sheet title="All keys" wide>
            <div class="help">
                <table>
                    <caption class="spoken">By hand</caption>
                    <thead><tr><th scope="col">What</th><th scope="col">Mouse</th><th scope="col">Keys, in the view</th><th scope="col">Fingers</th></tr></thead>
                    <tbody>
                        {BY_HAND.map(([what, mouse, keys, touch]) => (
                            <tr key={what}><th scope="row">{what}</th><td>{mouse}</td><td>{keys.replace('walking keys', walkNames.value)}</td><td>{touch}</td></tr>
                        ))}
                    </tbody>
                </table>
                <div class="columns">
                    {groups.map((group) => (
                        <section key={group}>
                            <h3>{group}</h3>
                            <dl>
                                {allActions().filter((action) => action.group === group && action.keys).map((action) => (
                                    <><dt>{action.label}</dt><dd><kbd>{action.keys}</kbd></dd></>
                                ))}
                            </dl>
                        </section>
                    ))}
                    <section>
                        <h3>Numbers</h3>
                        <dl>
                            <dt>Level</dt><dd>80 %, 450 lm, *0.8, +10, -1/2 stop, full, out</dd>
                            <dt>Colour</dt><dd>2700K</dd>
                            <dt>Length</dt><dd>2.4m, 75cm, 8'2", +=0.1</dd>
                            <dt>Angle</dt><dd>30°</dd>
                        </dl>
                    </section>
                </div>
            </div>
        </Sheet>
    );
}

const typed = signal('');
const at = signal(0);

interface Entry {
    label: string;
    note: string;
    why: string | null;
    run: () => void;
}

function entries(): Entry[] {
    const words = typed.value.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = (text: string) => words.every((word) => text.toLowerCase().includes(word));
    const list: Entry[] = allActions()
        .filter((action) => fits(`${action.group} ${action.label}`))
        .map((action) => ({ label: action.label, note: action.keys ?? action.group, why: whyNotTo(action.id), run: () => act(action.id) }));
    for (const { name, camera } of namedViews()) {
        if (fits(`view ${name}`)) list.push({ label: `View: ${name}`, note: 'view', why: null, run: () => go(camera, name) });
    }
    if (words.length) {
        for (const [id, lamp] of lamps.all()) {
            if (list.length > 60) break;
            if (fits(lamp.name)) list.push({ label: lamp.name, note: 'lamp', why: null, run: () => select('lamp', id) });
        }
    }
    return list.slice(0, 60);
}

function Palette() {
    const list = entries();
    const chosen = Math.min(at.value, list.length - 1);
    useEffect(() => {
        typed.value = '';
        at.value = 0;
    }, []);
    useEffect(() => {
        document.getElementById(`command-${chosen}`)?.scrollIntoView({ block: 'nearest' });
    }, [chosen]);
    const run = (entry: Entry | undefined) => {
        if (!entry) return;
        sheet.value = null;
        if (entry.why) say(entry.why, 'warn');
        else setTimeout(entry.run, 0);
    };
    return (
        <Sheet title="Command palette">
            <input
                type="text"
                role="combobox"
                class="command"
                aria-label="Command"
                aria-expanded="true"
                aria-controls="commands"
                aria-activedescendant={list.length ? `command-${chosen}` : undefined}
                aria-autocomplete="list"
                autofocus
                placeholder="What shall be done?"
                value={typed.value}
                onInput={(e) => {
                    typed.value = e.currentTarget.value;
                    at.value = 0;
                }}
                onKeyDown={(e) => {
                    const by = { ArrowDown: 1, ArrowUp: -1 }[e.key];
                    if (by) {
                        e.preventDefault();
                        at.value = (chosen + by + list.length) % Math.max(1, list.length);
                    }
                    if (e.key === 'Enter') {
                        e.preventDefault();
                        run(list[chosen]);
                    }
                }}
            />
            <ul class="commands" id="commands" role="listbox" aria-label="Commands">
                {list.map((entry, k) => (
                    <li
                        key={entry.label + k}
                        id={`command-${k}`}
                        role="option"
                        aria-selected={k === chosen}
                        aria-disabled={entry.why !== null}
                        title={entry.why ?? undefined}
                        onPointerMove={() => (at.value = k)}
                        onClick={() => run(entry)}
                    >
                        <span>{entry.label}</span><kbd>{entry.note}</kbd>
                    </li>
                ))}
                {!list.length && <li class="quiet" role="option" aria-selected="false" aria-disabled="true">Nothing is called so.</li>}
            </ul>
        </Sheet>
    );
}

const links = signal<LinkEntry[]>([]);
hear('links', (message) => (links.value = message.links as LinkEntry[]));

function Code({ text }: { text: string }) {
    const cells = qr(text);
    if (!cells) return null;
    const size = cells.length + 8;
    const path = cells.map((row, y) => row.map((dark, x) => (dark ? `M${x + 4} ${y + 4}h1v1h-1z` : '')).join('')).join('');
    return (
        <svg class="qr" viewBox={`0 0 ${size} ${size}`} role="img" aria-label={`Code of ${text}`}>
            <rect width={size} height={size} fill="#fff" />
            <path d={path} fill="#000" />
        </svg>
    );
}

function Share() {
    const opened = signal<number | null>(null);
    const open = useRef(opened).current;
    useEffect(() => void send({ do: 'links', what: 'list' }), []);
    return (
        <Sheet title="Share by link">
            <p class="quiet">Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is.</p>
            <ul class="links">
                {links.value.map((link) => (
                    <li key={link.id}>
                        <strong>{link.role === 'edit' ? 'Edits' : 'Watches'}</strong>
                        <code>{link.address}</code>
                        <span class="buttons">
                            <button onClick={() => void copyText(link.address)}>Copy</button>
                            <button aria-expanded={open.value === link.id} onClick={() => (open.value = open.value === link.id ? null : link.id)}>Code</button>
                            <button onClick={() => send({ do: 'links', what: 'revoke', id: link.id })}>Revoke</button>
                        </span>
                        {open.value === link.id && <Code text={link.address} />}
                    </li>
                ))}
            </ul>
            <footer>
                <button onClick={() => send({ do: 'links', what: 'make', role: 'watch' })}>New link to watch</button>
                <button onClick={() => send({ do: 'links', what: 'make', role: 'edit' })}>New link to edit</button>
            </footer>
        </Sheet>
    );
}

function Save() {
    const name = useRef<HTMLInputElement>(null);
    const save = () => {
        const text = name.current?.value.trim();
        if (!text) return name.current?.focus();
        command({ do: 'save', name: text });
        sheet.value = null;
        say(`Saving the version “${text}”.`);
    };
    return (
        <Sheet title="Save a version">
            <p class="quiet">Every edit is saved by itself. A version with a name is kept beside.</p>
            <label class="line">
                <span>Name</span>
                <span class="field"><input ref={name} type="text" autofocus maxLength={120} onKeyDown={(e) => e.key === 'Enter' && save()} /></span>
            </label>
            <footer><button onClick={save}>Save</button></footer>
        </Sheet>
    );
}

const progress = signal<number | null>(null);

function Picture() {
    const head = shown.value?.head;
    const form = useRef<HTMLDivElement>(null);
    const value = (name: string) => form.current?.querySelector<HTMLInputElement>(`[name=${name}]`)?.value ?? '';
    const make = () => {
        progress.value = 0;
        const [width, height] = [Number(value('width')), Number(value('height'))];
        ask('picture', { format: value('format'), width, height, batches: Number(value('batches')) }, (answer) => {
            if (answer.why) {
                progress.value = null;
                say(answer.why as string, 'warn');
            } else if (answer.url) {
                progress.value = null;
                saveFile(answer.name as string, answer.url as string);
                sheet.value = null;
            } else progress.value = (answer.progress as number) ?? 0;
        }, (why) => {
            progress.value = null;
            say(why, 'warn');
        });
    };
    return (
        <Sheet title="Save the picture">
            <div ref={form} class="form">
                <label class="line"><span>Format</span><select name="format"><option value="png">PNG, as it is shown</option><option value="exr">EXR, the light itself</option></select></label>
                <label class="line"><span>Width</span><input type="number" name="width" min={16} max={16384} value={Math.max(head?.width ?? 0, 640)} /></label>
                <label class="line"><span>Height</span><input type="number" name="height" min={16} max={16384} value={Math.max(head?.height ?? 0, 480)} /></label>
                <label class="line"><span>Batches</span><input type="number" name="batches" min={1} max={100000} value={64} /></label>
            </div>
            {progress.value !== null && <progress max={1} value={progress.value} aria-label="Rendering" />}
            <footer>
                <button onClick={() => act('command')}>Copy the command</button>
                <button disabled={progress.value !== null} onClick={make}>{progress.value === null ? 'Render and save' : progress.value ? `${digits(progress.value * 100)} %` : 'Rendering…'}</button>
            </footer>
        </Sheet>
    );
}

export function Sheets() {
    switch (sheet.value) {
        case 'help':
            return <Help />;
        case 'palette':
            return <Palette />;
        case 'share':
            return <Share />;
        case 'save':
            return <Save />;
        case 'picture':
            return <Picture />;
        default:
            return null;
    }
}

