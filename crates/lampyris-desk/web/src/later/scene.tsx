// What the inspector shows with nothing selected.

import {
    act, candles, command, digits, edit, Field, filterOf, go, history, hovered, Icon, layers, lookOnly, maintenance, materials,
    percent, scene, select, signal, singleKeys, sub, things, travel, Virtual, workPlane,
} from '../desk';
import { Section } from './parts';

export function SceneTab() {
    const s = scene.value;
    if (!s) return null;
    const size = sub(s.bounds[1], s.bounds[0]);
    return (
        <>
            <Section title="Room">
                <p>{size.map((v) => digits(v, 2)).join(' × ')} m{s.triangles ? `, ${digits(s.triangles)} triangles` : ''}</p>
                <p class="path">{s.file}</p>
                {s.cameras.length > 0 && (
                    <ul class="buttons">
                        {s.cameras.map((camera, k) => (
                            <li key={k}><button onClick={() => go(camera, camera.name ?? 'camera')}>{camera.name || `Camera ${k + 1}`}</button></li>
                        ))}
                    </ul>
                )}
                {s.warnings.length > 0 && (
                    <details>
                        <summary>{s.warnings.length === 1 ? 'One remark' : `${s.warnings.length} remarks`} on the file</summary>
                        <ul class="remarks">{s.warnings.map((text) => <li key={text}>{text}</li>)}</ul>
                    </details>
                )}
            </Section>
            <Section title="Figures">
                <label class="line">
                    <span>Maintenance</span>
                    <Field label="Maintenance factor" quantity="share" value={maintenance.value} step={0.05} set={(apply) => (maintenance.value = Math.max(0.1, Math.min(1, apply(maintenance.value))))} />
                </label>
                <p class="quiet">
                    {maintenance.value === 1 ? 'New installation: figures as they are.' : 'Every figure is multiplied by this.'}
                    {maintenance.value === 1 && <button class="plain" onClick={() => (maintenance.value = 0.8)}>0.80</button>}
                </p>
                <label class="line">
                    <span>Work plane</span>
                    <Field label="Work plane above the floor" quantity="length" value={workPlane.value} step={0.05} set={(apply) => (workPlane.value = Math.max(0, Math.min(3, apply(workPlane.value))))} />
                </label>
                <div class="line">
                    <span>Unit</span>
                    <div class="segments" role="group" aria-label="Unit of illuminance">
                        <button aria-pressed={candles.value === 'lx'} onClick={() => (candles.value = 'lx')}>lx, cd/m²</button>
                        <button aria-pressed={candles.value === 'fc'} onClick={() => (candles.value = 'fc')}>fc, fL</button>
                    </div>
                </div>
            </Section>
            <Section title="Layers of light">
                <ul class="layers">
                    {layers.value.map((layer, k) => (
                        <li key={k} class={layer.batches < layer.of && !layer.held ? 'busy' : ''}>
                            <i class="dot" aria-hidden="true" />
                            <span>{layer.name || `layer ${k + 1}`}</span>
                            <small>{layer.held ? 'held' : percent(layer.of ? layer.batches / layer.of : 0) + ' %'}</small>
                        </li>
                    ))}
                </ul>
            </Section>
            <Section title="Hands">
                <div class="line">
                    <span>Faders</span>
                    <div class="segments" role="group" aria-label="Travel of faders">
                        <button aria-pressed={travel.value === 'square'} onClick={() => (travel.value = 'square')}>Square law</button>
                        <button aria-pressed={travel.value === 'linear'} onClick={() => (travel.value = 'linear')}>Even</button>
                    </div>
                </div>
                <label class="check"><input type="checkbox" checked={singleKeys.value} onChange={(e) => (singleKeys.value = e.currentTarget.checked)} />Keys of one letter</label>
                <label class="check"><input type="checkbox" checked={lookOnly.value} onChange={(e) => (lookOnly.value = e.currentTarget.checked)} />Look only</label>
            </Section>
        </>
    );
}

const wanted = signal('');

function Search({ label }: { label: string }) {
    return (
        <span class="field filter">
            <input type="text" aria-label={label} placeholder="Filter" value={wanted.value} onInput={(e) => (wanted.value = e.currentTarget.value)} />
        </span>
    );
}

export function ThingsTab() {
    const list = filterOf(things, wanted.value);
    return (
        <div class="listing">
            <Search label="Filter things" />
            <Virtual
                label="Things"
                count={list.length}
                height={28}
                row={(k) => {
                    const [id, thing] = list[k];
                    return (
                        <div class="sheet-row thing" role="listitem" key={id} onPointerEnter={() => (hovered.value = { kind: 'thing', id })} onPointerLeave={() => (hovered.value = null)}>
                            <button class="icon" aria-pressed={!thing.hidden} aria-label={`${thing.name} shown`} onClick={() => edit(`${thing.hidden ? 'Show' : 'Hide'} ${thing.name}`, { things: { [id]: { hidden: !thing.hidden } } })}>
                                <Icon name={thing.hidden ? 'eye-off' : 'eye'} />
                            </button>
                            <button class="row-name" onClick={() => select('thing', id)}><span>{thing.name}</span></button>
                            <button class="icon" aria-pressed={thing.locked} aria-label={`${thing.name} locked`} onClick={() => edit(`${thing.locked ? 'Unlock' : 'Lock'} ${thing.name}`, { things: { [id]: { locked: !thing.locked } } })}>
                                <Icon name={thing.locked ? 'lock' : 'unlock'} />
                            </button>
                        </div>
                    );
                }}
            />
        </div>
    );
}

export function MaterialsTab() {
    const list = filterOf(materials, wanted.value);
    return (
        <div class="listing">
            <Search label="Filter materials" />
            <Virtual
                label="Materials"
                count={list.length}
                height={28}
                row={(k) => {
                    const [id, material] = list[k];
                    return (
                        <div class="sheet-row material" role="listitem" key={id}>
                            <button class="row-name" onClick={() => select('material', id)}><span>{material.name}</span></button>
                            <small>{material.kind}{material.reflectance != null ? ` · ρ ${digits(material.reflectance, 2)}` : ''}</small>
                        </div>
                    );
                }}
            />
        </div>
    );
}

export function HistoryTab() {
    const h = history.value;
    return (
        <Section title="History">
            <p>{h.steps === 1 ? 'One step' : `${digits(h.steps)} steps`} so far; all can be undone.</p>
            <button class="plain full" aria-disabled={h.undo === null} onClick={() => act('undo')}><Icon name="undo" />{h.undo ? `Undo: ${h.undo}` : 'Nothing to undo'}</button>
            <button class="plain full" aria-disabled={h.redo === null} onClick={() => act('redo')}><Icon name="redo" />{h.redo ? `Redo: ${h.redo}` : 'Nothing to redo'}</button>
            <button class="plain full" onClick={() => act('save')}>Save a version with a name…</button>
            <button class="plain full" onClick={() => command({ do: 'save' })}>Save now</button>
        </Section>
    );
}
