// Five tasks of everyday work, done as a person does who has not read the help: by what is written on the page, with mouse
// and keyboard. Each says how many gestures it took and how long, and is believed only if values and pixels both show it.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { caughtUp, LAMPYRIS } from './desk.mjs';
import { colorOf, mean, Person, planAt, rested, sitDown } from './person.mjs';

const skip = LAMPYRIS ? false : 'LAMPYRIS names no program';
/** A folder for what the page shows after each task. */
const { SHOTS } = process.env;
/** What a person may take for each [s]; the tests wait for pictures at rest besides. */
const PATIENCE = 60;
/** Parts of the first picture, in shares: the table, and the floor before the chair. */
const TABLE = [0.6, 0.56, 0.16, 0.06];
const FLOOR = [0.35, 0.85, 0.3, 0.1];

let desk;
let page;
before(async () => {
    if (skip) return;
    desk = await sitDown('scenes/office.mgf', { width: 1280, height: 720 });
    page = desk.page;
});
after(() => desk?.stand());

/** What was spent on waiting for figures [ms]: that is the machine's time. */
let waited = 0;

/** Does a task; waiting for pictures at rest before and after is not the person's time. */
async function task(t, does) {
    const shot = SHOTS && join(SHOTS, `task-${t.name.replace(/\W+/g, '-')}.png`);
    await rested(page);
    const person = new Person(page);
    const begun = performance.now();
    waited = 0;
    await does(person);
    await caughtUp(page);
    const seconds = (performance.now() - begun - waited) / 1000;
    t.diagnostic(`${person.counted()}; the picture followed after ${seconds.toFixed(1)} s${waited ? `, figures took ${(waited / 1000).toFixed(1)} s` : ''}`);
    assert.ok(seconds < PATIENCE, `${seconds} s`);
    await rested(page);
    if (shot) await page.screenshot({ path: shot });
}

const flux = (lamp) => new Person(page).fader(lamp).locator('.lumens').innerText();
const numberOf = (text) => Number(text.replace(/[^\d.]/g, ''));
const undone = () => page.locator('.bar button[aria-label^="Undo"]').getAttribute('aria-label');

test('dim the desk lamp', { skip }, async (t) => {
    await task(t, async (person) => {
        await person.click(person.fader('lamp_desk/bulb').locator('.row-name'));
        await person.click(page.locator('.inspector').getByRole('button', { name: 'Frame' }));
    });
    const [under, shelf] = [[0.5, 0.7, 0.14, 0.1], [0.75, 0.3, 0.2, 0.25]];
    const [was, books] = [mean(await colorOf(page, under)), mean(await colorOf(page, shelf))];
    const lumens = numberOf(await flux('lamp_desk/bulb'));
    await task(t, async (person) => person.slide(person.fader('lamp_desk/bulb').locator('input.level'), 1, 0.5));
    const level = numberOf(await new Person(page).fader('lamp_desk/bulb').getByLabel(/level, typed/).inputValue()) / 100;
    assert.ok(level > 0.2 && level < 0.3, `half the travel of the square law is ${level}`);
    assert.ok(Math.abs(numberOf(await flux('lamp_desk/bulb')) - level * lumens) < 0.02 * lumens);
    assert.match(await undone(), /lamp_desk\/bulb 100 → 2\d %/);
    const [now, beside] = [mean(await colorOf(page, under)), mean(await colorOf(page, shelf))];
    assert.ok(now < 0.93 * was, `under the lamp from ${was} to ${now}`);
    assert.ok(Math.abs(beside - books) < 0.02 * books, `the shelf from ${books} to ${beside}`);
    await page.keyboard.press('Escape');
    await new Person(page).press('Home');
});

test('make the room 3000 K', { skip }, async (t) => {
    const lamps = await page.locator('.fader-row .row-name').count();
    const lumens = await page.locator('.fader-row .lumens').allInnerTexts();
    await rested(page);
    const was = await colorOf(page, [0, 0, 1, 1]);
    await task(t, async (person) => {
        await person.press('Control+a');
        await person.click(person.button('White'));
        await person.click(person.button('3000 kelvin, warm white'));
    });
    const told = await page.locator('.fader-row .tint').allInnerTexts();
    assert.deepEqual(told.map((text) => text.trim()), Array(lamps).fill('3000 K'));
    assert.deepEqual(await page.locator('.fader-row .lumens').allInnerTexts(), lumens, 'a colour keeps the lumens');
    const now = await colorOf(page, [0, 0, 1, 1]);
    assert.ok(now[2] / now[0] < 0.92 * (was[2] / was[0]), `blue to red from ${was} to ${now}`);
    await page.keyboard.press('Escape');
});

test('hang a lamp over the table and aim it', { skip }, async (t) => {
    await rested(page);
    const lamps = await page.locator('.fader-row').count();
    const [table, elsewhere] = [mean(await colorOf(page, TABLE)), mean(await colorOf(page, FLOOR))];
    await task(t, async (person) => {
        await person.click(person.button('Add a lamp'));
        await person.click(page.getByRole('button', { name: /Add a spot lamp by pointing/ }));
        await person.point(0.645, 0.617);
        await page.waitForFunction((n) => document.querySelectorAll('.fader-row').length === n + 1, lamps);
        await page.waitForSelector('.inspector .tools');
        await person.click(page.locator('.inspector').getByRole('button', { name: 'Aim', exact: true }));
        await person.point(0.66, 0.615);
        await page.waitForFunction(() => /Undo: Aim/.test(document.querySelector('.bar button[aria-label^="Undo"]').getAttribute('aria-label')));
    });
    assert.equal(await page.locator('.inspector').getByLabel('Name of the lamp').inputValue(), 'Spot 1');
    // The table's middle is (4.05, 1.39), its top at 0.42 m.
    const at = async (what) => Promise.all('XYZ'.split('').map(async (axis) => numberOf(await page.getByLabel(`${what} ${axis}`).inputValue())));
    const [place, aim] = [await at('Position'), await at('Aims at')];
    assert.ok(aim[2] < 0.6 && aim[2] > 0.38, `it is aimed at the table or what stands on it: ${aim}`);
    assert.ok(Math.abs(place[2] - aim[2] - 1.2) < 0.15, `it hangs 1.2 m above: ${place}`);
    const now = mean(await colorOf(page, TABLE));
    const beside = mean(await colorOf(page, FLOOR));
    assert.ok(now > 1.1 * table, `the table from ${table} to ${now}`);
    assert.ok(Math.abs(beside / elsewhere - 1) < 0.5 * (now / table - 1), `the floor beside from ${elsewhere} to ${beside}`);
    await page.keyboard.press('Escape');
});

/** What the strip says of the one area: mean [lx], uniformity, and whether they reach the target: ✓, ✗, or ≈ while that is open. */
const area = async () => {
    const text = await page.locator('.readings .reading').innerText();
    const [, mean] = /Ē ([\d.]+) lx/.exec(text) ?? [0, NaN];
    const [, uniformity] = /U₀ ([\d.]+)/.exec(text) ?? [0, NaN];
    return { mean: Number(mean), uniformity: Number(uniformity), verdict: /[✓✗≈]/.exec(text)?.[0], text };
};

/** Waits for something to be true of the reading; that is not the person's time. */
const until = async (test, argument) => {
    const begun = performance.now();
    await page.waitForFunction(test, argument, { timeout: 300_000 });
    waited += performance.now() - begun;
};

/** Other figures than before, their mean known to a tenth. */
const measured = (before) => until((old) => {
    const { innerText: now } = document.querySelector('.readings .reading') ?? {};
    const [, mean, off] = /Ē ([\d.]+) lx ±([\d.]+)/.exec(now) ?? [0, 0, 1];
    return now !== old && off <= 0.1 * mean;
}, before);

test('reach 500 lx with a uniformity of 0.6 on the desk', { skip }, async (t) => {
    await rested(page);
    await task(t, async (person) => {
        await person.click(person.button('Plan'));
        await page.waitForSelector('.cut output');
        await caughtUp(page);
        await person.click(person.button('Lay a grid'));
        // The desk's corners by what the plan shows: x 1.40 to 3.20, y 3.62 to 4.36.
        await person.point(...(await planAt(page, 2.0, 3.67)));
        await page.waitForTimeout(500);
        await person.point(...(await planAt(page, 2.85, 3.97)));
        await page.waitForSelector('.inspector [aria-label="Corner Z"]');
        // Over what stands on it.
        await person.type(page.getByLabel('Corner Z'), '+=0.15');
        await measured('');
        // The lamp of the desk would spot it; the panel above lights all of it. A person aims comfortably above.
        for (let k = 0; k < 4; k++) {
            const { mean, text } = await area();
            if (mean >= 545) break;
            const panel = person.fader('panel_desk').getByLabel(/level, typed/);
            const level = numberOf(await panel.inputValue());
            await person.type(panel, String(Math.ceil((level * 560) / mean)));
            await measured(text);
        }
        await until(() => /[✓✗]/.test(document.querySelector('.readings .reading').innerText));
    });
    const { mean: lux, uniformity, verdict, text } = await area();
    t.diagnostic(text.replace(/\s+/g, ' '));
    assert.ok(verdict === '✓' && lux >= 500 && uniformity >= 0.6, text);
});

test('show before and after', { skip }, async (t) => {
    await page.keyboard.press('Escape');
    await task(t, async (person) => person.click(person.button('Inside')));
    const before = mean(await colorOf(page, [0, 0, 1, 1]));
    await task(t, async (person) => {
        const row = person.fader('panel_door');
        await person.slide(row.locator('input.level'), 1, 0.3);
        await person.click(person.button('Compare'));
        await page.waitForSelector('canvas.before');
        const line = await page.locator('.wipe').boundingBox();
        const view = await page.locator('#view').boundingBox();
        await person.drag([line.x + line.width / 2, line.y + line.height / 2], [view.x + 0.7 * view.width, line.y + line.height / 2]);
    });
    assert.equal(await page.locator('.wipe').getAttribute('aria-valuenow'), '70');
    assert.match(await page.locator('canvas.before').evaluate((canvas) => canvas.style.clipPath), /inset\(0px 30/);
    const [kept, now] = [mean(await colorOf(page, [0, 0, 1, 1], 'canvas.before')), mean(await colorOf(page, [0, 0, 1, 1]))];
    assert.ok(Math.abs(kept - before) < 0.02 * before, `before it was ${before}, and ${kept} is shown`);
    assert.ok(now < 0.95 * before, `after it is ${now}`);
    await page.keyboard.press('Escape');
    await page.waitForSelector('canvas.before', { state: 'detached' });
    // Held, it shows all of what was.
    await page.locator('#view').focus();
    await page.keyboard.down('\\');
    await page.waitForSelector('canvas.before');
    assert.equal(await page.locator('canvas.before').evaluate((canvas) => canvas.style.clipPath), 'none');
    await page.keyboard.up('\\');
    await page.waitForSelector('canvas.before', { state: 'detached' });
});

test('nothing was complained of', { skip }, () => assert.deepEqual(desk.complaints, []));
