// A person at the desk: opens it on a copy of a scene, acts by mouse and keys alone, and has every gesture counted.

import { cp, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, dirname, join, resolve } from 'node:path';
import { caughtUp, openBrowser, openPage, root, startProgram, waitState } from './desk.mjs';

/** A copy of a scene, so that what is saved beside it is gone with the copy. */
export async function copyOf(scene) {
    const folder = await mkdtemp(join(tmpdir(), 'lampyris-'));
    await cp(resolve(root, dirname(scene)), folder, { recursive: true, filter: (from) => !from.endsWith('.lampyris.json') });
    return { file: join(folder, basename(scene)), remove: () => rm(folder, { recursive: true }) };
}

/** A desk on a copy of a scene. */
export async function sitDown(scene, { width = 1440, height = 900, theme = 'dark', more = [] } = {}) {
    const { file, remove } = await copyOf(scene);
    const program = startProgram(file, '--quiet', ...more);
    const browser = await openBrowser();
    const { page, complaints } = await openPage(browser, { width, height, theme });
    // PAGE: a folder whose page is tried without being built into the program.
    if (process.env.PAGE) await page.route(/\.(js|css|svg)$/, (route) => route.fulfill({ path: join(process.env.PAGE, basename(new URL(route.request().url()).pathname)) }));
    await page.goto(await program.link);
    await waitState(page, 'refining', 'good', 'done');
    await page.waitForSelector('.view-strip');
    const stand = async () => {
        await browser.close();
        await program.end();
        await remove();
    };
    return { page, complaints, file, person: new Person(page), pid: program.pid, stand };
}

/** Acts as people do, and counts. */
export class Person {
    constructor(page) {
        this.page = page;
        this.gestures = { clicks: 0, drags: 0, fields: 0, keys: 0 };
    }

    async click(target, how = {}) {
        this.gestures.clicks++;
        await target.click(how);
    }

    /** Clicks the picture at shares of its width and height. */
    async point(x, y) {
        this.gestures.clicks++;
        const box = await this.page.locator('#view').boundingBox();
        await this.page.mouse.click(box.x + box.width * x, box.y + box.height * y);
    }

    async drag(from, to, steps = 24) {
        this.gestures.drags++;
        await this.page.mouse.move(...from);
        await this.page.mouse.down();
        await this.page.mouse.move(...to, { steps });
        await this.page.mouse.up();
    }

    /** Drags a fader to a share of its travel. */
    async slide(range, from, to) {
        const box = await range.boundingBox();
        const at = (share) => [box.x + 8 + (box.width - 16) * share, box.y + box.height / 2];
        await this.drag(at(from), at(to));
    }

    async type(field, text) {
        this.gestures.fields++;
        await field.fill(text);
        await this.page.keyboard.press('Enter');
    }

    /** A key of the view. */
    async press(key) {
        this.gestures.keys++;
        await this.page.locator('#view').focus();
        await this.page.keyboard.press(key);
    }

    fader(lamp) {
        return this.page.locator('.fader-row', { has: this.page.getByRole('button', { name: `${lamp} on`, exact: true }) });
    }

    button(name) {
        return this.page.getByRole('button', { name, exact: typeof name === 'string' });
    }

    /** What the gestures were, in words. */
    counted() {
        return Object.entries(this.gestures).filter(([, n]) => n).map(([what, n]) => `${n} ${n === 1 ? what.slice(0, -1) : what}`).join(', ');
    }
}

/** The mean colour of a part of a canvas, given in shares: [red, green, blue], 0 to 255. */
export const colorOf = (page, [x, y, width, height], canvas = '.stage canvas') => page.evaluate(([rect, selector]) => {
    const c = document.querySelector(selector);
    const [left, top, w, h] = rect.map((share, k) => Math.round(share * (k % 2 ? c.height : c.width)));
    const { data } = c.getContext('2d').getImageData(left, top, Math.max(1, w), Math.max(1, h));
    const sum = [0, 0, 0];
    for (let k = 0; k < data.length; k++) if (k % 4 < 3) sum[k % 4] += data[k];
    return sum.map((s) => s / (data.length / 4));
}, [[x, y, width, height], canvas]);

export const mean = (color) => (color[0] + color[1] + color[2]) / 3;

/** Where a point of the office's plan lies in the view, in shares: by what a person sees, the room's outline. */
export async function planAt(page, x, y) {
    // The plan is there when the picture's margin is black.
    await page.waitForFunction(() => {
        const { width, height } = document.querySelector('.stage canvas');
        const { data } = document.querySelector('.stage canvas').getContext('2d').getImageData(0, 0, 2, height);
        return width > 0 && data.every((v, k) => k % 4 === 3 || v < 8);
    }, undefined, { timeout: 60_000 });
    return page.evaluate(([px, py]) => {
        const canvas = document.querySelector('.stage canvas');
        const { width, height } = canvas;
        const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
        const lit = (k) => data[4 * k] + data[4 * k + 1] + data[4 * k + 2] > 24;
        let [left, right] = [width, 0];
        for (let k = 0; k < width * height; k++) if (lit(k)) [left, right] = [Math.min(left, k % width), Math.max(right, k % width)];
        // The room is 6 m wide, seen straight from above; its box, window and all, is in the middle.
        const scale = (right + 1 - left) / 6.0;
        return [((left + right + 1) / 2 + (px - 3) * scale) / width, (height / 2 - (py - 2.36) * scale) / height];
    }, [x, y]);
}

/** Waits until the picture holds all that was said, rests, and has some batches. */
export async function rested(page, batches = 4) {
    await caughtUp(page);
    // Figures of the line at the bottom come a few times a second.
    await page.waitForTimeout(700);
    await page.waitForFunction((least) => {
        const told = /(\d+) batches/.exec(document.querySelector('footer.status').innerText);
        return document.querySelector('.quality:is(.refining, .good, .done)') && told && Number(told[1]) >= least;
    }, batches, { timeout: 120_000 });
}
