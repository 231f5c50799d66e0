// What comes after the first picture: handles, inspector, legend, sheets. Everything they share with the rest they take
// from `../desk`, which is the file that is loaded already.

import './actions';
import './shares';
export { Compare } from './compare';
export { Gizmo } from './handles';
export { Inspector } from './inspector';
export { Legend } from './legend';
export { Sheets } from './sheets';
export { SheetHead, SheetRow } from './sheetrow';
export { Strip } from './strip';
export { PageItems, SeeingItems, ViewItems } from './menus';
export { TypedHint } from './typed';
export { CutBar, ViewStrip } from './views';
export { WalkPad } from './walkpad';
export { What } from './what';
