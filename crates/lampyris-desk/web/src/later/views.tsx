// The strip of views: home, before and after, and the saved ones by number.

import { act, cut, digits, edit, go, Icon, Range, setCut, signal, storeView, viewName, views } from '../desk';

/** The view whose name is being typed. */
const renaming = signal<number | null>(null);

export function ViewStrip() {
    const saved = views.all();
    return (
        <nav class="view-strip" aria-label="Views" data-scroll>
            <button class="icon" aria-label="Home" title="Home" onClick={() => act('home')}><Icon name="home" /></button>
            <button class="icon" aria-label="Frame the selection" title="Frame the selection (F)" onClick={() => act('frame')}><Icon name="frame" /></button>
            <button class="icon" aria-label="The view before" title="The view before (Alt+←)" onClick={() => act('back')}><Icon name="back" /></button>
            <button class="icon" aria-label="The view after" title="The view after (Alt+→)" onClick={() => act('forth')}><Icon name="forth" /></button>
            <span class="divide" />
            {saved.map(([id, camera], k) => (renaming.value === id ? (
                <span class="field" key={id}>
                    <input
                        type="text"
                        aria-label="Name of the view"
                        value={camera.name ?? ''}
                        maxLength={60}
                        ref={(input) => input?.focus()}
                        onBlur={(e) => {
                            const name = e.currentTarget.value.trim();
                            renaming.value = null;
                            if (name && name !== camera.name) edit(`Rename the view ${name}`, { views: { [id]: { ...camera, name } } });
                        }}
                        onKeyDown={(e) => {
                            e.stopPropagation();
                            if (e.key === 'Escape') e.currentTarget.value = camera.name ?? '';
                            if (e.key === 'Enter' || e.key === 'Escape') e.currentTarget.blur();
                        }}
                    />
                </span>
            ) : (
                <button
                    key={id}
                    class="saved-view"
                    aria-pressed={viewName.value === camera.name}
                    title={`${camera.name ?? 'View'} (Alt+${k + 1}); double click or F2 renames, Delete removes`}
                    onClick={() => go(camera, camera.name ?? 'view')}
                    onDblClick={() => (renaming.value = id)}
                    onKeyDown={(e) => {
                        if (e.key === 'F2') renaming.value = id;
                        if (e.key !== 'Delete') return;
                        e.stopPropagation();
                        edit(`Remove the view ${camera.name ?? ''}`, { views: { [id]: null } });
                    }}
                >
                    <small>{k + 1}</small> {camera.name ?? `View ${id + 1}`}
                </button>
            )))}
            <button class="icon" aria-label="Store this view" title="Store this view (Alt+0)" onClick={storeView}><Icon name="plus" /></button>
        </nav>
    );
}

/** Where plan and elevations are cut: a camera's affair, the light stays as it is. */
export function CutBar() {
    const now = cut.value;
    if (!now) return null;
    const told = now.height === null ? `${digits(now.value, 2)} m` : `at ${digits(now.height, 2)} m`;
    return (
        <label class="cut" data-scroll>
            <span>Cut</span>
            <Range
                label="Cut, from the side of the eye"
                value={now.value / now.most}
                text={told}
                on={(t) => setCut(t * now.most)}
            />
            <output>{told}</output>
        </label>
    );
}
