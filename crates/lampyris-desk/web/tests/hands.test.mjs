// The same by other hands: keys alone, fingers alone, other keyboards, a trackpad, a Mac.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openPage, servePage } from './desk.mjs';
import { frame, speakFor, state } from './fake.mjs';

let browser;
let server;
before(async () => ([browser, server] = await Promise.all([openBrowser(), servePage()])));
after(async () => {
    await browser.close();
    await server.end();
});

async function desk(options) {
    const { page, complaints } = await openPage(browser, options);
    const spoken = await speakFor(page, state());
    await page.goto(server.link);
    await page.waitForFunction(() => window.__desk?.frame > 0 && document.querySelector('.view-strip') && document.querySelector('.inspector *'));
    const heard = (what) => spoken.heard.filter((message) => message.do === what);
    const until = async (test, why) => {
        for (let k = 0; k < 100; k++) {
            if (await test()) return;
            await page.waitForTimeout(30);
        }
        assert.fail(why);
    };
    const say = (message) => spoken.lines.at(-1).send(JSON.stringify(message));
    return { page, complaints, heard, until, say };
}

test('where the second file did not come, the next picture asks for it again', async () => {
    const { page } = await openPage(browser);
    const tried = [];
    await page.route(/gizmo\.js/, (route) => (tried.push(route.request().url()), tried.length === 1 ? route.abort() : route.continue()));
    const spoken = await speakFor(page, state());
    await page.goto(server.link);
    await page.waitForFunction(() => window.__desk?.frame > 0);
    for (let k = 0; k < 100 && !(await page.locator('.view-strip').count()); k++) {
        spoken.lines[0].send(frame({ number: k + 2 }));
        await page.waitForTimeout(50);
    }
    await page.waitForSelector('.view-strip');
    assert.ok(tried.length > 1);
    await page.context().close();
});

test('keys alone: find a lamp, set its level, switch it, solo it, undo, and leave', async () => {
    const { page, heard, until, complaints } = await desk();
    await page.keyboard.press('Control+k');
    await page.keyboard.type('lamp 7');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('.inspector .name-field input')?.value === 'Lamp 7');
    await page.locator('#view').focus();
    await page.keyboard.press('4');
    await page.waitForFunction(() => document.activeElement?.id === 'level');
    await page.keyboard.type('0');
    await page.keyboard.press('Enter');
    await until(() => heard('set').some((m) => m.patch.lamps?.[7]?.level === 0.4), 'the level was not set');
    assert.match(heard('begin')[0].label, /Lamp 7 80 → 40 %/);
    await page.locator('#view').focus();
    await page.keyboard.press('o');
    await until(() => heard('set').some((m) => m.patch.lamps?.[7]?.on === false), 'it was not switched');
    await page.keyboard.press('i');
    await until(() => heard('solo').some((m) => m.lamps.includes(7)), 'no solo');
    await page.keyboard.press('Control+z');
    await until(() => heard('undo').length === 1, 'no undo');
    const fader = page.locator('[data-row="lamp-7"] input.level');
    await fader.focus();
    const before = heard('set').length;
    for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowDown');
    await until(() => heard('set').length > before, 'the fader does not listen to keys');
    await page.waitForTimeout(800);
    assert.equal(heard('begin').length, heard('end').length, 'every step is ended');
    await page.locator('#view').focus();
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    assert.notEqual(await page.evaluate(() => document.activeElement?.id), 'view');
    assert.deepEqual(complaints, []);
    await page.context().close();
});

test('groups: made of those selected, named, dimmed by a master, left, and dissolved', async () => {
    const { page, heard, until, complaints, say } = await desk({ width: 1440, height: 2400 });
    await page.locator('[data-row="lamp-1"] .row-name').click();
    await page.locator('[data-row="lamp-4"] .row-name').click({ modifiers: ['Control'] });
    await page.locator('#view').focus();
    await page.keyboard.press('Control+g');
    await until(() => heard('group').length === 1, 'no group');
    assert.deepEqual(heard('group')[0].lamps, [1, 4]);
    assert.equal(heard('group')[0].name, 'Group 1');
    assert.match(heard('begin').at(-1).label, /^Group 2 lamps/);
    const rowB = { ...state().groups[1], lamps: state().groups[1].lamps.filter((id) => id !== 1 && id !== 4) };
    const members = { 1: { ...state().lamps[1], group: 3 }, 4: { ...state().lamps[4], group: 3 } };
    say({ is: 'patch', seq: heard('end').at(-1).seq, by: 1, patch: { lamps: members, groups: { 1: rowB, 3: { name: 'Group 1', on: true, level: 1, lamps: [1, 4] } } } });
    // It is selected, and called as one types.
    await page.waitForSelector('[aria-label="Name of the group"]');
    await page.getByLabel('Name of the group').fill('Evening');
    await page.keyboard.press('Enter');
    await until(() => heard('set').some((m) => m.patch.groups?.[3]?.name === 'Evening'), 'not renamed');
    await page.getByLabel('Master of the group').fill('40');
    await page.keyboard.press('Enter');
    await until(() => heard('set').some((m) => m.patch.groups?.[3]?.level === 0.4), 'no master');
    await page.locator('[data-row="lamp-4"] .row-name').click();
    await page.locator('.inspector').getByRole('button', { name: 'Take out' }).click();
    await until(() => heard('group').length === 2, 'not taken out');
    assert.deepEqual([heard('group')[1].lamps, heard('group')[1].name], [[4], undefined]);
    await page.locator('[data-row="group-3"] .row-name').click();
    await page.locator('#view').focus();
    await page.keyboard.press('Control+Shift+g');
    await until(() => heard('group').length === 3, 'not dissolved');
    assert.deepEqual(heard('group')[2].lamps, [1, 4]);
    assert.match(heard('begin').at(-1).label, /^Dissolve/);
    assert.equal(heard('begin').length, heard('end').length, 'every step is ended');
    assert.deepEqual(complaints, []);
    await page.context().close();
});

test('G and R, an axis, digits: what is typed is done at once, Enter keeps it, Escape takes it back', async () => {
    const { page, heard, until, complaints } = await desk();
    await page.locator('[data-row="lamp-3"] .row-name').click();
    await page.waitForSelector('[data-handle="move-z"]', { state: 'attached' });
    await page.locator('#view').focus();
    const hint = () => page.locator('.hint').innerText();
    const place = () => heard('set').at(-1)?.patch.lamps?.[3].place;
    const from = state().lamps[3].place.position;
    for (const key of ['g', 'z', '-', '0', '.', '5']) await page.keyboard.press(key);
    assert.match(await hint(), /Move along Z: -0\.5 m/);
    await until(() => Math.abs(place()?.position[2] - (from[2] - 0.5)) < 1e-9, 'not moved down');
    // Another axis takes the number along; what was moved before comes back.
    await page.keyboard.press('x');
    await until(() => Math.abs(place().position[0] - (from[0] - 0.5)) < 1e-9 && Math.abs(place().position[2] - from[2]) < 1e-9, 'not moved along X instead');
    assert.equal(heard('end').length, 0);
    await page.keyboard.press('Enter');
    await until(() => heard('end').length === 1, 'not kept');
    assert.match(heard('begin')[0].label, /Move Lamp 3/);
    await page.waitForSelector('.hint', { state: 'detached' });
    for (const key of ['r', 'y', '9', '0', '0', 'Backspace']) await page.keyboard.press(key);
    assert.match(await hint(), /Turn about Y: 90°/);
    await until(() => Math.abs(Math.abs(place().direction?.[0]) - 1) < 1e-9, 'not turned');
    await page.keyboard.press('Escape');
    await until(() => heard('cancel').length === 1, 'not taken back');
    // What is selected stays so, and without an axis digits are a level.
    assert.equal(await page.locator('[data-row="lamp-3"] .row-name').getAttribute('aria-pressed'), 'true');
    for (const key of ['g', '4']) await page.keyboard.press(key);
    await page.waitForFunction(() => document.activeElement?.id === 'level');
    assert.deepEqual(complaints, []);
    await page.context().close();
});

test('Tab reaches every control that is seen, and focus is never lost', async () => {
    const { page } = await desk();
    const seen = new Set();
    await page.evaluate(() => document.body.focus());
    for (let k = 0; k < 200; k++) {
        await page.keyboard.press('Tab');
        const what = await page.evaluate(() => {
            const e = document.activeElement;
            if (!e || e === document.body) return null;
            const box = e.getBoundingClientRect();
            return { name: e.getAttribute('aria-label') ?? e.textContent, shown: box.width > 0 && box.bottom > 0 && box.top < innerHeight };
        });
        if (!what) continue;
        assert.ok(what.shown, `${what.name} has the focus and is not seen`);
        seen.add(what.name);
    }
    for (const name of ['Lamp 0 level', 'False colour', 'Home', 'Store a look', 'Filter lamps']) assert.ok(seen.has(name), `${name} is not reached`);
    await page.context().close();
});

test('walking keys are places, letters are letters: AZERTY and QWERTZ', async () => {
    const { page, heard, until } = await desk();
    const press = (key, code) => page.evaluate(async ([k, c]) => {
        const view = document.getElementById('view');
        view.focus();
        view.dispatchEvent(new KeyboardEvent('keydown', { key: k, code: c, bubbles: true, cancelable: true }));
        await new Promise((done) => setTimeout(done, 120));
        view.dispatchEvent(new KeyboardEvent('keyup', { key: k, code: c, bubbles: true }));
    }, [key, code]);
    await press('z', 'KeyW');
    await until(() => heard('camera').length > 0, 'Z of AZERTY does not walk');
    const ahead = heard('camera').at(-1);
    assert.ok(ahead.eye[0] > 0.6 && Math.abs(ahead.eye[2] - 1.6) < 1e-9, 'ahead, on the level');
    const before = heard('camera').length;
    await press('q', 'KeyA');
    await until(() => heard('camera').length > before, 'Q of AZERTY does not step aside');
    // Frames the selection: the letter F wherever it is.
    const there = heard('camera').length;
    await page.locator('[data-row="lamp-0"] .row-name').click();
    await press('f', 'KeyX');
    await until(() => heard('camera').length > there, 'F does not frame');
    await page.context().close();
});

test('a trackpad pinches, wheels count lines or pages, a Mac has its own key', async () => {
    const { page, heard, until } = await desk();
    const wheel = (options) => page.evaluate((o) => {
        const view = document.getElementById('view');
        const box = view.getBoundingClientRect();
        view.dispatchEvent(new WheelEvent('wheel', { bubbles: true, cancelable: true, clientX: box.x + box.width / 2, clientY: box.y + box.height / 2, ...o }));
    }, options);
    const moved = async (options, nearer) => {
        const before = heard('camera').length;
        await wheel(options);
        await until(() => heard('camera').length > before, JSON.stringify(options));
        const [a, b] = [heard('camera').at(-2) ?? { eye: [0.6, 0.6, 1.6] }, heard('camera').at(-1)];
        const far = (p) => Math.hypot(p[0] - 4, p[1] - 3, p[2] - 0.75);
        assert.equal(far(b.eye) < far(a.eye), nearer, JSON.stringify(options));
    };
    await moved({ deltaY: -120 }, true);
    await moved({ deltaY: 3, deltaMode: 1 }, false);
    await moved({ deltaY: -1, deltaMode: 2 }, true);
    await moved({ deltaY: 8, ctrlKey: true }, false);
    await page.locator('#view').focus();
    await page.keyboard.press('Meta+z');
    await until(() => heard('undo').length === 1, 'Cmd+Z');
    await page.context().close();
});

async function touch(page, steps) {
    const client = await page.context().newCDPSession(page);
    for (const [type, points] of steps) {
        await client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
        await page.waitForTimeout(30);
    }
}

test('fingers: one looks, two pan and pinch, the lock keeps everything as it is, two faders are one step', async () => {
    const { page, heard, until } = await desk({ width: 1180, height: 820, touch: true });
    await page.evaluate(() => localStorage.setItem('lampyris-look-only', 'true'));
    await page.reload();
    await page.waitForFunction(() => window.__desk?.frame > 0 && document.querySelector('.view-strip'));
    const view = await page.locator('#view').boundingBox();
    const at = (x, y) => [view.x + view.width * x, view.y + view.height * y];
    const cameras = () => heard('camera').length;
    let before = cameras();
    await touch(page, [['touchStart', [at(0.5, 0.4)]], ['touchMove', [at(0.55, 0.42)]], ['touchMove', [at(0.6, 0.44)]], ['touchEnd', []]]);
    await until(() => cameras() > before, 'one finger does not look');
    before = cameras();
    await touch(page, [['touchStart', [at(0.45, 0.5), at(0.55, 0.5)]], ['touchMove', [at(0.42, 0.5), at(0.58, 0.5)]], ['touchMove', [at(0.38, 0.5), at(0.62, 0.5)]], ['touchEnd', []]]);
    await until(() => cameras() > before, 'two fingers do not pinch');
    // The lock: faders are shut, a tap selects nothing.
    assert.ok(await page.locator('.fader-row input.level').first().isDisabled());
    await touch(page, [['touchStart', [at(0.5, 0.5)]], ['touchEnd', []]]);
    await page.waitForTimeout(200);
    assert.equal(heard('set').length, 0);
    await page.locator('.look-lock').tap();
    await until(async () => !(await page.locator('.fader-row input.level').first().isDisabled()), 'the lock does not open');
    const [a, b] = await Promise.all([0, 1].map((k) => page.locator('.fader-row input.level').nth(k).boundingBox()));
    const on = (box, t) => [box.x + box.width * t, box.y + box.height / 2];
    await touch(page, [
        ['touchStart', [on(a, 0.8), on(b, 0.8)]], ['touchMove', [on(a, 0.7), on(b, 0.6)]], ['touchMove', [on(a, 0.6), on(b, 0.4)]],
        ['touchMove', [on(a, 0.5), on(b, 0.3)]], ['touchEnd', []],
    ]);
    await until(() => heard('end').length >= 1, 'nothing was ended');
    await page.waitForTimeout(300);
    assert.equal(heard('begin').length, 1);
    const touched = new Set(heard('set').flatMap((m) => [...Object.keys(m.patch.groups ?? {}).map((id) => `g${id}`), ...Object.keys(m.patch.lamps ?? {})]));
    assert.ok(touched.size >= 2, `two faders moved: ${[...touched]}`);
    await page.context().close();
});

test('without secure-context interfaces and with reduced motion it works all the same', async () => {
    const { page, complaints } = await desk();
    await page.emulateMedia({ reducedMotion: 'reduce', forcedColors: 'active' });
    assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector('.layers .dot, .dot')).animationName), 'none');
    assert.deepEqual(complaints, []);
    await page.context().close();
});
