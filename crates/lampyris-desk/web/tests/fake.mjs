// A program that only says what a test wants: a state, a grey picture, and what comes after.

import { deflateSync, crc32 } from 'node:zlib';

const camera = { number: 0, eye: [0.6, 0.6, 1.6], target: [4, 3, 1.2], up: [0, 0, 1], fov: 60, height: null, near: 0 };
const color = (mode = 'file') => ({ mode, kelvin: 3000, tint: 0, rgb: [1, 0.7, 0.4], xy: [0.44, 0.4] });

export function lamp(id, more = {}) {
    return {
        name: `Lamp ${id}`, kind: 'spot', on: true, level: 0.8, color: color(id % 2 ? 'kelvin' : 'file'), flux: 400 + id, swatch: [1.2, 0.97, 0.7],
        group: id % 3, layer: id % 8, free: id % 5 !== 4, parked: false, own: false,
        place: { position: [1 + (id % 6), 1 + (id % 4), 2.6], direction: [0, 0, -1], aim: null, inner: 24, outer: 36 }, box: null, ...more,
    };
}

export function state({ lamps = 24, ...more } = {}) {
    const all = Object.fromEntries(Array.from({ length: lamps }, (_, id) => [id, lamp(id)]));
    const members = (g) => Object.keys(all).map(Number).filter((id) => id % 3 === g);
    return {
        scene: { name: 'room.mgf', file: 'scenes/room.mgf', up: [0, 0, 1], bounds: [[0, 0, 0], [8, 6, 3]], triangles: 41230, cameras: [], warnings: ['a remark'] },
        lamps: all,
        groups: lamps ? { 0: { name: 'Row A', on: true, level: 1, lamps: members(0) }, 1: { name: 'Row B', on: true, level: 0.5, lamps: members(1) }, 2: { name: 'Walls', on: true, level: 1, lamps: members(2) } } : {},
        layers: [{ name: 'Row A', batches: 32, of: 32, held: false }, { name: 'Row B', batches: 3, of: 32, held: false }],
        things: { 0: { name: 'desk', place: { position: [4, 3, 0.4] }, hidden: false, box: [[3, 2, 0], [5, 4, 0.75]], materials: [0], locked: true } },
        materials: { 0: { name: 'oak', kind: 'gloss', color: [0.5, 0.4, 0.3], reflectance: 0.4, roughness: 0.2, specular: 0.04 } },
        views: { 0: { ...camera, name: 'door' } },
        looks: { 0: { name: 'as built', picture: null }, 1: { name: 'evening', picture: null } },
        meters: { 0: { name: 'Desk', kind: 'horizontal', point: [5, 3, 0.75], normal: [0, 0, 1], lux: [512, 5] } },
        grids: { 0: { name: 'Area', corner: [4, 2, 0.75], u: [2, 0, 0], v: [0, 1.4, 0], normal: [0, 0, 1], columns: 6, rows: 4, lux: [], mean: 486, min: 306, max: 640, uniformity: 0.63, error: 0.01, target: { lux: 500, uniformity: 0.6 } } },
        display: { ev: 8.3, metered: true, tone: 'filmic', white: null, false_color: null },
        solo: [], history: { undo: 'Dim', redo: null, steps: 1 }, saved: { state: 'saved', file: 'room.mgf.lampyris.json' }, editor: { you: true, name: 'you' },
        status: { stage: 'good', fps: 20, batches: 64, error: 0.012, good_in: 0, size: [64, 48] },
        ...more,
    };
}

function png(width, height, grey) {
    const chunk = (kind, data) => {
        const body = Buffer.concat([Buffer.from(kind), data]);
        const out = Buffer.alloc(body.length + 8);
        out.writeUInt32BE(data.length, 0);
        body.copy(out, 4);
        out.writeUInt32BE(crc32 ? crc32(body) : 0, body.length + 4);
        return out;
    };
    const head = Buffer.alloc(13);
    head.writeUInt32BE(width, 0);
    head.writeUInt32BE(height, 4);
    head.set([8, 0], 8);
    const rows = Buffer.alloc((width + 1) * height, grey);
    for (let y = 0; y < height; y++) rows[y * (width + 1)] = 0;
    return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk('IHDR', head), chunk('IDAT', deflateSync(rows)), chunk('IEND', Buffer.alloc(0))]);
}

export function frame({ number = 1, seq = 0, kind = 1, width = 64, height = 48, grey = 120 } = {}) {
    const head = Buffer.alloc(32);
    head.writeUInt32LE(number, 0);
    head.writeUInt32LE(seq, 4);
    head.writeUInt16LE(width, 12);
    head.writeUInt16LE(height, 14);
    head[16] = kind;
    head[17] = 1;
    head.writeUInt32LE(64, 20);
    head.writeFloatLE(0.012, 24);
    return Buffer.concat([head, png(width, height, grey)]);
}

/** Speaks for the program on every line that a page opens; returns the lines and what was heard. */
export async function speakFor(page, told = state(), { role = 'edit', build = () => 'b', picture = true, more = [] } = {}) {
    const lines = [];
    const heard = [];
    await page.routeWebSocket(/\/wire$/, (line) => {
        lines.push(line);
        const say = (message) => line.send(JSON.stringify(message));
        line.onMessage((text) => {
            const message = JSON.parse(text);
            heard.push(message);
            if (message.do === 'set' || message.do === 'end') say({ is: 'patch', seq: message.seq, patch: {} });
            if (message.do === 'ask' && message.what === 'point') {
                say({ is: 'answer', id: message.id, hit: true, point: [4, 3, 0.75], normal: [0, 0, 1], thing: 0, material: 0, lamp: null, lux: [512, 5], luminance: [80, 1] });
            }
            if (message.do === 'ask' && message.what === 'light') {
                say({ is: 'answer', id: message.id, lux: [512, 5], lamps: [0, 1, 2].map((id) => ({ id, direct: [200 - 50 * id, 2], indirect: [40, 2], caustic: [3, 1] })), done: true });
            }
            if (message.do === 'links') say({ is: 'links', links: [{ id: 0, role: 'edit', address: 'http://127.0.0.1:8080/#abcdef' }] });
            if (message.do === 'display') {
                told.display = { ...told.display, ...message.patch };
                say({ is: 'patch', seq: message.seq, patch: { display: told.display } });
            }
        });
        say({ is: 'hello', protocol: 1, build: build(), you: 1, role });
        if (told) say({ is: 'state', seq: 0, state: told });
        say({ is: 'camera', ...camera });
        if (told && picture) line.send(frame());
        more.forEach(say);
    });
    return { lines, heard };
}
