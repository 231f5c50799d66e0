// Solo and highlight: the light of some lamps alone. Ways of looking, neither saved nor undone.

import { chosenLamps } from './select';
import { solo } from './store';
import type { Id } from './types';
import { send } from './wire';

function alone(ids: Id[]): void {
    solo.value = ids;
    send({ do: 'solo', lamps: ids });
}

export function soloLamps(ids: Id[]): void {
    const now = solo.peek();
    const already = ids.every((id) => now.includes(id));
    alone(already ? now.filter((id) => !ids.includes(id)) : [...now, ...ids.filter((id) => !now.includes(id))]);
}

export const soloSelection = (): void => soloLamps(chosenLamps.peek());
export const clearSolo = (): void => alone([]);

let before: Id[] | null = null;

/** The lamps chosen alone as long as a key is held. */
export function highlight(held: boolean): void {
    if (held && before === null && chosenLamps.peek().length) {
        before = solo.peek();
        alone(chosenLamps.peek());
    } else if (!held && before !== null) {
        alone(before);
        before = null;
    }
}
