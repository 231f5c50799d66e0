// What the tests of the page in a browser share: the program, the browser, and how to wait for what was asked for.

import { spawn } from 'node:child_process';
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, '..', '..', '..', '..');
const dist = join(here, '..', 'dist');

/** The program that tests start; without it they are left out. */
export const LAMPYRIS = process.env.LAMPYRIS;

export const openBrowser = () => chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--headless=new', '--no-sandbox', '--disable-gpu', '--force-color-profile=srgb'],
});

/** A port that is free now. */
export async function freePort() {
    const server = createServer();
    await new Promise((done) => server.listen(0, '127.0.0.1', done));
    const { port } = server.address();
    await new Promise((done) => server.close(done));
    return port;
}

/** Starts `lampyris view` and returns its link and how to end it. */
export function startProgram(scene, ...more) {
    const child = spawn(LAMPYRIS, ['view', scene, '--no-open', ...(more.includes('--port') ? [] : ['--port', '0']), ...more], {
        cwd: root, stdio: ['ignore', 'pipe', 'pipe'],
    });
    let said = '';
    const link = new Promise((found, failed) => {
        const read = (data) => {
            said += data;
            const address = /http:\/\/127\.0\.0\.1:\d+\/#[\w-]+/.exec(said);
            if (address) found(address[0]);
        };
        child.stdout.on('data', read);
        child.stderr.on('data', read);
        child.on('exit', () => failed(new Error(`the program ended: ${said}`)));
    });
    link.catch(() => {});
    const gone = new Promise((done) => child.on('exit', done));
    return { link, pid: child.pid, end: (signal = 'SIGTERM') => (child.kill(signal), gone) };
}

/** A page that must not complain: errors of the console and of the policy are gathered. */
export async function openPage(browser, { width = 1280, height = 720, touch = false, theme = 'dark', scale = 1 } = {}) {
    const context = await browser.newContext({ viewport: { width, height }, hasTouch: touch, deviceScaleFactor: scale });
    const page = await context.newPage();
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('console', (message) => {
        // A line that is refused while the program is away is told there too.
        if (message.type() === 'error' && !/ERR_CONNECTION_REFUSED|WebSocket connection|status of (401|403|502)/.test(message.text())) {
            complaints.push(message.text());
        }
    });
    await page.addInitScript((name) => {
        localStorage.setItem('lampyris-theme', JSON.stringify(name));
        document.addEventListener('securitypolicyviolation', (event) => console.error(`policy: ${event.violatedDirective} ${event.blockedURI}`));
    }, theme);
    return { page, complaints };
}

export const stateOf = (page) => page.evaluate(() => document.getElementById('desk').dataset.state);

export const waitState = (page, ...states) =>
    page.waitForFunction((wanted) => wanted.includes(document.getElementById('desk')?.dataset.state), states, { timeout: 60_000 });

/** Waits for a picture that contains all that the page has said until now. */
export const caughtUp = (page) => page.waitForFunction(() => {
    const { sent, seqApplied } = window.__desk;
    const last = sent.findLast((message) => message.what !== 'ask');
    return last && seqApplied >= last.seq;
}, undefined, { timeout: 60_000 });

/** The mean of the picture, 0 to 255. */
export const brightness = (page) => page.evaluate(() => {
    const canvas = document.querySelector('.stage canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0;
    for (let k = 0; k < data.length; k += 4) sum += data[k] + data[k + 1] + data[k + 2];
    return sum / (data.length * 0.75);
});

const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };
const POLICY = "default-src 'self'; img-src 'self' blob:; style-src 'self'; frame-ancestors 'none'; connect-src 'self'";

/** Serves the page alone, for tests that speak for the program themselves. */
export async function servePage() {
    const server = createServer(async (request, response) => {
        const { pathname } = new URL(request.url, 'http://127.0.0.1');
        const name = pathname === '/' ? '/index.html' : pathname;
        if (request.method === 'POST') return response.writeHead(204).end();
        try {
            const bytes = await readFile(join(dist, name));
            response.writeHead(200, { 'content-type': TYPES[extname(name)] ?? 'text/plain', 'content-security-policy': POLICY }).end(bytes);
        } catch {
            response.writeHead(404).end();
        }
    });
    await new Promise((done) => server.listen(0, '127.0.0.1', done));
    return { link: `http://127.0.0.1:${server.address().port}/#key`, end: () => new Promise((done) => (server.closeAllConnections(), server.close(done))) };
}
