// What tests and the latency script read: which frame is drawn, what is in it, and when things happened [ms].

export interface Shown {
    frame: number;
    seq: number;
    kind: number;
    width: number;
    height: number;
    bytes: number;
    batches: number;
    /** Times of the page: the message came, the picture was decoded, it was drawn, the paint after that was done. */
    received: number;
    decoded: number;
    drawn: number;
    painted: number;
    /** Times that the program took [ms]. */
    light: number;
    encode: number;
}

const KEPT = 1024;

export const counters = {
    frame: 0,
    seqApplied: 0,
    frames: [] as Shown[],
    sent: [] as { seq: number; what: string; at: number; input: number }[],
    entered: 0,
    firstDrawn: 0,
};

/** When the event came by that is being followed. */
let input = 0;
for (const kind of ['input', 'pointermove', 'pointerdown', 'keydown', 'wheel']) {
    addEventListener(kind, (event) => (input = event.timeStamp), { capture: true, passive: true });
}

export function note(seq: number, what: string): void {
    counters.sent.push({ seq, what, at: performance.now(), input });
    if (counters.sent.length > KEPT) counters.sent.shift();
}

export function noteFrame(shown: Shown): void {
    counters.frame = shown.frame;
    counters.seqApplied = shown.seq;
    counters.firstDrawn ||= shown.drawn;
    counters.frames.push(shown);
    if (counters.frames.length > KEPT) counters.frames.shift();
    // The callback of the next animation frame runs before its paint, a message posted there comes after it.
    requestAnimationFrame(() => {
        const channel = new MessageChannel();
        channel.port1.onmessage = () => {
            shown.painted = performance.now();
            channel.port1.close();
        };
        channel.port2.postMessage(0);
    });
}

(window as unknown as { __desk: typeof counters }).__desk = counters;
