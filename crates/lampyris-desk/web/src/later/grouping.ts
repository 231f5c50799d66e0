// Groups of lamps as people make them: of those selected, with a name and a master; a lamp is in one at most.

import { chosenLamps, groups, lamps, selection, step, titleOf, type Id, type Slice } from '../desk';
import { selectNext } from './tools';

/** Groups that are seen as such: with more than one lamp. */
const groupOf = (id: Id): Id | null => {
    const group = lamps.get(id)?.group ?? null;
    return group !== null && (groups.get(group)?.lamps.length ?? 0) > 1 ? group : null;
};

/** Why what is selected cannot be made a group, or null. */
export function whyNotGroup(): string | null {
    const ids = chosenLamps.value;
    if (ids.length < 2) return 'Select two lamps or more first.';
    return selection.value?.kind === 'group' && selection.value.ids.length === 1 ? 'This is a group already.' : null;
}

export function group(): void {
    const taken = new Set(groups.all().map(([, own]) => own.name));
    let number = 1;
    while (taken.has(`Group ${number}`)) number++;
    selectNext(groups as unknown as Slice<object>, 'group');
    step(`Group ${titleOf(chosenLamps.peek())}`, { do: 'group', lamps: chosenLamps.peek(), name: `Group ${number}` });
}

/** Why what is selected cannot be taken out of its groups, or null. */
export function whyNotUngroup(): string | null {
    return chosenLamps.value.some((id) => groupOf(id) !== null) ? null : 'What is selected is in no group.';
}

/** Dissolves the groups selected, or takes the lamps selected out of theirs. */
export function ungroup(): void {
    const now = selection.peek();
    const ids = chosenLamps.peek().filter((id) => groupOf(id) !== null);
    const asGroup = now?.kind === 'group' && now.ids.length === 1 ? groups.get(now.ids[0]) : undefined;
    step(asGroup ? `Dissolve ${asGroup.name}` : `Take ${titleOf(ids)} out`, { do: 'group', lamps: ids });
    selection.value = { kind: 'lamp', ids };
}
