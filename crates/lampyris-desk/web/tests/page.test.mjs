// The page before the real program: every gesture does what it says, and the picture shows it.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { brightness, caughtUp, LAMPYRIS, openBrowser, openPage, startProgram, waitState } from './desk.mjs';

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

test('what is drawn over the picture stays on the lamp while one walks', { skip }, async () => {
    const own = startProgram('scenes/cornell.mgf');
    const other = await openPage(browser);
    await other.page.goto(await own.link);
    await waitState(other.page, 'refining', 'good', 'done');
    await other.page.waitForSelector('.view-strip');
    await other.page.locator('.fader-row .row-name').first().click();
    const gaps = [];
    for (let step = 0; step < 6; step++) {
        await other.page.locator('#view').focus();
        for (const key of step % 2 ? ['ArrowLeft', 'KeyW'] : ['ArrowRight', 'ArrowUp']) await other.page.keyboard.press(key, { delay: 60 });
        await caughtUp(other.page);
        await waitState(other.page, 'refining', 'good', 'done');
        await other.page.waitForTimeout(300);
        // Both of one moment: the box that is drawn, and the pixels that are as bright as can be.
        const gap = await other.page.evaluate(() => {
            const canvas = document.querySelector('.stage canvas');
            const view = document.getElementById('view').getBoundingClientRect();
            const scale = Math.min(view.width / canvas.width, view.height / canvas.height);
            const [x0, y0] = [(view.width - canvas.width * scale) / 2, (view.height - canvas.height * scale) / 2];
            const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            const lit = [Infinity, Infinity, -Infinity, -Infinity];
            for (let y = 0; y < canvas.height; y++) {
                for (let x = 0; x < canvas.width; x++) {
                    const k = 4 * (y * canvas.width + x);
                    if (data[k] < 252 || data[k + 1] < 252 || data[k + 2] < 200) continue;
                    lit[0] = Math.min(lit[0], x);
                    lit[1] = Math.min(lit[1], y);
                    lit[2] = Math.max(lit[2], x + 1);
                    lit[3] = Math.max(lit[3], y + 1);
                }
            }
            const box = document.querySelector('#overlay .boxes').getBBox();
            const drawn = [box.x, box.y, box.x + box.width, box.y + box.height];
            const inside = drawn[0] > x0 && drawn[1] > y0 && drawn[2] < view.width - x0 && drawn[3] < view.height - y0;
            if (!inside || !Number.isFinite(lit[0])) return null;
            const seen = [x0 + lit[0] * scale, y0 + lit[1] * scale, x0 + lit[2] * scale, y0 + lit[3] * scale];
            return Math.max(...seen.map((v, k) => Math.abs(v - drawn[k])));
        });
        if (gap !== null) gaps.push(gap);
    }
    assert.ok(gaps.length >= 2, 'the lamp was seen');
    assert.ok(gaps.every((gap) => gap <= 2), `gaps of ${gaps.map((gap) => gap.toFixed(1))} px`);
    await other.page.context().close();
    await own.end();
});

test('the program may be ended and started again: the page says so and comes back', { skip }, async () => {
    const own = startProgram('scenes/cornell.mgf');
    const link = await own.link;
    const other = await openPage(browser);
    await other.page.goto(link);
    await waitState(other.page, 'first', 'moving', 'refining', 'good', 'done');
    await own.end('SIGKILL');
    await waitState(other.page, 'lost', 'ended');
    await other.page.locator('.fader-row .power').first().click();
    await other.page.waitForFunction(() => /nothing was changed/.test(document.querySelector('.notes').innerText));
    const port = new URL(link).port;
    const again = startProgram('scenes/cornell.mgf', '--port', port);
    await again.link;
    await waitState(other.page, 'first', 'moving', 'refining', 'good', 'done', 'denied');
    await again.end();
    await other.page.context().close();
});

test('nothing was complained of', { skip }, () => assert.deepEqual(complaints, []));
