// The inspector: what is selected, or, with nothing selected, the scene, its things, its materials, the history.

import { act, deselect, Icon, penless, selection, signal } from '../desk';
import { GridInspector, MeterInspector } from './measure';
import { LampInspector } from './lamp';
import { HistoryTab, MaterialsTab, SceneTab, ThingsTab } from './scene';
import { MaterialInspector, ThingInspector } from './thing';

const TABS = ['Scene', 'Things', 'Materials', 'History'] as const;
const tab = signal<(typeof TABS)[number]>('Scene');

function Nothing() {
    const Part = { Scene: SceneTab, Things: ThingsTab, Materials: MaterialsTab, History: HistoryTab }[tab.value];
    const key = (e: KeyboardEvent) => {
        const by = { ArrowRight: 1, ArrowLeft: -1 }[e.key];
        if (!by) return;
        e.preventDefault();
        e.stopPropagation();
        tab.value = TABS[(TABS.indexOf(tab.value) + by + TABS.length) % TABS.length];
        document.getElementById(`tab-${tab.value}`)?.focus();
    };
    return (
        <>
            <div class="tabs" role="tablist" aria-label="Nothing is selected" onKeyDown={key}>
                {TABS.map((name) => (
                    <button key={name} id={`tab-${name}`} role="tab" aria-selected={tab.value === name} aria-controls="tab-panel" tabIndex={tab.value === name ? 0 : -1} onClick={() => (tab.value = name)}>
                        {name}
                    </button>
                ))}
            </div>
            <div class="scroll" id="tab-panel" role="tabpanel" aria-labelledby={`tab-${tab.value}`} tabIndex={0}>
                <Part />
            </div>
        </>
    );
}

export function Inspector() {
    const now = selection.value;
    if (!now) return <Nothing />;
    return (
        <>
            <nav class="chooser" aria-label="Selection">
                <button class="icon" aria-label="Previous" title="Previous ([)" onClick={() => act('previous')}><Icon name="back" /></button>
                <button class="icon" aria-label="Next" title="Next (])" onClick={() => act('next')}><Icon name="forth" /></button>
                <span class="quiet">{now.ids.length > 1 ? `${now.ids.length} ${now.kind}s` : now.kind}</span>
                <span class="gap" />
                <button class="icon" aria-label="Select nothing" title="Select nothing (Esc)" onClick={deselect}><Icon name="close" /></button>
            </nav>
            {penless.value && <p class="penless">{penless.value}</p>}
            <fieldset class="editing" disabled={penless.value !== null}>
                {(now.kind === 'lamp' || now.kind === 'group') && <LampInspector />}
                {now.kind === 'thing' && <ThingInspector />}
                {now.kind === 'material' && <MaterialInspector />}
                {now.kind === 'meter' && <MeterInspector />}
                {now.kind === 'grid' && <GridInspector />}
            </fieldset>
        </>
    );
}
