// The state as the server tells it, with what the hand does laid over it until the server has followed.
//
// Each entry of a slice has its own signal, so that a patch of one lamp redraws one row. A field that the page has set
// keeps the page's value until a patch arrives whose `seq` is that of the edit or later, and as long as it is held.

import { computed, signal, type Signal } from '@preact/signals';
import type {
    Camera, Display, Grid, Group, History, Id, Lamp, Layer, Look, Material, Meter, Patch, Saved, Scene, Status, Thing,
} from './types';

/** Entries with fields of the page's own. */
const overlaid = new Set<Entry<object>>();

const isRecord = (v: unknown): v is Record<string, unknown> =>
    typeof v === 'object' && v !== null && !Array.isArray(v);

/** `patch` laid over `base`, records within records too. */
export function merge<T>(base: T, patch: unknown): T {
    if (!isRecord(base) || !isRecord(patch)) return patch as T;
    const out: Record<string, unknown> = { ...base };
    for (const [key, value] of Object.entries(patch)) out[key] = merge(out[key], value);
    return out as T;
}

/** One entry: what the server says and what the page lays over it, field by field. */
export class Entry<T extends object> {
    readonly shown: Signal<T>;
    private own = new Map<string, { value: unknown; seq: number }>();

    constructor(private server: T) {
        this.shown = signal(server);
    }

    /** The server's word. */
    receive(value: T): void {
        this.server = value;
        this.show();
    }

    /** The page's word, until a patch of `seq`; infinite while it is held. */
    keep(patch: Record<string, unknown>, seq: number): void {
        for (const [field, value] of Object.entries(patch)) {
            const now = (this.shown.peek() as Record<string, unknown>)[field];
            this.own.set(field, { value: merge(now, value), seq });
        }
        overlaid.add(this as unknown as Entry<object>);
        this.show();
    }

    /** The hand has let go: these fields wait for a patch of `seq` from now on. */
    settle(patch: Record<string, unknown>, seq: number): void {
        for (const field of Object.keys(patch)) {
            const own = this.own.get(field);
            if (own) own.seq = seq;
        }
    }

    /** Forgets what the server has followed. */
    release(seq: number): void {
        let changed = false;
        for (const [field, own] of this.own) {
            if (own.seq <= seq) changed = this.own.delete(field) || changed;
        }
        if (this.own.size === 0) overlaid.delete(this as unknown as Entry<object>);
        if (changed) this.show();
    }

    private show(): void {
        if (this.own.size === 0) {
            this.shown.value = this.server;
            return;
        }
        const over: Record<string, unknown> = {};
        for (const [field, own] of this.own) over[field] = own.value;
        this.shown.value = { ...this.server, ...over };
    }
}

/** Where an entry stands in lists. */
function place(entry: object): string {
    const { name, group, lamps: members } = entry as { name?: string; group?: Id; lamps?: Id[] };
    return `${name} ${group} ${members}`;
}

/** A numbered family of entries. */
export class Slice<T extends object> {
    /** Numbers of the entries there are, ascending; changes only when one comes or goes. */
    readonly ids = signal<Id[]>([]);
    /** Grows when an entry is called otherwise or belongs elsewhere: what lists are made of. */
    readonly order = signal(0);
    private entries = new Map<Id, Entry<T>>();

    get(id: Id | null | undefined): T | undefined {
        if (id == null) return undefined;
        const entry = this.entries.get(id);
        if (entry) return entry.shown.value;
        void this.ids.value;
        return undefined;
    }

    has(id: Id): boolean {
        void this.ids.value;
        return this.entries.has(id);
    }

    entry(id: Id): Entry<T> | undefined {
        return this.entries.get(id);
    }

    /** All entries as they are; whoever asks inside of an effect hears only of what changes lists. */
    listed(): [Id, T][] {
        void this.order.value;
        return this.ids.value.map((id) => [id, (this.entries.get(id) as Entry<T>).shown.peek()]);
    }

    /** All entries; whoever asks inside of an effect hears of each change. */
    all(): [Id, T][] {
        return this.ids.value.map((id) => [id, (this.entries.get(id) as Entry<T>).shown.value]);
    }

    whole(values: Record<string, T> | undefined): void {
        const fresh = new Map<Id, Entry<T>>();
        for (const [key, value] of Object.entries(values ?? {})) fresh.set(Number(key), new Entry(value));
        this.entries = fresh;
        this.number();
    }

    patch(values: Record<string, T | null>): void {
        let listed = false;
        for (const [key, value] of Object.entries(values)) {
            const id = Number(key);
            const entry = this.entries.get(id);
            if (value === null) listed = this.entries.delete(id) || listed;
            else if (entry) {
                if (place(entry.shown.peek()) !== place(value)) this.order.value++;
                entry.receive(value);
            } else {
                this.entries.set(id, new Entry(value));
                listed = true;
            }
        }
        if (listed) this.number();
    }

    private number(): void {
        this.ids.value = [...this.entries.keys()].sort((a, b) => a - b);
    }
}

export const lamps = new Slice<Lamp>();
export const groups = new Slice<Group>();
export const things = new Slice<Thing>();
export const materials = new Slice<Material>();
export const views = new Slice<Camera>();
export const looks = new Slice<Look>();
export const meters = new Slice<Meter>();
export const grids = new Slice<Grid>();

const slices: Record<string, Slice<object>> = {
    lamps, groups, things, materials, views, looks, meters, grids,
} as unknown as Record<string, Slice<object>>;

export const scene = signal<Scene | null>(null);
export const layers = signal<Layer[]>([]);
export const solo = signal<Id[]>([]);
export const history = signal<History>({ undo: null, redo: null, steps: 0 });
export const saved = signal<Saved>({ state: 'clean', file: '' });
export const editor = signal<{ you: boolean; name: string | null }>({ you: true, name: null });
export const status = signal<Status | null>(null);

const displayEntry = new Entry<Display>({
    ev: null, metered: false, tone: 'filmic', white: null, false_color: null,
});
export const display = displayEntry.shown;

/** Everything that is not numbered, by its name on the wire. */
const plain: Record<string, Signal<unknown>> = {
    scene, layers, solo, history, saved, editor, status,
} as unknown as Record<string, Signal<unknown>>;

/** The state, whole. */
export function receiveState(state: Record<string, unknown>): void {
    overlaid.clear();
    for (const [name, slice] of Object.entries(slices)) slice.whole(state[name] as Record<string, object>);
    for (const [name, target] of Object.entries(plain)) if (name in state) target.value = state[name];
    if (isRecord(state.display)) displayEntry.receive(state.display as unknown as Display);
}

/** What changed, and the last message of ours that the server has followed. */
export function receivePatch(patch: Record<string, unknown>, seq: number): void {
    for (const [name, value] of Object.entries(patch)) {
        if (name in slices) slices[name].patch(value as Record<string, object | null>);
        else if (name === 'display') displayEntry.receive(value as Display);
        else if (name in plain) plain[name].value = value;
    }
    releaseUpTo(seq);
}

/** Forgets what the page has laid over fields that the server has followed by now. */
export function releaseUpTo(seq: number): void {
    for (const entry of [...overlaid]) entry.release(seq);
}

/** Calls `with_` for each entry that an edit touches. */
function touch(patch: Patch, visit: (entry: Entry<object>, fields: Record<string, unknown>) => void): void {
    for (const [name, value] of Object.entries(patch)) {
        if (name in slices && isRecord(value)) {
            for (const [key, fields] of Object.entries(value)) {
                const entry = slices[name].entry(Number(key));
                if (entry && isRecord(fields)) visit(entry, fields);
            }
        } else if (name === 'display' && isRecord(value)) {
            visit(displayEntry as unknown as Entry<object>, value);
        }
    }
}

export const keep = (patch: Patch, seq: number): void => touch(patch, (entry, fields) => entry.keep(fields, seq));
export const settle = (patch: Patch, seq: number): void => touch(patch, (entry, fields) => entry.settle(fields, seq));

/** What a lamp gives of what its file says: its own level and its group's, nothing if one of them is off. */
export function output(lamp: Lamp): number {
    const group = groups.get(lamp.group);
    const on = lamp.on && !lamp.parked && (group?.on ?? true);
    return on ? lamp.level * (group?.level ?? 1) : 0;
}

/** Lumens that some lamps give now. One that is just going may still be in its group. */
export function lumensOf(ids: Id[]): number {
    return ids.reduce((sum, id) => {
        const lamp = lamps.get(id);
        return sum + (lamp ? lamp.flux * output(lamp) : 0);
    }, 0);
}

/** True if there are lamps and none gives light. */
export const dark = computed(() => {
    const all = lamps.all();
    return all.length > 0 && all.every(([, lamp]) => output(lamp) === 0);
});

/** Entries of a family that are called so. */
export function filterOf<T extends { name: string }>(slice: Slice<T>, wanted: string): [Id, T][] {
    const word = wanted.trim().toLowerCase();
    return slice.all().filter(([, entry]) => !word || entry.name.toLowerCase().includes(word));
}
