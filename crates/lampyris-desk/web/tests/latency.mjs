// How long the light takes to follow the hand: from the input event to the paint of the first frame that contains it.
//
//   node tests/latency.mjs LINK|SCENE [--events 200] [--size 640x480] [--every 40] [--lamp NAME]
//
// A link is that of a program that runs; for a scene one is started ($LAMPYRIS) on a copy of it. Real drags of a real browser: a fader, a
// lamp by its handle, the camera. Each is split into what the page, the line and the program took of it.

import { loadavg } from 'node:os';
import { openBrowser, startProgram, waitState } from './desk.mjs';
import { copyOf } from './person.mjs';

const [target, ...rest] = process.argv.slice(2);
if (!target) {
    console.error('usage: node tests/latency.mjs LINK|SCENE [--events 200] [--size 640x480] [--every 40] [--lamp NAME]');
    process.exit(2);
}
const option = (name, otherwise) => (rest.includes(`--${name}`) ? rest[rest.indexOf(`--${name}`) + 1] : otherwise);
const events = Number(option('events', 200));
const every = Number(option('every', 40));
const [width, height] = option('size', '640x480').split('x').map(Number);
const wanted = option('lamp', '');

const copy = target.startsWith('http') ? null : await copyOf(target);
const program = copy && startProgram(copy.file);
const link = program ? await program.link : target;
const browser = await openBrowser();
const page = await (await browser.newContext({ viewport: { width: Math.max(1280, width + 620), height: Math.max(760, height + 200) } })).newPage();
await page.goto(link);
await waitState(page, 'refining', 'good', 'done');

// Panels leave the view what remains, which depends on much: it is given the size asked for.
await page.locator('#view').evaluate((view, [w, h]) => Object.assign(view.style, { width: `${w}px`, height: `${h}px`, justifySelf: 'start', alignSelf: 'start' }), [width, height]);
await page.waitForFunction(([w, h]) => window.__desk.frames.at(-1)?.width === w && window.__desk.frames.at(-1)?.height === h, [width, height], { timeout: 60_000 }).catch(() => {});

console.log(`${copy ? target : 'a desk that runs'}: a view of ${width} × ${height}, load ${loadavg()[0].toFixed(1)}`);
const median = (list, share = 0.5) => [...list].sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(list.length * share))] ?? NaN;

/** Drags, and returns how long each value of that kind took, split. */
async function measure(kinds, drag) {
    await waitState(page, 'good', 'done', 'refining');
    await page.waitForTimeout(500);
    // Rings of the page are shorter than a long drag: they are read while it lasts.
    const sent = new Map();
    const frames = new Map();
    const read = async () => {
        const { sent: s, frames: f } = await page.evaluate(() => ({ sent: window.__desk.sent, frames: window.__desk.frames }));
        for (const m of s) sent.set(`${m.seq} ${m.at}`, m);
        for (const m of f) if (m.painted) frames.set(m.frame, m);
    };
    const start = await page.evaluate(() => performance.now());
    let done = false;
    const reader = (async () => {
        while (!done) {
            await read();
            await new Promise((next) => setTimeout(next, 500));
        }
    })();
    await drag();
    await page.waitForTimeout(2500);
    done = true;
    await reader;
    await read();
    const drawn = [...frames.values()].sort((a, b) => a.frame - b.frame);
    const rows = [];
    for (const message of sent.values()) {
        if (!kinds.includes(message.what) || message.at < start) continue;
        const frame = drawn.find((f) => f.seq >= message.seq && f.received >= message.at);
        if (!frame) continue;
        const input = message.input || message.at;
        const total = frame.painted - input;
        // Light that was there before the hand moved, as for a dimmer, took nothing of this time.
        const render = Math.max(0, Math.min(frame.light, frame.received - message.at - frame.encode));
        const known = (message.at - input) + render + frame.encode + (frame.decoded - frame.received) + (frame.painted - frame.decoded);
        rows.push({
            total, send: message.at - input, render, encode: frame.encode,
            // What is left was spent on the line, both ways, and waiting for the frame at hand.
            'wait and line': Math.max(0, total - known), decode: frame.decoded - frame.received, paint: frame.painted - frame.decoded,
            width: frame.width, height: frame.height, bytes: frame.bytes,
        });
    }
    return rows;
}

function print(name, rows) {
    if (!rows.length) return console.log(`${name}: nothing was measured`);
    const total = rows.map((row) => row.total);
    console.log(`${name.padEnd(14)} ${String(rows.length).padStart(4)} values   median ${median(total).toFixed(0)} ms   p95 ${median(total, 0.95).toFixed(0)} ms`);
    const parts = ['send', 'wait and line', 'render', 'encode', 'decode', 'paint'];
    console.log(`               ${parts.map((part) => `${part} ${median(rows.map((row) => row[part])).toFixed(1)}`).join('   ')}`);
    const of = (what) => median(rows.map((row) => row[what]));
    console.log(`               frames of ${of('width')} × ${of('height')} pixels, ${Math.round(of('bytes') / 1000)} kB`);
}

async function along(points) {
    await page.mouse.move(...points[0]);
    await page.mouse.down();
    for (const point of points.slice(1)) {
        await page.mouse.move(...point);
        await page.waitForTimeout(every);
    }
    await page.mouse.up();
}
const wave = (k) => Math.sin((2 * Math.PI * k) / 50);

if (wanted) await page.getByLabel('Filter lamps').fill(wanted);
const row = wanted ? page.locator('.fader-row', { hasText: wanted }).first() : page.locator('.fader-row.lamp, .fader-row').nth(1);
const fader = await row.locator('input.level').boundingBox();
print('dimmer', await measure(['set'], () => along(Array.from({ length: events }, (_, k) => [fader.x + fader.width * (0.55 + 0.35 * wave(k)), fader.y + fader.height / 2]))));

const box = await page.locator('#view').boundingBox();
const middle = [box.x + box.width / 2, box.y + box.height / 2];
print('camera', await measure(['camera'], async () => {
    await page.mouse.move(...middle);
    await page.mouse.down({ button: 'right' });
    for (let k = 0; k < events; k++) {
        await page.mouse.move(middle[0] + 60 * wave(k), middle[1] + 10 * wave(k * 2));
        await page.waitForTimeout(every);
    }
    await page.mouse.up({ button: 'right' });
}));

// Narrow pages show the inspector in the place of the lamps once something was selected.
if (!(await row.isVisible())) await page.locator('.bar .narrow').click();
await row.locator('.row-name').click();
await page.keyboard.press('f');
await page.waitForSelector('[data-handle="move-view"]:not(.gone)', { timeout: 20_000 }).catch(() => {});
await page.waitForTimeout(1500);
const handle = await page.locator('[data-handle="move-view"] .seen').boundingBox().catch(() => null);
if (handle) {
    const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2];
    print('dragged lamp', await measure(['set'], () => along(Array.from({ length: events }, (_, k) => [x + 40 * wave(k), y]))));
} else console.log('dragged lamp: this lamp has no handle');

await browser.close();
await program?.end();
await copy?.remove();
