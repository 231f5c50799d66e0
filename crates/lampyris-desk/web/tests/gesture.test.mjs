// The rules of a gesture, over a line that delays: the handle never moves against the hand, the last value wins, one step.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { browserless, load } from './bundle.mjs';

browserless();

/** A program that follows what it hears after `delay`, and counts steps; the one end of a socket. */
class Program {
    static delay = 0;
    static last = null;
    static OPEN = 1;
    readyState = 1;
    level = 1;
    steps = [];
    gesture = null;
    heard = [];
    constructor() {
        Program.last = this;
        setTimeout(() => {
            this.tell({ is: 'hello', protocol: 1, build: 'b', you: 1, role: 'edit' });
            this.tell({ is: 'state', state: { lamps: { 3: this.lamp() }, scene: { name: 's' }, editor: { you: true } } });
        }, 0);
    }
    lamp = () => ({ name: 'desk', on: true, level: this.level, flux: 100, group: null });
    tell(message) {
        setTimeout(() => this.onmessage?.({ data: JSON.stringify(message) }), Program.delay / 2);
    }
    send(text) {
        const message = JSON.parse(text);
        setTimeout(() => this.follow(message), Program.delay / 2);
    }
    follow(message) {
        this.heard.push(message);
        if (message.do === 'begin') this.gesture = { label: message.label, from: this.level };
        if (message.do === 'set') {
            this.level = message.patch.lamps[3].level;
            this.tell({ is: 'patch', seq: message.seq, patch: { lamps: { 3: this.lamp() } } });
        }
        if (message.do === 'end') {
            this.steps.push(this.gesture);
            this.gesture = null;
            this.tell({ is: 'patch', seq: message.seq, patch: {} });
        }
        if (message.do === 'cancel') {
            this.level = this.gesture.from;
            this.gesture = null;
            this.tell({ is: 'patch', seq: message.seq, patch: { lamps: { 3: this.lamp() } } });
        }
    }
    close() {}
}
globalThis.WebSocket = Program;
globalThis.fetch = () => Promise.reject(new Error('no network here'));

const desk = await load('wire', 'store', 'gesture');
await desk.connect();
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
await wait(30);
const shown = () => desk.lamps.get(3).level;

for (const delay of [0, 50, 300]) {
    test(`200 values a second for 3 s over a line of ${delay} ms`, async () => {
        Program.delay = delay;
        const program = Program.last;
        program.heard = [];
        const steps = program.steps.length;
        const gesture = new desk.Gesture('Dim');
        let held = null;
        let against = 0;
        const stop = desk.lamps.entry(3).shown.subscribe((lamp) => {
            if (held !== null && Math.abs(lamp.level - held) > 1e-12) against++;
        });
        const start = performance.now();
        for (let k = 0; performance.now() - start < 3000; k++) {
            held = 0.5 + 0.4 * Math.sin(k / 20);
            gesture.set({ lamps: { 3: { level: held } } });
            assert.equal(shown(), held);
            await wait(5);
        }
        const last = held;
        gesture.end('Dim to there');
        // It is not held any more, but what the program has not followed yet must not come back.
        for (let k = 0; k < 20; k++) {
            assert.equal(shown(), last);
            await wait(delay / 8 + 2);
        }
        held = null;
        stop();
        await wait(2 * delay + 30);
        assert.equal(against, 0);
        assert.equal(program.level, last);
        assert.equal(shown(), last);
        assert.equal(program.steps.length, steps + 1);
        // At most one value is under way: no more are sent than answers can have come, and the last.
        const sets = program.heard.filter((message) => message.do === 'set').length;
        if (delay) assert.ok(sets <= 3000 / delay + 3, `${sets} values`);
        assert.deepEqual(program.heard.at(-1).do, 'end');
    });
}

test('cancel brings back what was', async () => {
    Program.delay = 20;
    const before = shown();
    const gesture = new desk.Gesture('Dim');
    gesture.set({ lamps: { 3: { level: 0.01 } } });
    await wait(30);
    gesture.set({ lamps: { 3: { level: 0.02 } } });
    gesture.cancel();
    await wait(80);
    assert.equal(shown(), before);
    assert.equal(Program.last.level, before);
});

test('two hands at once are one step', async () => {
    Program.delay = 10;
    const steps = Program.last.steps.length;
    const [a, b] = [new desk.Gesture('A'), new desk.Gesture('B')];
    a.set({ lamps: { 3: { level: 0.3 } } });
    b.set({ lamps: { 3: { level: 0.4 } } });
    a.end();
    b.set({ lamps: { 3: { level: 0.6 } } });
    b.end();
    await wait(60);
    assert.equal(Program.last.steps.length, steps + 1);
    assert.equal(shown(), 0.6);
});

test('strokes that follow each other are one step', async () => {
    Program.delay = 0;
    const steps = Program.last.steps.length;
    for (let k = 0; k < 5; k++) {
        desk.stroke('level', 'Level', { lamps: { 3: { level: 0.1 * k } } });
        await wait(50);
    }
    await wait(900);
    desk.stroke('level', 'Level', { lamps: { 3: { level: 0.9 } } });
    desk.endStroke();
    await wait(40);
    assert.equal(Program.last.steps.length, steps + 2);
});

test('without a line nothing is changed and nothing waits', async () => {
    const program = Program.last;
    const level = shown();
    desk.line.value = 'lost';
    desk.edit('Dim', { lamps: { 3: { level: 0.123 } } });
    assert.equal(shown(), level);
    desk.line.value = 'open';
    await wait(30);
    assert.equal(program.level, level);
});
