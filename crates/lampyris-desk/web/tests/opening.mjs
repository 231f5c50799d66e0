// How long until there is something to see.
//
//   node tests/opening.mjs SCENE… [--runs 5] [--view 1280x720]
//
// Of each scene three kinds of runs, each with a program of its own ($LAMPYRIS) on a copy of the scene:
//
//   bytes   a client without a page: from the start of the process to the first byte of the first picture
//   start   a browser that is open goes to the link as soon as it is printed: from the start of the process
//   desk    a browser that is open goes to a desk that runs: from the navigation to the shell, the first picture, a good one
//
// Printed are medians, and in brackets the least and the most.

import { request } from 'node:http';
import { loadavg } from 'node:os';
import { openBrowser, startProgram } from './desk.mjs';
import { copyOf } from './person.mjs';

const given = process.argv.slice(2);
const option = (name, otherwise) => (given.includes(`--${name}`) ? given.splice(given.indexOf(`--${name}`), 2)[1] : otherwise);
const runs = Number(option('runs', 5));
const [width, height] = option('view', '1280x720').split('x').map(Number);
if (!given.length) {
    console.error('usage: node tests/opening.mjs SCENE… [--runs 5] [--view 1280x720]');
    process.exit(2);
}

const call = (link, options) => new Promise((done, failed) => {
    const { hostname, port, origin } = new URL(link);
    const asked = request({ hostname, port, ...options, headers: { origin, ...options.headers } });
    asked.on('response', (answer) => (answer.resume(), done(answer)));
    asked.on('upgrade', (_, socket, head) => done({ socket, head }));
    asked.on('error', failed);
    asked.end(options.body);
});

/** Resolves when the first bytes of a picture come. */
async function firstPicture(link) {
    const { hash } = new URL(link);
    const entered = await call(link, { method: 'POST', path: '/enter', body: JSON.stringify({ key: hash.slice(1) }) });
    const cookie = entered.headers['set-cookie'][0].split(';')[0];
    const { socket, head } = await call(link, {
        path: '/wire',
        headers: { cookie, connection: 'Upgrade', upgrade: 'websocket', 'sec-websocket-version': '13', 'sec-websocket-key': 'AAAAAAAAAAAAAAAAAAAAAA==' },
    });
    let bytes = head;
    await new Promise((done, failed) => {
        // Messages of a server: a kind, a length of one, three or nine bytes, no mask. 2 is binary: a picture.
        const read = (more) => {
            bytes = Buffer.concat([bytes, more]);
            while (bytes.length >= 10) {
                if ((bytes[0] & 15) === 2) return done();
                const short = bytes[1] & 127;
                const [from, length] = short < 126 ? [2, short] : short === 126 ? [4, bytes.readUInt16BE(2)] : [10, Number(bytes.readBigUInt64BE(2))];
                if (bytes.length < from + length) return;
                bytes = bytes.subarray(from + length);
            }
        };
        socket.on('data', read);
        socket.on('close', () => failed(new Error('the line was closed')));
        read(Buffer.alloc(0));
    });
    socket.destroy();
}

/** Goes to a link in a fresh context of an open browser; when what was there [ms since the epoch]. */
async function goTo(browser, link) {
    const context = await browser.newContext({ viewport: { width, height } });
    const page = await context.newPage();
    await page.addInitScript(() => {
        window.__first = {};
        const look = () => {
            const { state } = document.getElementById('desk')?.dataset ?? {};
            if (['good', 'done'].includes(state)) window.__first.good ??= performance.now();
            requestAnimationFrame(look);
        };
        requestAnimationFrame(look);
    });
    await page.goto(link, { waitUntil: 'commit' });
    await page.waitForFunction(() => window.__first.good && window.__desk.frames[0]?.painted, undefined, { timeout: 120_000 });
    const times = await page.evaluate(() => ({
        start: performance.timeOrigin,
        shell: performance.timeOrigin + performance.getEntriesByName('first-contentful-paint')[0]?.startTime,
        received: performance.timeOrigin + window.__desk.frames[0].received,
        drawn: performance.timeOrigin + window.__desk.frames[0].painted,
        full: performance.timeOrigin + (window.__desk.frames.find((f) => f.width === window.__desk.frames.at(-1).width)?.painted ?? NaN),
        good: performance.timeOrigin + window.__first.good,
    }));
    await context.close();
    return times;
}

const print = (name, rows) => {
    const told = Object.keys(rows[0]).map((what) => {
        const list = rows.map((row) => row[what]).sort((a, b) => a - b);
        return `${what} ${list[Math.floor(list.length / 2)].toFixed(0)} [${list[0].toFixed(0)}, ${list.at(-1).toFixed(0)}]`;
    });
    console.log(`  ${name.padEnd(6)} ${told.join('   ')}`);
};

const browser = await openBrowser();
// The first page of a browser starts what all others use.
await (await browser.newPage()).goto('about:blank');
for (const scene of given) {
    console.log(`${scene}: ${runs} runs, a window of ${width} × ${height}, load ${loadavg()[0].toFixed(1)}; ms`);
    const [bytes, start, desk] = [[], [], []];
    for (let run = 0; run < runs; run++) {
        for (const kind of ['bytes', 'start']) {
            const copy = await copyOf(scene);
            const began = Date.now();
            const program = startProgram(copy.file, '--quiet');
            const link = await program.link;
            const printed = Date.now() - began;
            if (kind === 'bytes') {
                await firstPicture(link);
                bytes.push({ link: printed, picture: Date.now() - began });
            } else {
                const { received, drawn, full, good } = await goTo(browser, link);
                start.push({ link: printed, received: received - began, drawn: drawn - began, 'in full size': full - began, good: good - began });
                const again = await goTo(browser, link);
                const since = (at) => at - again.start;
                desk.push({ shell: since(again.shell), received: since(again.received), drawn: since(again.drawn), 'in full size': since(again.full), good: since(again.good) });
            }
            await program.end();
            await copy.remove();
        }
    }
    print('bytes', bytes);
    print('start', start);
    print('desk', desk);
}
await browser.close();
