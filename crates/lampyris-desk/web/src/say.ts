// Short words to the user: what was refused, what happened. They go by themselves, except those that must be read.

import { signal } from '@preact/signals';

export type Tone = 'plain' | 'warn';
export interface Note {
    id: number;
    text: string;
    tone: Tone;
}

export const notes = signal<Note[]>([]);
let count = 0;

export function say(text: string, tone: Tone = 'plain'): void {
    const known = notes.peek().find((note) => note.text === text);
    if (known) return;
    const id = ++count;
    notes.value = [...notes.peek().slice(-2), { id, text, tone }];
    setTimeout(() => unsay(id), tone === 'warn' ? 8000 : 4000);
}

export function unsay(id: number): void {
    notes.value = notes.peek().filter((note) => note.id !== id);
}
