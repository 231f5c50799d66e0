// The page before the real program: every gesture does what it says, and the picture shows it.

import assert from 'node:assert/strict';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { brightness, caughtUp, freePort, LAMPYRIS, openBrowser, openPage, startProgram, waitState } from './desk.mjs';
import { copyOf } from './person.mjs';

const skip = LAMPYRIS ? false : 'LAMPYRIS names no program';
const SCENE = process.env.SCENE ?? 'scenes/office.mgf';

let browser;
let program;
let page;
let complaints;
before(async () => {
    if (skip) return;
    program = startProgram(SCENE);
    browser = await openBrowser();
    ({ page, complaints } = await openPage(browser));
    await page.goto(await program.link);
    await waitState(page, 'first', 'moving', 'refining', 'good', 'done');
    await page.waitForSelector('.view-strip');
});
after(async () => {
    await browser?.close();
    await program?.end();
});

const settled = () => waitState(page, 'refining', 'good', 'done').then(() => caughtUp(page));
const level = (row) => row.locator('.bottom .field input').inputValue();
const undo = () => page.locator('.bar button[aria-label^="Undo"]').getAttribute('aria-label');
const lampRow = (name) => page.locator('.fader-row', { hasText: name }).first();

test('the key leaves the address, and the picture comes', { skip }, async () => {
    assert.equal(await page.evaluate(() => location.hash), '');
    await settled();
    assert.ok((await brightness(page)) > 10);
});

test('a fader that is dragged dims the picture, in one step of undo that says what it was', { skip }, async () => {
    await settled();
    const was = await brightness(page);
    const rows = page.locator('.fader-row');
    const names = await rows.locator('.row-name span:first-child').allTextContents();
    // All lamps with one drag: the first, with all selected.
    await page.locator('#view').focus();
    await page.keyboard.press('Control+a');
    await rows.first().scrollIntoViewIfNeeded();
    const fader = await rows.first().locator('input.level').boundingBox();
    await page.mouse.move(fader.x + fader.width - 8, fader.y + fader.height / 2);
    await page.mouse.down();
    for (let k = 0; k <= 20; k++) await page.mouse.move(fader.x + fader.width * (0.95 - 0.035 * k), fader.y + fader.height / 2);
    await page.mouse.up();
    await caughtUp(page);
    await settled();
    const now = await brightness(page);
    assert.ok(now < 0.7 * was, `${names.length} lamps dimmed from ${was} to ${now}`);
    assert.ok(!(await level(rows.first())).startsWith('100'));
    assert.match(await undo(), /Undo: /);
    await page.keyboard.press('Escape');
    await page.locator('#view').focus();
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => document.querySelector('.bar button[aria-label^="Undo"]').getAttribute('aria-label') === 'Undo');
    assert.equal(await level(rows.first()), '100 %');
    await settled();
    const back = await brightness(page);
    assert.ok(Math.abs(back - was) < 0.1 * was, `${back} is not ${was}`);
});

test('levels are typed with units, and wrong ones explained', { skip }, async () => {
    const row = page.locator('.fader-row').first();
    const field = row.locator('.bottom .field input');
    await field.click();
    await field.fill('50 kelvin');
    await page.keyboard.press('Enter');
    assert.match(await row.locator('.why').innerText(), /is not a level/);
    await page.keyboard.press('Escape');
    await field.fill('-1 stop');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('.fader-row .bottom .field input').value === '50 %');
    await page.locator('#view').focus();
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => document.querySelector('.fader-row .bottom .field input').value === '100 %');
});

test('clicks select and never move; a click again goes deeper', { skip }, async () => {
    await settled();
    const view = await page.locator('#view').boundingBox();
    const before = await page.evaluate(() => document.querySelector('.bar h1').textContent);
    const steps = await undo();
    const hits = new Set();
    for (const [x, y] of [[0.3, 0.3], [0.5, 0.5], [0.7, 0.7], [0.7, 0.7]]) {
        await page.mouse.click(view.x + view.width * x, view.y + view.height * y);
        await page.waitForTimeout(400);
        hits.add(await page.locator('.inspector').innerText());
    }
    assert.ok(hits.size > 1, 'something was selected');
    assert.equal(await undo(), steps);
    assert.equal(await page.evaluate(() => document.querySelector('.bar h1').textContent), before);
    await page.keyboard.press('Escape');
});

test('keys walk, the wheel goes nearer, and back is back', { skip }, async () => {
    const number = () => page.evaluate(() => window.__desk.sent.filter((message) => message.what === 'camera').length);
    const before = await number();
    await page.locator('#view').focus();
    await page.keyboard.down('KeyW');
    await page.waitForTimeout(300);
    await page.keyboard.up('KeyW');
    await page.keyboard.press('ArrowLeft');
    const view = await page.locator('#view').boundingBox();
    await page.mouse.move(view.x + view.width * 0.5, view.y + view.height * 0.6);
    await page.mouse.wheel(0, -240);
    await page.waitForTimeout(300);
    assert.ok((await number()) > before + 2);
    await caughtUp(page);
    await page.keyboard.press('Home');
    await caughtUp(page);
    await settled();
});

test('the plan is a plan, cut open, and inside is inside again', { skip }, async () => {
    await page.locator('#view').focus();
    await page.keyboard.press('Shift+Digit1');
    await page.waitForSelector('.cut output');
    assert.match(await page.locator('.cut output').innerText(), /at \d/);
    await caughtUp(page);
    await page.keyboard.press('Shift+Digit0');
    await page.waitForFunction(() => !document.querySelector('.cut'));
    await caughtUp(page);
});

test('a lamp is hung by pointing, aimed, copied, and taken away', { skip }, async () => {
    const count = () => page.locator('.lamps h2 small').innerText().then(Number);
    const before = await count();
    const view = await page.locator('#view').boundingBox();
    await page.locator('#view').focus();
    await page.keyboard.press('n');
    await page.mouse.click(view.x + view.width * 0.5, view.y + view.height * 0.75);
    await page.waitForFunction((n) => Number(document.querySelector('.lamps h2 small').textContent) === n + 1, before);
    await page.waitForSelector('[data-handle="move-view"]', { state: 'attached' });
    await page.locator('#view').focus();
    await page.keyboard.press('t');
    assert.equal(await page.locator('#view').getAttribute('data-tool'), 'aim');
    await page.mouse.click(view.x + view.width * 0.4, view.y + view.height * 0.8);
    await page.waitForFunction(() => document.querySelector('#view').dataset.tool === '');
    await page.waitForFunction(() => /Undo: Aim/.test(document.querySelector('.bar button[aria-label^="Undo"]').getAttribute('aria-label')));
    await page.keyboard.press('Control+d');
    await page.waitForFunction((n) => Number(document.querySelector('.lamps h2 small').textContent) === n + 2, before);
    for (let k = 0; k < 3; k++) {
        await page.locator('#view').focus();
        await page.keyboard.press('Control+z');
        await page.waitForTimeout(200);
    }
    await page.waitForFunction((n) => Number(document.querySelector('.lamps h2 small').textContent) === n, before);
    await page.keyboard.press('Escape');
});

test('a group has a master that dims the picture, and is dissolved and undone', { skip }, async () => {
    await settled();
    const was = await brightness(page);
    const groups = await page.locator('.fader-row.group').count();
    await page.locator('#view').focus();
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Control+g');
    await page.waitForSelector('[aria-label="Master of the group"]');
    assert.equal(await page.getByLabel('Name of the group').inputValue(), 'Group 1');
    assert.equal(await page.locator('.fader-row.group').count(), 1, 'all are in this one, and in no other');
    await page.getByLabel('Master of the group').fill('25');
    await page.keyboard.press('Enter');
    await caughtUp(page);
    await settled();
    const now = await brightness(page);
    assert.ok(now < 0.8 * was, `from ${was} to ${now}`);
    await page.locator('#view').focus();
    await page.keyboard.press('Control+Shift+g');
    await page.waitForFunction(() => !document.querySelector('.fader-row.group'));
    for (let k = 0; k < 3; k++) {
        await page.locator('#view').focus();
        await page.keyboard.press('Control+z');
        await page.waitForTimeout(200);
    }
    await page.waitForFunction((n) => document.querySelectorAll('.fader-row.group').length === n, groups);
    await page.keyboard.press('Escape');
    await settled();
    const back = await brightness(page);
    assert.ok(Math.abs(back - was) < 0.1 * was, `${back} is not ${was}`);
});

/**
 * From now on, for each frame that is drawn: how far what is drawn over the lamp is from its pixels [CSS pixels], across or
 * down, by the middles of both. The box that is drawn is taken as the outline of its corners, the pixels are those as bright as can be.
 */
const watchLamp = (watched) => watched.evaluate(() => {
    /** The middle of the area that points span. */
    const middleOf = (points) => {
        const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
        const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
        const chain = (list) => list.reduce((hull, p) => {
            while (hull.length > 1 && turn(hull.at(-2), hull.at(-1), p) <= 0) hull.pop();
            return [...hull, p];
        }, []).slice(0, -1);
        const hull = [...chain(sorted), ...chain(sorted.toReversed())];
        let [area, x, y] = [0, 0, 0];
        hull.forEach((p, k) => {
            const q = hull[(k + 1) % hull.length];
            const cross = p[0] * q[1] - p[1] * q[0];
            [area, x, y] = [area + cross, x + (p[0] + q[0]) * cross, y + (p[1] + q[1]) * cross];
        });
        return [x / (3 * area), y / (3 * area)];
    };
    const gap = () => {
        const canvas = document.querySelector('.stage canvas');
        const view = document.getElementById('view').getBoundingClientRect();
        const scale = Math.min(view.width / canvas.width, view.height / canvas.height);
        const [x0, y0] = [(view.width - canvas.width * scale) / 2, (view.height - canvas.height * scale) / 2];
        const path = document.querySelector('#overlay .boxes').getAttribute('d') ?? '';
        const points = [...path.matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)].map((m) => [Number(m[1]), Number(m[2])]);
        // Only as long as all of it is seen.
        const inside = ([x, y]) => x > x0 + 2 && y > y0 + 2 && x < view.width - x0 - 2 && y < view.height - y0 - 2;
        if (points.length < 3 || !points.every(inside)) return null;
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        // Other things may shine too, but not so close.
        const near = (v, axis, from) => {
            const at = from + (v + 0.5) * scale;
            return at > Math.min(...points.map((p) => p[axis])) - 30 && at < Math.max(...points.map((p) => p[axis])) + 30;
        };
        const [columns, rows] = [[canvas.width, 0, x0], [canvas.height, 1, y0]].map(([n, axis, from]) => Array.from({ length: n }, (_, v) => near(v, axis, from)));
        let [count, x, y] = [0, 0, 0];
        for (let k = 0; k < canvas.width * canvas.height; k++) {
            if (!columns[k % canvas.width] || !rows[Math.floor(k / canvas.width)]) continue;
            // By luma: a JPEG has it of each pixel, colour of four together.
            if (0.299 * data[4 * k] + 0.587 * data[4 * k + 1] + 0.114 * data[4 * k + 2] < 242) continue;
            [count, x, y] = [count + 1, x + (k % canvas.width) + 0.5, y + Math.floor(k / canvas.width) + 0.5];
        }
        if (!count) return { gap: Infinity, pixel: scale };
        const [drawn, seen] = [middleOf(points), [x0 + (x / count) * scale, y0 + (y / count) * scale]];
        return { gap: Math.max(Math.abs(drawn[0] - seen[0]), Math.abs(drawn[1] - seen[1])), pixel: scale, drawn, seen, count };
    };
    window.__gaps = [];
    let last = 0;
    const look = () => {
        const frame = window.__desk.frames.at(-1);
        if (frame && frame.frame !== last) {
            last = frame.frame;
            const own = gap();
            if (own) window.__gaps.push({ ...own, moving: frame.kind === 0 });
        }
        requestAnimationFrame(look);
    };
    look();
});

test('what is drawn over the picture stays on the lamp while one walks', { skip }, async (t) => {
    const own = startProgram('scenes/cornell.mgf');
    const other = await openPage(browser);
    await other.page.goto(await own.link);
    await waitState(other.page, 'refining', 'good', 'done');
    await other.page.waitForSelector('.view-strip');
    await other.page.locator('.fader-row .row-name').first().click();
    await watchLamp(other.page);
    await other.page.locator('#view').focus();
    // To and fro, ahead and back, so that the lamp stays in the picture most of the time.
    for (const [key, ms] of [['KeyS', 900], ['ArrowLeft', 300], ['ArrowRight', 600], ['KeyA', 500], ['KeyD', 900], ['KeyW', 600], ['ArrowUp', 200], ['KeyE', 300]]) {
        await other.page.keyboard.down(key);
        await other.page.waitForTimeout(ms);
        await other.page.keyboard.up(key);
    }
    await caughtUp(other.page);
    await waitState(other.page, 'refining', 'good', 'done');
    await other.page.waitForTimeout(300);
    const gaps = await other.page.evaluate(() => window.__gaps);
    const moving = gaps.filter((own) => own.moving);
    const middle = gaps.map((own) => own.gap).sort((x, y) => x - y)[gaps.length >> 1];
    const most = (list) => Math.max(...list.map((own) => own.gap)).toFixed(2);
    t.diagnostic(`${moving.length} frames while walking: at most ${most(moving)} px beside the lamp, median ${middle.toFixed(2)}; at rest ${most(gaps.filter((own) => !own.moving))}`);
    assert.ok(moving.length >= 8 && gaps.length > moving.length, `${moving.length} frames of a walk, ${gaps.length} in all`);
    // Most of them by far. A frame that moves may be coarse, of pixels of 4 on a slow machine, and a lamp a few of them thin:
    // then one of its rows more or less is seen.
    assert.ok(middle < 1.5, `the median is ${middle} px`);
    const far = gaps.filter((own) => own.gap > Math.max(2, own.pixel));
    assert.deepEqual(far, []);
    await other.page.context().close();
    await own.end();
});

test('the program may be ended and started again: the page says so and comes back', { skip }, async () => {
    // At a port that is named the key is the same each time; it is kept in a folder of this test's own.
    const state = await mkdtemp(join(tmpdir(), 'lampyris-state-'));
    process.env.XDG_STATE_HOME = state;
    const [scene, port] = [await copyOf('scenes/cornell.mgf'), String(await freePort())];
    const start = () => startProgram(scene.file, '--port', port);
    const own = start();
    const other = await openPage(browser);
    await other.page.goto(await own.link);
    await waitState(other.page, 'first', 'moving', 'refining', 'good', 'done');
    await other.page.waitForSelector('.view-strip');
    const level = other.page.locator('.fader-row .bottom .field input').first();
    await own.end('SIGKILL');
    await waitState(other.page, 'lost', 'ended');
    await other.page.locator('.fader-row .power').first().click();
    await other.page.waitForFunction(() => /nothing was changed/.test(document.querySelector('.notes').innerText));
    const frames = await other.page.evaluate(() => window.__desk.frames.length);
    const again = start();
    assert.equal(await again.link, await own.link);
    await waitState(other.page, 'first', 'moving', 'refining', 'good', 'done');
    // It is a desk again: pictures come, and a level is heard.
    await other.page.waitForFunction((n) => window.__desk.frames.length > n, frames);
    await level.fill('50 %');
    await other.page.keyboard.press('Enter');
    await other.page.waitForFunction(() => /Undo: .*50 %/.test(document.querySelector('.bar button[aria-label^="Undo"]').getAttribute('aria-label')));
    assert.deepEqual(other.complaints, []);
    await again.end();
    await other.page.context().close();
    delete process.env.XDG_STATE_HOME;
    await rm(state, { recursive: true });
    await scene.remove();
});

test('nothing was complained of', { skip }, () => assert.deepEqual(complaints, []));
