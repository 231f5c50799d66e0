// Everything one can do has a name: the menus, the palette, the keys and the help sheet all read one list
// (later/actions.ts). Here is how it is done, and what the bar does before the list is there.

import { signal } from '@preact/signals';
import { keepUnlessWiped } from './before';
import { edit, show, whyNot } from './gesture';
import { here } from './navigate';
import { say } from './say';
import { display, looks, views } from './store';
import { free } from './tools';
import type { FalseColor, Patch } from './types';
import { send } from './wire';

export interface Action {
    id: string;
    label: string;
    group: string;
    /** Keys as the help sheet shows them. */
    keys?: string;
    run: () => void;
    /** Absent: always. Otherwise why it cannot be done now, or null. */
    why?: () => string | null;
}

/** Which sheet lies over the page. */
export const sheet = signal<'help' | 'palette' | 'share' | 'save' | 'picture' | 'ended' | null>(null);
/** The panel that is open where there is room for one only. */
export const drawer = signal<'lamps' | 'inspector' | null>('lamps');
/** Counts up when the level field of the selection shall take the keys. */
export const wantLevel = signal('');

/** Sends what is no gesture but changes the scene. */
export function command(message: { do: string } & Record<string, unknown>): void {
    const why = whyNot();
    if (why) return say(why, 'warn');
    if (message.do === 'look' ? message.what === 'recall' : message.do !== 'save') keepUnlessWiped();
    send(message);
}

export const each = (ids: number[], patch: Patch): Patch => Object.fromEntries(ids.map((id) => [id, patch]));

export const DEFAULT_FALSE: FalseColor = {
    quantity: 'illuminance', low: 1, high: 1000, scale: 'log', palette: 'even', lines: false,
};
let lastFalse: FalseColor = DEFAULT_FALSE;

/** What is asked of the program: all but what it says besides. */
export const asked = ({ quantity, low, high, scale, palette, lines, against }: FalseColor): FalseColor => ({ quantity, low, high, scale, palette, lines, against });

/** The false colour that is shown, or was last. */
export const falseColor = (): FalseColor => display.peek().false_color ?? lastFalse;

export function toggleFalse(): void {
    const now = display.peek().false_color;
    if (now) lastFalse = now;
    // Its look may be gone when it is asked for again.
    if (lastFalse.against != null) lastFalse = DEFAULT_FALSE;
    show({ false_color: now ? null : asked(lastFalse) });
}

export function exposeBy(steps: number): void {
    const ev = Math.round(((display.peek().ev ?? 0) + steps / 3) * 30) / 30;
    show({ ev });
}

export function storeView(): void {
    const camera = here();
    if (!camera) return;
    const id = free(views);
    edit('Store the view', { views: { [id]: { ...camera, name: `View ${id + 1}` } } });
}

export const storeLook = (): void => command({ do: 'look', what: 'store', name: `Look ${free(looks) + 1}` });

/** Copies without the clipboard's own interface, which pages of plain addresses do not have. */
export async function copyText(text: string): Promise<void> {
    let done = false;
    try {
        await navigator.clipboard.writeText(text);
        done = true;
    } catch {
        const field = document.createElement('textarea');
        field.value = text;
        field.className = 'spoken';
        document.body.append(field);
        field.select();
        done = document.execCommand('copy');
        field.remove();
    }
    say(done ? 'Copied.' : `Copy it by hand: ${text}`);
}

let actions = new Map<string, Action>();
let early: string | null = null;

/** The list comes with the second file; what was asked for before is done then. */
export function register(list: Action[]): void {
    actions = new Map(list.map((action) => [action.id, action]));
    if (early) act(early);
    early = null;
}

export const allActions = (): Action[] => [...actions.values()];
export const actionOf = (id: string): Action | undefined => actions.get(id);
export const whyNotTo = (id: string): string | null => actions.get(id)?.why?.() ?? null;

/** Does it, or says why not. */
export function act(id: string): void {
    const action = actions.get(id);
    if (!actions.size) early = id;
    const why = action?.why?.();
    if (why) say(why, 'warn');
    else action?.run();
}
