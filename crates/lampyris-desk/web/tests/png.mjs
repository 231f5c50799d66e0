// Small PNG files: pictures of at most 256 colours, chosen by median cut.

import { crc32, deflateSync } from 'node:zlib';

/** Colours are told apart by so many bits a channel before they are sorted into boxes. */
const BITS = 6;

/** Splits the box with the widest spread until there are `count`; returns the mean of each and whose colour is where. */
function palette(data, count) {
    const shift = 8 - BITS;
    const seen = new Map();
    for (let k = 0; k < data.length; k += 4) {
        const key = ((data[k] >> shift) << (2 * BITS)) | ((data[k + 1] >> shift) << BITS) | (data[k + 2] >> shift);
        const entry = seen.get(key) ?? { key, n: 0, sum: [0, 0, 0] };
        entry.n++;
        for (let c = 0; c < 3; c++) entry.sum[c] += data[k + c];
        seen.set(key, entry);
    }
    for (const entry of seen.values()) entry.mean = entry.sum.map((s) => s / entry.n);
    const box = (list) => {
        const spread = [0, 1, 2].map((c) => {
            const total = list.reduce((sum, e) => sum + e.n, 0);
            const middle = list.reduce((sum, e) => sum + e.sum[c], 0) / total;
            return list.reduce((sum, e) => sum + e.n * (e.mean[c] - middle) ** 2, 0);
        });
        const axis = spread.indexOf(Math.max(...spread));
        return { list, axis, spread: list.length > 1 ? spread[axis] : 0 };
    };
    const boxes = [box([...seen.values()])];
    while (boxes.length < count) {
        boxes.sort((a, b) => b.spread - a.spread);
        const widest = boxes[0];
        if (!widest.spread) break;
        const list = widest.list.sort((a, b) => a.mean[widest.axis] - b.mean[widest.axis]);
        const half = list.reduce((sum, e) => sum + e.n, 0) / 2;
        let [at, sum] = [0, 0];
        while (at < list.length - 1 && sum < half) sum += list[at++].n;
        at = Math.max(1, at);
        boxes.splice(0, 1, box(list.slice(0, at)), box(list.slice(at)));
    }
    const where = new Map();
    const colors = boxes.map(({ list }, k) => {
        const n = list.reduce((sum, e) => sum + e.n, 0);
        for (const e of list) where.set(e.key, k);
        return [0, 1, 2].map((c) => Math.round(list.reduce((sum, e) => sum + e.sum[c], 0) / n));
    });
    return { colors, where };
}

function chunk(name, body) {
    const head = Buffer.alloc(8);
    head.writeUInt32BE(body.length);
    head.write(name, 4, 'latin1');
    const tail = Buffer.alloc(4);
    tail.writeUInt32BE(crc32(body, crc32(head.subarray(4))));
    return Buffer.concat([head, body, tail]);
}

/** RGBA pixels as a PNG with a palette of `count` colours. */
export function indexed({ width, height, data }, count) {
    const { colors, where } = palette(data, count);
    const shift = 8 - BITS;
    const rows = Buffer.alloc(height * (width + 1));
    for (let y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) {
            const k = 4 * (y * width + x);
            rows[y * (width + 1) + 1 + x] = where.get(((data[k] >> shift) << (2 * BITS)) | ((data[k + 1] >> shift) << BITS) | (data[k + 2] >> shift));
        }
    }
    const head = Buffer.alloc(13);
    head.writeUInt32BE(width, 0);
    head.writeUInt32BE(height, 4);
    head.set([8, 3, 0, 0, 0], 8);
    return Buffer.concat([
        Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
        chunk('IHDR', head), chunk('PLTE', Buffer.from(colors.flat())), chunk('IDAT', deflateSync(rows, { level: 9 })), chunk('IEND', Buffer.alloc(0)),
    ]);
}

/** The same with as many colours as keep it within so many bytes. */
export function small(picture, bytes) {
    for (let count = 256; count > 16; count = Math.round(count * 0.8)) {
        const file = indexed(picture, count);
        if (file.length <= bytes) return file;
    }
    return indexed(picture, 16);
}
