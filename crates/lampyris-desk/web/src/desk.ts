// What the second file takes from the first, name by name.

export { computed, effect, signal, untracked } from '@preact/signals';
export { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
export { Fragment, jsx, jsxs } from 'preact/jsx-runtime';
export {
    act, allActions, asked, command, copyText, DEFAULT_FALSE, each, exposeBy, falseColor, register, sheet, storeLook, storeView,
    toggleFalse, wantLevel, whyNotTo, type Action,
} from './actions';
export { before, compareHeld, comparing, toggleWipe, wipeAt } from './before';
export { compass, moved, pinhole, PRESETS, project, ray, type Pinhole, type Preset } from './camera';
export { Field } from './field';
export { shown } from './frames';
export { edit, Gesture, penless, show, step, stroke, whyNot } from './gesture';
export { clearSolo, highlight, soloSelection } from './highlight';
export { Icon } from './icon';
export { keysFirst, padWalk, walkNames } from './keys';
export { pickRow, type Row } from './lamps';
export { Fade, strokeLevel, switchOn, toLevel, toTravel, typeGroupLevel, typeLevel, type Strip } from './levels';
export { closeWhat, what } from './lights';
export { Item } from './menu';
export {
    back, camera, cut, EYE_HEIGHT, fitted, forth, frameSelection, go, goHome, goInside, goPreset, here, setCut, up, viewName,
    viewSize,
} from './navigate';
export {
    candles, fade, fine, hands, houseLights, lampMarks, listing, lookOnly, maintenance, panels, singleKeys, theme,
    travel, walking, workPlane, type Hands,
} from './prefs';
export { gridPoint } from './overlay';
export { Range } from './range';
export { colorText, cost, LevelField, listed, Power } from './row';
export { say } from './say';
export {
    chosenLamps, deselect, handles, hovered, nameOf, select, selection, spot, stepSelection, titleOf, tool, type Kind,
} from './select';
export {
    display, editor, filterOf, grids, groups, history, lamps, layers, looks, lumensOf, materials, meters, output,
    scene, status, things, views, type Slice,
} from './store';
export { css, fromHex, hex, mired } from './swatch';
export { adding, free, onTool, positionOf, startTool } from './tools';
export {
    type Camera, type Color, type ColorMode, type FalseColor, type Grid, type Hit, type Id, type Lamp, type LampKind,
    type LinkEntry, type Measured, type Material, type Meter, type Patch, type Place, type Share, type Thing, type Vec,
} from './types';
export { digits, format, luxText, maintained, percent, signed, three, type Quantity } from './units';
export { across, add, cross, distance, dot, length, middle, normal, scale, sub, turn } from './vec';
export { Virtual } from './virtual';
export { ask, hear, role, send } from './wire';
