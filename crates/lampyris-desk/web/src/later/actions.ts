// Everything one can do, by name.

import {
    adding, asked, ask, back, candles, chosenLamps, clearSolo, command, compareHeld, copyText, DEFAULT_FALSE, deselect, each, edit,
    exposeBy, falseColor, fine, forth, frameSelection, go, goHome, goInside, goPreset, hands, here,
    highlight, history, lampMarks, lamps, listing, lookOnly, looks, maintenance, panels, PRESETS, register, say, scene, selection, send,
    sheet, show, soloSelection, spot, startTool, stepSelection, storeLook, storeView, theme, things, titleOf,
    toggleFalse, toggleWipe, travel, views, walking, whyNot, type Action, type Camera, type Hands, type LampKind,
    type Preset,
} from '../desk';
import { difference } from './differ';
import { CLAMPED } from './legend';
import { group, ungroup, whyNotGroup, whyNotUngroup } from './grouping';
import { most } from './most';
import { goThere, whyNotThere } from './there';
import { startTyped } from './typed';
import { addMeter, aim, copyAlong, removeLamps } from './tools';

const needLamp = () => whyNot() ?? (chosenLamps.value.length ? null : 'Select a lamp first.');

function toggleLamps(): void {
    const ids = chosenLamps.peek();
    const on = !ids.some((id) => lamps.get(id)?.on);
    edit(`${titleOf(ids)} ${on ? 'on' : 'off'}`, { lamps: each(ids, { on }) });
}

function park(): void {
    const ids = chosenLamps.peek();
    const parked = !ids.every((id) => lamps.get(id)?.parked);
    edit(`${parked ? 'Park' : 'Unpark'} ${titleOf(ids)}`, { lamps: each(ids, { parked }) });
}

function hide(hidden: boolean): void {
    const now = selection.peek();
    const ids = hidden ? (now?.kind === 'thing' ? now.ids : []) : things.ids.peek().filter((id) => things.get(id)?.hidden);
    if (!ids.length) return say(hidden ? 'Select a thing first.' : 'Nothing is hidden.', 'warn');
    edit(hidden ? 'Hide things' : 'Show hidden things', { things: each(ids, { hidden }) });
}

export function viewFromLamp(): void {
    const id = chosenLamps.peek()[0];
    const place = lamps.get(id)?.place;
    const camera = here();
    if (!place?.position || !place.direction || !camera) return say('Select a lamp that has a direction.', 'warn');
    const { position: p, direction: d } = place;
    go({ ...camera, eye: p, target: [p[0] + d[0], p[1] + d[1], p[2] + d[2]], height: null, near: null }, 'from the lamp');
}

function copyCommand(): void {
    ask('command', {}, (answer) => void copyText(answer.text as string));
}

const KINDS: [LampKind, string][] = [['point', 'point'], ['spot', 'spot'], ['disc', 'area'], ['sphere', 'sphere']];
const PLACES: Record<Preset, string> = {
    plan: 'Plan', ceiling: 'Ceiling, seen from below', north: 'Elevation ahead', east: 'Elevation to the right',
    south: 'Elevation back', west: 'Elevation to the left',
};

const list: Action[] = [
    { id: 'frame', group: 'View', label: 'Frame the selection', keys: 'F', run: frameSelection },
    { id: 'home', group: 'View', label: 'Home: the view at the beginning', keys: 'Home', run: goHome },
    { id: 'inside', group: 'View', label: 'Inside again', keys: 'Shift+0', run: goInside },
    { id: 'back', group: 'View', label: 'The view before', keys: 'Alt+←', run: back },
    { id: 'forth', group: 'View', label: 'The view after', keys: 'Alt+→', run: forth },
    { id: 'store-view', group: 'View', label: 'Store this view', keys: 'Alt+0', run: storeView, why: whyNot },
    ...PRESETS.map((which, k) => ({
        id: `preset-${which}`, group: 'View', label: PLACES[which], keys: `Shift+${k + 1}`, run: () => goPreset(which),
    })),
    {
        id: 'walking', group: 'View', label: 'Walk or fly', keys: 'V',
        run: () => {
            walking.value = walking.peek() === 'walk' ? 'fly' : 'walk';
            say(walking.peek() === 'walk' ? 'Walking, the eye 1.60 m above the floor' : 'Flying');
        },
    },
    { id: 'there', group: 'View', label: 'Go to the floor under the pointer', keys: 'double click', run: goThere, why: whyNotThere },
    { id: 'from-lamp', group: 'View', label: 'View from the lamp', keys: 'Shift+L', run: viewFromLamp, why: needLamp },
    { id: 'next', group: 'Select', label: 'Next', keys: ']', run: () => stepSelection(1) },
    { id: 'previous', group: 'Select', label: 'Previous', keys: '[', run: () => stepSelection(-1) },
    { id: 'marquee', group: 'Select', label: 'Select lamps by dragging around them', keys: 'M', run: () => startTool('marquee') },
    { id: 'all-lamps', group: 'Select', label: 'Select all lamps', keys: 'Ctrl+A', run: () => (selection.value = { kind: 'lamp', ids: lamps.ids.peek() }) },
    { id: 'none', group: 'Select', label: 'Select nothing', keys: 'Esc', run: deselect },
    { id: 'on-off', group: 'Lamps', label: 'On or off', keys: 'O', run: toggleLamps, why: needLamp },
    { id: 'solo', group: 'Lamps', label: 'Solo', keys: 'I', run: soloSelection, why: () => (chosenLamps.value.length ? null : 'Select a lamp first.') },
    { id: 'unsolo', group: 'Lamps', label: 'End solo', keys: 'Shift+I', run: clearSolo },
    { id: 'highlight', group: 'Lamps', label: 'Highlight as long as the key is held', keys: 'hold L', run: () => highlight(true), why: needLamp },
    { id: 'park', group: 'Lamps', label: 'Park: off, and not traced', keys: 'Shift+O', run: park, why: needLamp },
    { id: 'aim', group: 'Lamps', label: 'Aim by pointing', keys: 'T', run: () => startTool('aim'), why: needLamp },
    { id: 'aim-here', group: 'Lamps', label: 'Aim at the point under the pointer', keys: 'Shift+T', run: () => spot.peek() && aim(chosenLamps.peek(), spot.peek()!.point), why: needLamp },
    { id: 'place', group: 'Lamps', label: 'Put on a surface by pointing', keys: 'Shift+N', run: () => startTool('place'), why: needLamp },
    { id: 'move', group: 'Lamps', label: 'Move: handles, or an axis and metres', keys: 'G, then X Y Z, 0.5', run: () => startTyped('move') },
    { id: 'turn', group: 'Lamps', label: 'Turn: handles, or an axis and degrees', keys: 'R, then X Y Z, 30', run: () => startTyped('turn') },
    ...KINDS.map(([kind, name]) => ({
        id: `add-${kind}`, group: 'Lamps', label: `Add a ${name} lamp by pointing`, keys: kind === 'spot' ? 'N' : undefined, why: whyNot,
        run: () => {
            adding.value = kind;
            startTool('add');
        },
    })),
    { id: 'duplicate', group: 'Lamps', label: 'Duplicate', keys: 'Ctrl+D', run: () => copyAlong(chosenLamps.peek(), 1, [0.5, 0, 0]), why: needLamp },
    { id: 'remove', group: 'Lamps', label: 'Remove', keys: 'Del', run: () => removeLamps(chosenLamps.peek()), why: needLamp },
    { id: 'group', group: 'Lamps', label: 'Group: one master for those selected', keys: 'Ctrl+G', run: group, why: () => whyNot() ?? whyNotGroup() },
    { id: 'ungroup', group: 'Lamps', label: 'Dissolve the group, or take lamps out of it', keys: 'Ctrl+Shift+G', run: ungroup, why: () => whyNot() ?? whyNotUngroup() },
    { id: 'hide', group: 'Things', label: 'Hide', keys: 'H', run: () => hide(true), why: whyNot },
    { id: 'unhide', group: 'Things', label: 'Show what is hidden', keys: 'Alt+H', run: () => hide(false), why: whyNot },
    { id: 'undo', group: 'Work', label: 'Undo', keys: 'Ctrl+Z', run: () => command({ do: 'undo' }), why: () => whyNot() ?? (history.value.undo === null ? 'There is nothing to undo.' : null) },
    { id: 'redo', group: 'Work', label: 'Redo', keys: 'Ctrl+Shift+Z', run: () => command({ do: 'redo' }), why: () => whyNot() ?? (history.value.redo === null ? 'There is nothing to redo.' : null) },
    { id: 'save', group: 'Work', label: 'Save a version with a name', keys: 'Ctrl+S', run: () => (sheet.value = 'save'), why: whyNot },
    { id: 'picture', group: 'Work', label: 'Save the picture', keys: 'Ctrl+Shift+S', run: () => (sheet.value = 'picture') },
    { id: 'command', group: 'Work', label: 'Copy the command that renders this picture', run: copyCommand },
    { id: 'share', group: 'Work', label: 'Share by link', run: () => (sheet.value = 'share') },
    { id: 'false-colour', group: 'Seeing', label: 'False colour', keys: 'B', run: toggleFalse },
    {
        id: 'quantity', group: 'Seeing', label: 'False colour of lux or of cd/m²', keys: 'Shift+B',
        run: () => {
            const now = falseColor();
            if (now.against != null || now.quantity === 'clamped') show({ false_color: DEFAULT_FALSE });
            else show({ false_color: { ...asked(now), quantity: now.quantity === 'illuminance' ? 'luminance' : 'illuminance' } });
        },
    },
    {
        id: 'difference', group: 'Seeing', label: 'Difference in lux to the look stored last',
        run: () => {
            const last = looks.ids.peek().at(-1);
            if (last === undefined) say('Store a look first.');
            else show({ false_color: difference(last) });
        },
    },
    { id: 'clamped', group: 'Seeing', label: 'What clamping takes, and short rays pay back', run: () => show({ false_color: CLAMPED }) },
    { id: 'darker', group: 'Seeing', label: 'Darker by a third of a stop', keys: ',', run: () => exposeBy(1) },
    { id: 'brighter', group: 'Seeing', label: 'Brighter by a third of a stop', keys: '.', run: () => exposeBy(-1) },
    { id: 'expose', group: 'Seeing', label: 'Meter the exposure once', keys: '/', run: () => send({ do: 'expose' }) },
    { id: 'before', group: 'Seeing', label: 'Before, as long as the key is held', keys: 'hold \\', run: () => compareHeld(true) },
    { id: 'wipe', group: 'Seeing', label: 'Wipe between before and now', keys: 'C', run: toggleWipe },
    { id: 'meter', group: 'Measure', label: 'Meter under the pointer', keys: 'P', why: whyNot, run: () => (spot.peek() ? addMeter(spot.peek()!.point, spot.peek()!.normal) : startTool('meter')) },
    { id: 'meter-tool', group: 'Measure', label: 'Lay a meter by pointing', run: () => startTool('meter'), why: whyNot },
    { id: 'grid', group: 'Measure', label: 'Lay a grid by two corners', keys: 'Shift+G', run: () => startTool('grid'), why: whyNot },
    { id: 'reach', group: 'Measure', label: 'Set the mix so that the targets are reached', run: () => command({ do: 'reach', most: most.peek(), maintenance: maintenance.peek() }), why: whyNot },
    { id: 'units', group: 'Measure', label: 'Lux or foot-candles', run: () => (candles.value = candles.peek() === 'lx' ? 'fc' : 'lx') },
    { id: 'look-store', group: 'Looks', label: 'Store a look', keys: 'Ctrl+Enter', run: storeLook, why: whyNot },
    { id: 'look-recall', group: 'Looks', label: 'Recall a look by its digit', keys: 'J, then 1…9', run: () => say('Press J, then the digit of the look.') },
    { id: 'panels', group: 'Page', label: 'Panels away', keys: 'U', run: () => (panels.value = !panels.peek()) },
    { id: 'listing', group: 'Page', label: 'Faders or sheet', run: () => (listing.value = listing.peek() === 'faders' ? 'sheet' : 'faders') },
    { id: 'travel', group: 'Page', label: 'Faders by the square law or even', run: () => (travel.value = travel.peek() === 'square' ? 'linear' : 'square') },
    { id: 'marks', group: 'Page', label: 'Marks of lamps in the view', run: () => (lampMarks.value = !lampMarks.peek()) },
    { id: 'fine', group: 'Page', label: 'Full resolution of fine displays', run: () => (fine.value = !fine.peek()) },
    { id: 'theme', group: 'Page', label: 'Light or dark', run: () => (theme.value = theme.peek() === 'dark' ? 'light' : 'dark') },
    { id: 'lock', group: 'Page', label: 'Look-only lock', run: () => (lookOnly.value = !lookOnly.peek()) },
    ...(['default', 'blender', 'maya', 'trackpad'] as Hands[]).map((habit) => ({
        id: `hands-${habit}`, group: 'Page', label: `Navigate as: ${habit}`, run: () => (hands.value = habit),
    })),
    { id: 'help', group: 'Page', label: 'All keys', keys: '?', run: () => (sheet.value = 'help') },
    { id: 'palette', group: 'Page', label: 'Command palette', keys: 'Ctrl+K', run: () => (sheet.value = 'palette') },
];

register(list);

/** The views that the palette and the menu offer besides: those of the file and those stored. */
export function namedViews(): { name: string; camera: Camera }[] {
    const file = (scene.value?.cameras ?? []).map((camera, k) => ({ name: camera.name || `Camera ${k + 1}`, camera }));
    return [...file, ...views.all().map(([, camera]) => ({ name: camera.name ?? 'View', camera }))];
}
