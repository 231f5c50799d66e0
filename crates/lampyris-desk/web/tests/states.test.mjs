// Every state of the page, in both themes, three sizes and at a zoom of 200 %: reached, named, said in words, and without a fault that axe finds.
// With SHOTS set to a folder each is photographed.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { mkdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { openBrowser, openPage, servePage, waitState } from './desk.mjs';
import { lamp, speakFor, state } from './fake.mjs';

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
/** Width, height, pixels of the screen for one of the page: the last is the first at twice its size. */
const SIZES = [[1440, 900, 1], [1180, 820, 1], [820, 1180, 1], [720, 450, 2]];
const SHOTS = process.env.SHOTS;

let browser;
let server;
before(async () => {
    [browser, server] = await Promise.all([openBrowser(), servePage()]);
    if (SHOTS) await mkdir(SHOTS, { recursive: true });
});
after(async () => {
    await browser.close();
    await server.end();
});

const off = state();
for (const id of Object.keys(off.lamps)) off.lamps[id] = lamp(Number(id), { on: false });

/** Name of the state, what the program says, what is done besides, words that must stand there. */
const STATES = [
    ['loading', { told: null, more: [{ is: 'event', what: 'loading', file: 'room.mgf', progress: 0.4, bytes: 12e6 }] }, /Reading room\.mgf/],
    ['good', {}, /good ±1\.2 %/],
    ['refining', { more: [{ is: 'status', stage: 'refining', error: 0.04, good_in: 2, fps: 8, batches: 9 }] }, /±4(\.0)? %, good in 2\.0 s/],
    ['moving', { more: [{ is: 'status', stage: 'moving', error: 0.2, fps: 3, batches: 1 }] }, /moving/],
    ['done', { more: [{ is: 'status', stage: 'done', error: 0.001, fps: 0, batches: 256 }] }, /finished/],
    ['no-lamps', { told: state({ lamps: 0 }) }, /This scene has no light/],
    ['all-off', { told: off }, /All lamps are off/],
    ['broken', { more: [{ is: 'event', what: 'broken', why: 'line 812: a number was expected' }] }, /line 812.*Still showing/s],
    ['unsaved', { told: state({ saved: { state: 'failed', file: null, why: 'the disk is full' } }) }, /not being saved: the disk is full/],
    ['watching', { told: state({ editor: { you: false, name: 'Anna' } }), role: 'watch' }, /You are watching; Anna edits/],
    ['control-lost', { told: state({ editor: { you: false, name: 'tablet' } }), more: [{ is: 'event', what: 'taken', by: 'tablet' }] }, /Control moved to tablet/],
    ['lost', { act: async (page, { lines }) => lines[0].close() }, /Connection lost, trying again/],
    ['ended', { more: [{ is: 'event', what: 'bye' }], act: async (page, { lines }) => lines[0].close() }, /program has ended.*lampyris view/s],
    ['renewed', { builds: ['one', 'two'], act: async (page, { lines }) => lines[0].close() }, /New version/],
    ['good', { select: 'lamp', act: (page) => page.locator('[data-row="lamp-3"] .row-name').click() }, /Handles/],
    ['good', { select: 'several', act: async (page) => {
        await page.locator('[data-row="lamp-0"] .row-name').click();
        await page.locator('[data-row="lamp-3"] .row-name').click({ modifiers: ['Shift'] });
    } }, /2 lamps/],
    ['good', { select: 'sheet', act: (page) => page.getByRole('button', { name: 'Sheet', exact: true }).click() }, /Lamp 3/],
    ['good', { select: 'what', act: (page) => page.locator('#view').click({ button: 'right' }) }, /what lights this/],
    ['good', { select: 'false', act: (page) => page.getByRole('button', { name: 'False colour' }).click(), told: state({ display: { ...state().display, false_color: null } }) }, /log/],
    ['good', { select: 'help', act: (page) => page.getByRole('button', { name: 'All keys' }).click() }, /Look around/],
    ['good', { select: 'palette', act: (page) => page.getByRole('button', { name: 'Command palette' }).click() }, /Frame the selection/],
    ['good', { select: 'share', act: (page) => page.keyboard.press('Control+k').then(() => page.keyboard.type('share')).then(() => page.keyboard.press('Enter')) }, /Revoke/],
    ['good', { select: 'grid', act: (page) => page.getByRole('button', { name: /Area/ }).first().click() }, /U₀ = min/],
];

for (const [name, how, words] of STATES) {
    const title = how.select ? `${name}: ${how.select}` : name;
    test(title, async () => {
        const wrong = new Set();
        for (const theme of ['dark', 'light']) {
            for (const [width, height, scale] of SIZES) {
                const { page, complaints } = await openPage(browser, { width, height, theme, scale });
                const builds = [...(how.builds ?? [])];
                const spoken = await speakFor(page, how.told === undefined ? state() : how.told && structuredClone(how.told), { role: how.role, build: () => (builds.length > 1 ? builds.shift() : builds[0] ?? 'b'), more: how.more });
                await page.goto(server.link);
                if (how.told !== null) await page.waitForFunction(() => window.__desk?.frame > 0 && document.querySelector('.view-strip'));
                // Narrow pages show one panel at a time.
                if (how.select === 'grid' && width < 1240) await page.getByRole('button', { name: 'Meters' }).first().click();
                await how.act?.(page, spoken);
                if (['lamp', 'several', 'grid'].includes(how.select) && width < 1240) await page.locator('.bar .narrow').click();
                await waitState(page, name);
                await page.waitForFunction((source) => new RegExp(source, 's').test(document.body.innerText), words.source);
                // As an element the page's policy would forbid it.
                await page.evaluate(axe);
                const found = await page.evaluate(() => window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'] }));
                const faults = found.violations.map((v) => `${v.id}: ${v.nodes.slice(0, 4).map((n) => `${n.target.join(' ')} (${n.any[0]?.message ?? n.all[0]?.message ?? ''})`).join(' | ')}`);
                if (SHOTS) await page.screenshot({ path: join(SHOTS, `${title.replace(/\W+/g, '-')}-${theme}-${width}.png`) });
                for (const fault of faults) wrong.add(fault);
                for (const text of complaints) wrong.add(text);
                await page.context().close();
            }
        }
        assert.deepEqual([...wrong], []);
    });
}
