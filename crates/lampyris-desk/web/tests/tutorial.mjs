// The tutorial of docs/desk.md, done by hand in a real browser, and its pictures: npm run pictures. ($LAMPYRIS names the
// program.) What a step leads to is checked, so that the tutorial stays true; the pictures still have to be looked at.

import assert from 'node:assert/strict';
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { LAMPYRIS, root, waitState } from './desk.mjs';
import { colorOf, mean, planAt, rested, sitDown } from './person.mjs';
import { small } from './png.mjs';

if (!LAMPYRIS) {
    console.error('LAMPYRIS names no program');
    process.exit(2);
}
const SIZE = { width: 1280, height: 760 };
/** No picture is larger [bytes]. */
const MOST = 240_000;
/** Batches behind what is photographed. */
const BATCHES = Number(process.env.BATCHES ?? 48);
const images = join(root, 'docs', 'images');

const desk = await sitDown('scenes/office.mgf', SIZE);
const { page, person } = desk;
await mkdir(images, { recursive: true });

/** What the page shows, as docs/images/desk-NAME.png. */
async function photograph(name, { batches = BATCHES } = {}) {
    await rested(page, batches);
    await page.mouse.move(4, SIZE.height - 4);
    const shot = await page.screenshot();
    const pixels = await page.evaluate(async (base64) => {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        const picture = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const canvas = new OffscreenCanvas(picture.width, picture.height);
        const context = canvas.getContext('2d');
        context.drawImage(picture, 0, 0);
        const { data } = context.getImageData(0, 0, picture.width, picture.height);
        let text = '';
        for (let k = 0; k < data.length; k += 32768) text += String.fromCharCode(...data.subarray(k, k + 32768));
        return { width: picture.width, height: picture.height, base64: btoa(text) };
    }, shot.toString('base64'));
    const file = small({ ...pixels, data: Buffer.from(pixels.base64, 'base64') }, MOST);
    assert.ok(file.length <= MOST, `${name}: ${file.length} bytes`);
    await writeFile(join(images, `desk-${name}.png`), file);
    console.log(`desk-${name}.png: ${Math.round(file.length / 1000)} kB`);
}

const room = async () => mean(await colorOf(page, [0, 0, 1, 1]));
const undo = () => page.locator('.bar button[aria-label^="Undo"]').getAttribute('aria-label');
const step = (text) => page.waitForFunction((wanted) => document.querySelector('.bar button[aria-label^="Undo"]').getAttribute('aria-label').includes(wanted), text);
const power = (lamp) => person.button(`${lamp} on`);
const level = (lamp) => person.fader(lamp).getByLabel(/level, typed/);

// 1. The room as its file has it.
await person.click(person.fader('lamp_torchiere/disc').locator('.row-name'));
await photograph('open');
const open = await room();

// 2. Dark.
await person.press('Control+a');
await person.press('o');
await waitState(page, 'all-off');
await page.keyboard.press('Escape');
assert.match(await undo(), /10 lamps off/);
await rested(page, 1);
assert.ok((await room()) < 0.05 * open);

// 3. Lamp by lamp: uplighter, shelf, pendant, what is outside.
for (const lamp of ['window/sky_dusk', 'window/town/town_windows', 'lamp_torchiere/disc', 'bookshelf/led_strip', 'lamp_pendant/globe']) {
    await person.click(power(lamp));
}
await person.slide(person.fader('lamp_torchiere/disc').locator('input.level'), 1, 0.7);
await step('lamp_torchiere/disc 100 → ');
await person.type(level('lamp_pendant/globe'), '-1 stop');
await step('lamp_pendant/globe 100 → 50 %');
await person.click(person.button('Meter once'));
await rested(page, 4);

// 4. Warm white for what lights the room.
await person.click(person.fader('lamp_torchiere/disc').locator('.row-name'));
await person.click(person.fader('bookshelf/led_strip').locator('.row-name'), { modifiers: ['Control'] });
await person.click(person.button('White'));
await person.click(person.button('2700 kelvin, warm'));
await step('2 lamps: 2700 K');
await page.keyboard.press('Escape');

// 5. A spot over the table, aimed at what stands there.
await person.click(person.button('Add a lamp'));
await person.click(page.getByRole('button', { name: /Add a spot lamp by pointing/ }));
await person.point(0.655, 0.617);
await page.waitForSelector('.inspector .tools');
await person.click(page.locator('.inspector').getByRole('button', { name: 'Aim', exact: true }));
await person.point(0.67, 0.615);
await step('Aim Spot 1');
await person.type(page.getByLabel('Level of the selection'), '250 lm');
await step('Spot 1 100 → 31 %');
await person.click(person.button('White'));
await person.click(person.button('2700 kelvin, warm'));
await photograph('aim');
await page.keyboard.press('Escape');

// 6. The desk: an area in the plan, what it receives of the panel above, and how much that must give.
await person.click(power('panel_desk'));
await person.click(person.button('Plan'));
await page.waitForSelector('.cut output');
await person.click(person.button('Lay a grid'));
await person.point(...(await planAt(page, 2.0, 3.67)));
await page.waitForTimeout(800);
await person.point(...(await planAt(page, 2.85, 3.97)));
await page.waitForSelector('.inspector [aria-label="Corner Z"]');
await person.type(page.getByLabel('Corner Z'), '+=0.15');
/** The figures of the area, when they are others, no longer grey, and decided against the target. */
async function area(before = '') {
    await page.waitForFunction((old) => {
        if (document.querySelector('.readings .reading')?.innerText.replace(/\s+/g, ' ') === old) return false;
        const told = /Ē ([\d.]+) lx ±([\d.]+)/.exec(document.querySelector('.readings .reading')?.innerText);
        return told && Number(told[2]) < 0.05 * Number(told[1]) && /[✓✗]/.test(document.querySelector('.readings .reading').innerText);
    }, before, { timeout: 300_000 });
    return (await page.locator('.readings .reading').innerText()).replace(/\s+/g, ' ');
}
const short = await area();
console.log('3600 lm:', short);
await person.type(level('panel_desk'), '7000 lm');
await step('panel_desk 100 → 194 %');
const enough = await area(short);
console.log('7000 lm:', enough);
assert.match(enough, /✓/);
await person.click(person.button('Meter once'));
await photograph('area');

// 7. False colour, from inside.
await person.click(person.button('Inside'));
await person.click(person.button('False colour'));
await page.waitForSelector('.legend');
await photograph('lux');
await person.click(person.button('False colour'));

// 8. Looks, and before and after.
await person.click(person.button('Store a look'));
await page.waitForSelector('.look');
await person.click(power('panel_desk'));
await person.click(power('lamp_desk/bulb'));
await person.click(person.button('Store a look'));
await page.waitForFunction(() => document.querySelectorAll('.look').length === 2);
await person.click(page.locator('.look .recall').first());
await page.waitForTimeout(2500);
await rested(page, BATCHES);
await person.click(page.locator('.look .recall').nth(1));
await page.waitForTimeout(2500);
await person.click(person.button('Compare'));
await page.waitForSelector('canvas.before');
await photograph('done');
await page.keyboard.press('Escape');
console.log(await page.locator('.bar h1').getAttribute('title'), person.counted());
assert.deepEqual(desk.complaints, []);
await desk.stand();
