// Looks on the page: their thumbnails, the difference to one of them, and how high levels may go for targets.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openPage, servePage, waitState } from './desk.mjs';
import { frame, speakFor, state } from './fake.mjs';

let browser;
let served;
let page;
let complaints;
let talk;
before(async () => {
    served = await servePage();
    browser = await openBrowser();
    ({ page, complaints } = await openPage(browser, { width: 1600, height: 900 }));
    const told = state();
    told.looks[0].picture = '/look/1';
    told.meters[0].change = 120;
    told.grids[0].change = -35;
    await page.route('**/look/1', (route) => route.fulfill({ contentType: 'image/png', body: frame({ width: 96, height: 72 }).subarray(32) }));
    talk = await speakFor(page, told);
    await page.goto(served.link);
    await waitState(page, 'good');
    await page.waitForSelector('.look');
});
after(async () => {
    await browser?.close();
    await served?.end();
});

const heard = (what) => talk.heard.filter((message) => message.do === what);
const last = (what) => heard(what).at(-1);
const until = async (done, why) => {
    for (let k = 0; k < 100 && !done(); k++) await page.waitForTimeout(30);
    assert.ok(done(), why);
};

test('a look has its thumbnail, called by its name once', async () => {
    const image = page.locator('.look img');
    assert.equal(await image.count(), 1);
    assert.equal(await image.getAttribute('alt'), 'as built');
    await page.waitForFunction(() => document.querySelector('.look img').naturalWidth === 96);
    assert.equal(await page.getByRole('button', { name: 'as built', exact: true }).count(), 1);
    assert.equal(await page.getByRole('button', { name: 'evening', exact: true }).count(), 1);
});

test('the difference to a look is asked for, has a legend with signs about zero, and ends', async () => {
    await page.getByRole('button', { name: 'More of evening' }).click();
    await page.getByRole('button', { name: 'Difference to now' }).click();
    await until(() => last('display')?.patch.false_color?.quantity === 'difference', 'it was not asked for');
    const asked = last('display').patch.false_color;
    assert.deepEqual([asked.against, asked.low, asked.high, asked.scale, asked.palette], [1, -500, 500, 'linear', 'diverging']);
    const legend = page.locator('.legend');
    assert.match(await legend.innerText(), /Δ lx[\s\S]*now − evening/);
    assert.equal(await legend.getByRole('button', { name: 'log' }).count(), 0);
    const marks = await legend.locator('.scale span').allInnerTexts();
    assert.ok(marks.includes('0') && marks.some((mark) => mark.startsWith('+')) && marks.some((mark) => mark.startsWith('−')), String(marks));

    // Either end takes the other along.
    await legend.getByRole('slider', { name: 'Upper end of the legend' }).press('ArrowUp');
    await until(() => last('display').patch.false_color.high === 1000, 'it did not grow');
    assert.equal(last('display').patch.false_color.low, -1000);
    await legend.getByRole('slider', { name: 'Lower end of the legend' }).press('ArrowUp');
    await until(() => last('display').patch.false_color.low === -500, 'it did not shrink');
    assert.equal(last('display').patch.false_color.high, 500);
    await legend.getByRole('button', { name: '±50', exact: true }).click();
    await until(() => last('display').patch.false_color.high === 50, 'it was not set');

    await page.getByRole('button', { name: 'More of evening' }).click();
    await page.getByRole('button', { name: 'End the difference' }).click();
    await until(() => last('display').patch.false_color === null, 'it did not end');
    await page.waitForSelector('.legend', { state: 'detached' });
});

test('the share that clamping takes is asked for by its name, in percent from 0 on', async () => {
    await page.keyboard.press('Control+k');
    await page.keyboard.type('clamping');
    await page.keyboard.press('Enter');
    await until(() => last('display')?.patch.false_color?.quantity === 'clamped', 'it was not asked for');
    const legend = page.locator('.legend');
    await legend.getByText('clamped').waitFor();
    assert.equal(await legend.getByRole('slider').count(), 1);
    await legend.getByRole('button', { name: '0–10', exact: true }).click();
    await until(() => last('display').patch.false_color.high === 10, 'it was not set');
    assert.equal(last('display').patch.false_color.low, 0);
    await legend.getByRole('button', { name: '%: clamped, change' }).click();
    await until(() => last('display').patch.false_color.quantity === 'illuminance', 'it did not end');
    await page.getByRole('button', { name: 'False colour', exact: true }).click();
    await page.waitForSelector('.legend', { state: 'detached' });
});

test('meters and areas tell the change', async () => {
    assert.match(await page.locator('.reading', { hasText: 'Desk' }).innerText(), /Δ \+120 lx/);
    assert.match(await page.locator('.reading', { hasText: 'Area' }).innerText(), /Δ −35\.0 lx/);
});

test('targets may be reached above full, if that is said', async () => {
    const reach = page.getByRole('button', { name: 'Reach targets' });
    await reach.click();
    await until(() => last('reach')?.most === 1, 'it was not asked for');
    const field = page.getByRole('textbox', { name: 'Highest level to reach targets' });
    await field.fill('200 %');
    await field.press('Enter');
    await reach.click();
    await until(() => last('reach').most === 2, 'it went no higher');
    await field.fill('20 %');
    await field.press('Enter');
    await reach.click();
    await until(() => heard('reach').length === 3, 'it was not asked for');
    assert.equal(last('reach').most, 1);
});

test('nothing was complained of', () => assert.deepEqual(complaints, []));
