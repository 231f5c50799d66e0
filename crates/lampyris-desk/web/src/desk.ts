// What the second file takes from the first.

export { computed, effect, signal, untracked, useComputed, useSignal, useSignalEffect } from '@preact/signals';
export { useEffect, useRef } from 'preact/hooks';
export { Fragment, jsx, jsxs } from 'preact/jsx-runtime';
export * from './actions';
export * from './before';
export * from './camera';
export * from './field';
export * from './frames';
export * from './gesture';
export * from './highlight';
export * from './icon';
export * from './lights';
export * from './navigate';
export * from './prefs';
export * from './range';
export * from './say';
export * from './select';
export * from './states';
export * from './store';
export * from './tools';
export * from './types';
export * from './units';
export * from './vec';
export * from './wire';
