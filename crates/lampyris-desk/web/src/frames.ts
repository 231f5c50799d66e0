// Pictures: heads are read, bytes decoded one at a time, and the newest is drawn. Each goes with its own camera.

import { signal } from '@preact/signals';
import { noteFrame } from './counters';
import type { Camera } from './types';
import { hear, picturesTo, send } from './wire';

export interface Head {
    frame: number;
    seq: number;
    camera: number;
    width: number;
    height: number;
    kind: 'moving' | 'settled' | 'final';
    falseColor: boolean;
    batches: number;
    error: number;
    /** What light and bytes took the program [ms]. */
    light: number;
    encode: number;
}

/** What is on the canvas. */
export interface Picture {
    head: Head;
    camera: Camera;
}

export const shown = signal<Picture | null>(null);
/** Frames drawn in the last second, as the page counts them. */
export const rate = signal(0);

const KINDS = ['moving', 'settled', 'final'] as const;
const HEAD = 32;
const cameras = new Map<number, Camera>();
let canvas: HTMLCanvasElement | null = null;
let context: CanvasRenderingContext2D | null = null;
let decoding = false;
let waiting: { head: Head; mime: string; bytes: ArrayBuffer; received: number } | null = null;

export function readHead(bytes: ArrayBuffer): { head: Head; mime: string } | null {
    if (bytes.byteLength < HEAD) return null;
    const view = new DataView(bytes);
    const head: Head = {
        frame: view.getUint32(0, true),
        seq: view.getUint32(4, true),
        camera: view.getUint32(8, true),
        width: view.getUint16(12, true),
        height: view.getUint16(14, true),
        kind: KINDS[Math.min(view.getUint8(16), 2)],
        falseColor: (view.getUint8(18) & 1) === 1,
        batches: view.getUint32(20, true),
        error: view.getFloat32(24, true),
        light: view.getUint16(28, true) / 10,
        encode: view.getUint16(30, true) / 10,
    };
    return { head, mime: view.getUint8(17) === 1 ? 'image/png' : 'image/jpeg' };
}

/** Takes a binary message. One that waits is overtaken by a newer one, and acknowledged, for it will not be drawn. */
function takeFrame(bytes: ArrayBuffer): Head | null {
    const read = readHead(bytes);
    if (!read) return null;
    if (waiting) send({ do: 'ack', frame: waiting.head.frame });
    waiting = { ...read, bytes, received: performance.now() };
    if (!decoding) void decode();
    return read.head;
}

async function decode(): Promise<void> {
    decoding = true;
    while (waiting) {
        const { head, mime, bytes, received } = waiting;
        waiting = null;
        try {
            const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes, HEAD)], { type: mime }));
            draw(head, bitmap, bytes.byteLength, received);
        } catch {
            // A picture that cannot be read is passed over; the next one comes.
        }
        send({ do: 'ack', frame: head.frame });
    }
    decoding = false;
}

function draw(head: Head, bitmap: ImageBitmap, bytes: number, received: number): void {
    const decoded = performance.now();
    if (canvas && context) {
        if (canvas.width !== bitmap.width || canvas.height !== bitmap.height) {
            canvas.width = bitmap.width;
            canvas.height = bitmap.height;
        }
        context.drawImage(bitmap, 0, 0);
    }
    bitmap.close();
    const camera = cameras.get(head.camera) ?? shown.peek()?.camera;
    if (camera) shown.value = { head, camera };
    count();
    noteFrame({
        frame: head.frame, seq: head.seq, kind: KINDS.indexOf(head.kind), width: head.width, height: head.height, bytes,
        batches: head.batches, received, decoded, drawn: performance.now(), painted: 0, light: head.light,
        encode: head.encode,
    });
}

let times: number[] = [];
function count(): void {
    const now = performance.now();
    times = times.filter((t) => now - t < 1000);
    times.push(now);
    rate.value = times.length;
}

/** Gives the canvas on which frames are drawn. */
export function drawOn(element: HTMLCanvasElement | null): void {
    canvas = element;
    context = element?.getContext('2d', { alpha: false }) ?? null;
}

/** A picture of what is shown now, for a look or for "before". */
export function snapshot(): HTMLCanvasElement | null {
    if (!canvas || !shown.peek()) return null;
    const copy = document.createElement('canvas');
    copy.width = canvas.width;
    copy.height = canvas.height;
    copy.getContext('2d', { alpha: false })?.drawImage(canvas, 0, 0);
    return copy;
}

picturesTo(takeFrame);
hear('camera', (message) => {
    cameras.set(message.number as number, message as unknown as Camera);
    // Frames are at most a few cameras behind.
    for (const number of cameras.keys()) {
        if (cameras.size <= 64) break;
        cameras.delete(number);
    }
});
hear('line', () => {
    cameras.clear();
    waiting = null;
});
