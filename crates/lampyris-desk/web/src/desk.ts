// What the second file takes from the first, name by name.

export { computed, effect, signal } from '@preact/signals';
export { useEffect, useRef } from 'preact/hooks';
export { Fragment, jsx, jsxs } from 'preact/jsx-runtime';
export {
    act, command, copyText, each, exposeBy, falseColor, register, sheet, storeLook, storeView, toggleFalse,
    type Action,
} from './actions';
export { before, compareHeld, comparing, toggleWipe, wipeAt } from './before';
export { pinhole, PRESETS, project, ray, type Pinhole, type Preset } from './camera';
export { Field } from './field';
export { shown } from './frames';
export { edit, Gesture, show, whyNot } from './gesture';
export { clearSolo, highlight, soloSelection } from './highlight';
export { Icon } from './icon';
export { padWalk } from './keys';
export { closeWhat, what } from './lights';
export { Item } from './menu';
export {
    back, cut, fitted, forth, frameSelection, go, goHome, goInside, goPreset, here, setCut, viewName, viewSize,
} from './navigate';
export {
    candles, fade, fine, hands, houseLights, lampMarks, listing, lookOnly, maintenance, panels, theme, travel,
    walking, type Hands,
} from './prefs';
export { Range } from './range';
export { say } from './say';
export {
    chosenLamps, deselect, handles, hovered, nameOf, select, selection, spot, stepSelection, titleOf, tool,
} from './select';
export { display, editor, grids, history, lamps, looks, meters, scene, status, things, views } from './store';
export { adding, addMeter, aim, copyAlong, placed, positionOf, positions, removeLamps, startTool } from './tools';
export { type Camera, type FalseColor, type Lamp, type LampKind, type Share, type Vec } from './types';
export { digits, luxText, three } from './units';
export { across, add, cross, distance, dot, length, normal, scale, sub, turn } from './vec';
export { ask, role, send } from './wire';
