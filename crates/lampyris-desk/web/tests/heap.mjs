// Whether the page keeps what it needs no more: its heap, and the program's memory, over many edits by chance.
//
//   node tests/heap.mjs [SCENE] [--edits 10000] [--seed 1]
//
// Starts $LAMPYRIS on a copy of the scene, and works the page by keys: levels, switches, colours, solo, undo, redo,
// selections. Now and then garbage is collected and what is left is told; the slope is that of a line through what was left
// after the first third.

import { readFile } from 'node:fs/promises';
import { loadavg } from 'node:os';
import { sitDown } from './person.mjs';

const given = process.argv.slice(2);
const option = (name, otherwise) => (given.includes(`--${name}`) ? given.splice(given.indexOf(`--${name}`), 2)[1] : otherwise);
const wanted = Number(option('edits', 10_000));
let dice = Number(option('seed', 1));
const scene = given[0] ?? 'scenes/cornell.mgf';

/** A number from 0 to n − 1: Lehmer's generator. */
const roll = (n) => {
    dice = (dice * 48271) % 2147483647;
    return dice % n;
};

const desk = await sitDown(scene, { width: 1000, height: 640, more: ['--size', '320x240'] });
const { page } = desk;
const client = await page.context().newCDPSession(page);
await client.send('Performance.enable');
await client.send('HeapProfiler.enable');

/** Edits the program has heard of; the page's ring of what it sent is read before it turns round. */
let edits = 0;
let heard = 0;
const count = async () => {
    const sent = await page.evaluate((after) => window.__desk.sent.filter((m) => m.seq > after).map((m) => [m.seq, m.what]), heard);
    heard = sent.at(-1)?.[0] ?? heard;
    edits += sent.filter(([, what]) => ['set', 'undo', 'redo', 'add', 'copy', 'remove'].includes(what)).length;
};

const rows = [];
const began = performance.now();
async function sample() {
    // Weighed as it stands with nothing selected and nothing under way.
    for (let k = 0; k < 2; k++) await onView('Escape');
    await page.waitForTimeout(800);
    await client.send('HeapProfiler.collectGarbage');
    const { metrics } = await client.send('Performance.getMetrics');
    const of = (name) => metrics.find((m) => m.name === name).value;
    const status = await readFile(`/proc/${desk.pid}/status`, 'utf8').catch(() => '');
    const resident = Number(/VmRSS:\s+(\d+)/.exec(status)?.[1] ?? NaN) / 1024;
    const row = { edits, hours: (performance.now() - began) / 3.6e6, heap: of('JSHeapUsedSize') / 2 ** 20, nodes: of('Nodes'), listeners: of('JSEventListeners'), resident };
    rows.push(row);
    console.log(`${String(edits).padStart(6)} edits  ${(row.hours * 3600).toFixed(0).padStart(5)} s  heap ${row.heap.toFixed(2)} MiB  nodes ${row.nodes}  listeners ${row.listeners}  program ${resident.toFixed(0)} MiB`);
}

/** Least squares: how much `of` grows with `by`. */
function slope(list, by, of) {
    const mean = (what) => list.reduce((sum, row) => sum + row[what], 0) / list.length;
    const [x, y] = [mean(by), mean(of)];
    return list.reduce((sum, row) => sum + (row[by] - x) * (row[of] - y), 0) / list.reduce((sum, row) => sum + (row[by] - x) ** 2, 0);
}

const faders = page.locator('.fader-row input.level');
const lamps = await faders.count();
const key = (name) => page.keyboard.press(name);
const onView = async (name) => {
    await page.locator('#view').focus();
    await key(name);
};
const acts = [
    // A hand on a fader: some steps.
    async () => {
        await faders.nth(roll(lamps)).focus();
        for (let k = 2 + roll(12); k > 0; k--) await key(roll(2) ? 'ArrowUp' : 'ArrowDown');
    },
    async () => {
        await faders.nth(roll(lamps)).focus();
        await key(['Home', 'End', 'PageUp', 'PageDown'][roll(4)]);
    },
    () => onView('o'),
    () => onView('i'),
    () => onView('Control+z'),
    () => onView('Control+z'),
    () => onView('Control+Shift+z'),
    () => onView('Control+a'),
    () => onView('Escape'),
    async () => {
        await page.locator('.fader-row .row-name').nth(roll(lamps)).click();
    },
];

await page.waitForTimeout(2000);
console.log(`${scene}, load ${loadavg()[0].toFixed(1)}`);
for (let due = 0; edits < wanted; ) {
    if (edits >= due) {
        await sample();
        due = edits + wanted / 20;
    }
    for (let k = 0; k < 10; k++) await acts[roll(20) < 10 ? 0 : roll(acts.length)]();
    await count();
}
await sample();
const later = rows.filter((row) => row.edits >= wanted / 3);
console.log(`page: ${(slope(later, 'edits', 'heap') * 1024 * 1000).toFixed(1)} KiB for 1000 edits, ${slope(later, 'hours', 'heap').toFixed(2)} MiB an hour of such edits`);
console.log(`nodes: ${(slope(later, 'edits', 'nodes') * 1000).toFixed(2)} for 1000 edits; program: ${slope(later, 'hours', 'resident').toFixed(2)} MiB an hour`);
console.log(desk.complaints.length ? desk.complaints.join('\n') : 'the page complained of nothing');
await desk.stand();
