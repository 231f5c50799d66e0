// The socket: enters with the key of the link, speaks docs/wire.md, and comes back when the line breaks.
//
// Edits are refused while there is no line; nothing is queued for later, because nobody could see what it would do.

import { signal } from '@preact/signals';
import { counters, note } from './counters';
import { editor, receivePatch, receiveState, releaseUpTo, status } from './store';
import type { Status } from './types';

/** How we stand with the program. */
export type Line = 'entering' | 'open' | 'lost' | 'ended' | 'denied' | 'renewed';
export const line = signal<Line>('entering');
/** Seconds until the next attempt. */
export const retryIn = signal(0);
export const role = signal<'edit' | 'watch'>('edit');
/** Who we are to others. */
export const me = signal<string | null>(null);
/** The last message of ours that the server has followed. */
export const followed = signal(0);

export type Message = Record<string, unknown> & { is: string };
type Listener = (message: Message) => void;
/** Who takes pictures; returns the last message of ours that is in one. */
type Taker = (bytes: ArrayBuffer) => { seq: number } | null;
let takeFrame: Taker = () => null;
export const picturesTo = (taker: Taker): void => void (takeFrame = taker);
const listeners = new Map<string, Set<Listener>>();

let socket: WebSocket | null = null;
let seq = 0;
let build: string | null = null;
let attempts = 0;
let key = '';
let ended = false;

/** Hears messages of one kind; returns how to stop that. */
export function hear(kind: string, listener: Listener): () => void {
    const set = listeners.get(kind) ?? new Set();
    listeners.set(kind, set.add(listener));
    return () => set.delete(listener);
}

/** Sends a message and returns its number, or 0 without a line. */
export function send(message: { do: string } & Record<string, unknown>): number {
    if (!socket || socket.readyState !== WebSocket.OPEN || line.peek() !== 'open') return 0;
    seq += 1;
    socket.send(JSON.stringify({ ...message, seq }));
    if (message.do !== 'ack') note(seq, message.do);
    return seq;
}

let questions = 0;

/** Questions on their way, by the number of their message: what to do if one is refused. */
const asked = new Map<number, (why: string) => void>();

/**
 * Asks; each answer goes to `answered` until one is the last, a refusal to `refused`, which nobody else hears of.
 * Returns how to stop hearing.
 */
export function ask(
    what: string,
    question: Record<string, unknown>,
    answered: (answer: Message) => void,
    refused: (why: string) => void = () => {},
): () => void {
    const id = ++questions;
    const stop = hear('answer', (message) => {
        if (message.id !== id) return;
        if (message.done !== false) stop();
        answered(message);
    });
    const number = send({ do: 'ask', id, what, ...question });
    if (!number) {
        stop();
        refused('There is no connection to the program.');
        return stop;
    }
    asked.set(number, (why) => {
        stop();
        refused(why);
    });
    // Numbers grow: whatever is older than a few hundred messages was answered.
    for (const old of asked.keys()) {
        if (old > number - 300) break;
        asked.delete(old);
    }
    return stop;
}

function receive(message: Message): void {
    switch (message.is) {
        case 'hello':
            attempts = 0;
            if (build !== null && message.build !== build) {
                line.value = 'renewed';
                socket?.close();
                return;
            }
            build = message.build as string;
            role.value = message.role === 'watch' ? 'watch' : 'edit';
            me.value = message.you === undefined ? null : String(message.you);
            followed.value = 0;
            asked.clear();
            line.value = 'open';
            break;
        case 'state':
            receiveState((message.state as Record<string, unknown>) ?? message);
            break;
        case 'patch':
            // What somebody else changed says nothing of our own messages.
            if (message.by == null || String(message.by) === me.value) advance(message.seq as number);
            receivePatch((message.patch as Record<string, unknown>) ?? {}, followed.value);
            break;
        case 'status':
            status.value = message as unknown as Status;
            break;
        case 'refused':
            advance(message.seq as number);
            releaseUpTo(followed.value);
            if (asked.has(message.seq as number)) {
                asked.get(message.seq as number)?.((message.why as string) ?? '');
                asked.delete(message.seq as number);
                return;
            }
            break;
        case 'event':
            if (message.what === 'bye') ended = true;
            break;
    }
    for (const listener of [...(listeners.get(message.is) ?? [])]) listener(message);
}

/** What arrives of numbers only grows. */
function advance(to: number | undefined): void {
    if (typeof to === 'number' && to > followed.value) followed.value = to;
}

/** Posts the key; false if no link has it (any more). */
async function enter(): Promise<'in' | 'denied' | 'away'> {
    if (!key) return 'in';
    try {
        const answer = await fetch('/enter', {
            method: 'POST',
            headers: { 'content-type': 'application/json' },
            body: JSON.stringify({ key }),
        });
        return answer.ok ? 'in' : 'denied';
    } catch {
        return 'away';
    }
}

function open(): void {
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    const fresh = new WebSocket(`${scheme}://${location.host}/wire`);
    fresh.binaryType = 'arraybuffer';
    let greeted = false;
    socket = fresh;
    // Not of the wire: a new line begins, and numbers of the old one mean nothing any more.
    listeners.get('line')?.forEach((listener) => listener({ is: 'line' }));
    fresh.onmessage = (event) => {
        if (fresh !== socket) return;
        if (typeof event.data !== 'string') {
            const head = takeFrame(event.data as ArrayBuffer);
            if (head && editor.value.you) advance(head.seq);
            return;
        }
        const message = JSON.parse(event.data) as Message;
        if (message.is === 'hello') {
            greeted = true;
            seq = 0;
        }
        receive(message);
    };
    fresh.onclose = () => {
        if (fresh !== socket) return;
        socket = null;
        if (line.value !== 'renewed') void lost(greeted);
    };
}

/** Waits a little longer each time and tries again; a program that is there but does not let us in gets the key anew. */
async function lost(greeted: boolean): Promise<void> {
    releaseUpTo(Infinity);
    if (!greeted && (await reachable())) {
        const got = await enter();
        if (got === 'denied' || (got === 'in' && attempts > 4 && !key)) {
            line.value = 'denied';
            return;
        }
    }
    attempts += 1;
    const local = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
    if (attempts > 3 && local) ended = true;
    line.value = ended ? 'ended' : 'lost';
    const wait = Math.min(5, attempts);
    for (let left = wait; left > 0; left--) {
        retryIn.value = left;
        await new Promise((done) => setTimeout(done, 1000));
    }
    retryIn.value = 0;
    open();
}

/** True if somebody answers at all. */
async function reachable(): Promise<boolean> {
    try {
        await fetch('/', { cache: 'no-store' });
        return true;
    } catch {
        return false;
    }
}

/** Begins. The key leaves the address at once, so that it stands in no history and on no screen that is shown around. */
export async function connect(): Promise<void> {
    const fragment = location.hash.slice(1);
    if (fragment) {
        key = fragment;
        sessionStorage.setItem('lampyris-key', key);
        window.history.replaceState(null, '', location.pathname + location.search);
    } else {
        key = sessionStorage.getItem('lampyris-key') ?? '';
    }
    counters.entered = performance.now();
    if (fragment && (await enter()) === 'denied') {
        line.value = 'denied';
        return;
    }
    open();
}

hear('hello', () => (ended = false));
