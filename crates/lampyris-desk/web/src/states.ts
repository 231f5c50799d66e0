// How things stand, as one word on the root element: what tests wait for and what the banner speaks of.

import { computed, effect, signal } from '@preact/signals';
import { rate, shown } from './frames';
import { dark, editor, lamps, saved, scene, status } from './store';
import { say } from './say';
import { hear, line, role } from './wire';

export type State =
    | 'starting' | 'loading' | 'first' | 'moving' | 'refining' | 'good' | 'done'
    | 'no-lamps' | 'all-off' | 'broken' | 'unsaved' | 'lost' | 'ended' | 'denied' | 'renewed' | 'watching' | 'control-lost' | 'slow';

/** Words of the scene file that could not be read again, or null. */
export const broken = signal<string | null>(null);
/** Edits that no longer find what they changed. */
export const lostEdits = signal<string[]>([]);
/** Who took the pen, as long as it matters. */
export const taken = signal<string | null>(null);
export const loading = signal<{ file?: string; progress?: number; bytes?: number } | null>(null);

export const stage = computed(() => status.value?.stage ?? 'loading');
/** True if for a while far fewer frames have come than the program makes: the line is slow. */
export const slow = signal(false);
let since = 0;
effect(() => {
    const told = status.value?.fps ?? 0;
    const lags = stage.value === 'moving' && told > 6 && rate.value < 0.4 * told && rate.value < 5;
    if (!lags) since = 0;
    else if (!since) since = performance.now();
    slow.value = since > 0 && performance.now() - since > 2000;
});

export const state = computed<State>(() => {
    switch (line.value) {
        case 'entering':
            return 'starting';
        case 'open':
            break;
        default:
            return line.value;
    }
    if (!scene.value || !shown.value) return 'loading';
    if (saved.value.state === 'failed') return 'unsaved';
    if (broken.value !== null) return 'broken';
    if (taken.value !== null && !editor.value.you) return 'control-lost';
    if (role.value === 'watch' || !editor.value.you) return 'watching';
    if (lamps.ids.value.length === 0) return 'no-lamps';
    if (dark.value) return 'all-off';
    if (slow.value) return 'slow';
    if (stage.value === 'loading') return 'first';
    return stage.value;
});

hear('event', (message) => {
    switch (message.what) {
        case 'reloaded': {
            broken.value = null;
            lostEdits.value = (message.lost as string[]) ?? [];
            const kept = (message.kept as number) ?? 0;
            say(`The scene was read again: ${kept} edits kept${lostEdits.value.length ? `, ${lostEdits.value.length} no longer find what they changed` : ''}.`);
            break;
        }
        case 'broken':
            broken.value = (message.why as string) ?? 'The scene file cannot be read.';
            break;
        case 'taken':
            taken.value = (message.by as string) ?? editor.peek().name ?? 'somebody else';
            break;
        case 'loading':
            loading.value = message as { file?: string; progress?: number; bytes?: number };
            break;
    }
});
hear('refused', (message) => say((message.why as string) ?? 'That could not be done.', 'warn'));
effect(() => {
    if (editor.value.you) taken.value = null;
});
