// A QR code of a link: bytes, level L, versions 1 to 6 (ISO/IEC 18004), so up to 134 characters.

/** Of each version: data bytes in all, error bytes of a block, blocks. */
const VERSIONS: [number, number, number][] = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]];

const EXP = new Uint8Array(512);
const LOG = new Uint8Array(256);
for (let k = 0, x = 1; k < 255; k++) {
    EXP[k] = EXP[k + 255] = x;
    LOG[x] = k;
    x = (x << 1) ^ (x & 128 ? 0x11d : 0);
}
const times = (a: number, b: number): number => (a && b ? EXP[LOG[a] + LOG[b]] : 0);

/** The remainder of data by the generator of so many roots: Reed and Solomon's check bytes. */
export function check(data: number[], count: number): number[] {
    let generator = [1];
    for (let k = 0; k < count; k++) {
        const next = new Array<number>(generator.length + 1).fill(0);
        generator.forEach((g, i) => {
            next[i] ^= g;
            next[i + 1] ^= times(g, EXP[k]);
        });
        generator = next;
    }
    const rest = [...data, ...new Array<number>(count).fill(0)];
    for (let i = 0; i < data.length; i++) {
        const factor = rest[i];
        if (factor) generator.forEach((g, j) => (rest[i + j] ^= times(g, factor)));
    }
    return rest.slice(data.length);
}

/** Bytes of the code: length, text, padding, and the check bytes, blocks interleaved. */
function codewords(bytes: number[], version: number): number[] {
    const [capacity, errors, blocks] = VERSIONS[version - 1];
    const bits: number[] = [];
    const put = (value: number, count: number) => {
        for (let k = count - 1; k >= 0; k--) bits.push((value >> k) & 1);
    };
    put(4, 4);
    put(bytes.length, 8);
    bytes.forEach((byte) => put(byte, 8));
    put(0, Math.min(4, capacity * 8 - bits.length));
    while (bits.length % 8) bits.push(0);
    const data: number[] = [];
    for (let k = 0; k < bits.length; k += 8) data.push(parseInt(bits.slice(k, k + 8).join(''), 2));
    for (let pad = 0xec; data.length < capacity; pad ^= 0xec ^ 0x11) data.push(pad);
    const size = capacity / blocks;
    const parts = Array.from({ length: blocks }, (_, b) => data.slice(b * size, (b + 1) * size));
    const checks = parts.map((part) => check(part, errors));
    const woven = (lists: number[][]) => lists[0].flatMap((_, k) => lists.map((list) => list[k]));
    return [...woven(parts), ...woven(checks)];
}

const MASKS: ((x: number, y: number) => boolean)[] = [
    (x, y) => (x + y) % 2 === 0,
    (_, y) => y % 2 === 0,
    (x) => x % 3 === 0,
    (x, y) => (x + y) % 3 === 0,
    (x, y) => (Math.floor(y / 2) + Math.floor(x / 3)) % 2 === 0,
    (x, y) => ((x * y) % 2) + ((x * y) % 3) === 0,
    (x, y) => (((x * y) % 2) + ((x * y) % 3)) % 2 === 0,
    (x, y) => (((x + y) % 2) + ((x * y) % 3)) % 2 === 0,
];

/** The fifteen bits that name level L and the mask. */
export function formatBits(mask: number): number {
    const data = (1 << 3) | mask;
    let rest = data << 10;
    for (let k = 14; k >= 10; k--) if ((rest >> k) & 1) rest ^= 0x537 << (k - 10);
    return ((data << 10) | rest) ^ 0x5412;
}

/** How hard a code is to read: runs, squares, false finders, imbalance. */
function penalty(cells: boolean[][]): number {
    const n = cells.length;
    let sum = 0;
    let dark = 0;
    for (const turned of [false, true]) {
        for (let a = 0; a < n; a++) {
            const line = Array.from({ length: n }, (_, b) => (turned ? cells[b][a] : cells[a][b]));
            let run = 1;
            for (let b = 1; b <= n; b++) {
                if (b < n && line[b] === line[b - 1]) run++;
                else {
                    if (run >= 5) sum += run - 2;
                    run = 1;
                }
            }
            const text = line.map(Number).join('');
            for (let b = 0; b + 11 <= n; b++) {
                const part = text.slice(b, b + 11);
                if (part === '10111010000' || part === '00001011101') sum += 40;
            }
        }
    }
    for (let y = 0; y < n; y++) {
        for (let x = 0; x < n; x++) {
            if (cells[y][x]) dark++;
            if (x && y && cells[y][x] === cells[y - 1][x] && cells[y][x] === cells[y][x - 1] && cells[y][x] === cells[y - 1][x - 1]) sum += 3;
        }
    }
    return sum + 10 * Math.floor(Math.abs((dark * 20) / (n * n) - 10));
}

/** Rows of a code, true where it is dark; null if the text is too long. */
export function qr(text: string): boolean[][] | null {
    const bytes = [...new TextEncoder().encode(text)];
    const version = VERSIONS.findIndex(([capacity]) => bytes.length + 2 <= capacity) + 1;
    if (!version) return null;
    const n = 17 + 4 * version;
    const cells = Array.from({ length: n }, () => new Array<boolean>(n).fill(false));
    const fixed = Array.from({ length: n }, () => new Array<boolean>(n).fill(false));
    const set = (x: number, y: number, dark: boolean) => {
        if (x < 0 || y < 0 || x >= n || y >= n) return;
        cells[y][x] = dark;
        fixed[y][x] = true;
    };
    for (let k = 0; k < n; k++) {
        set(k, 6, k % 2 === 0);
        set(6, k, k % 2 === 0);
    }
    for (const [cx, cy] of [[3, 3], [n - 4, 3], [3, n - 4]]) {
        for (let dy = -4; dy <= 4; dy++) {
            for (let dx = -4; dx <= 4; dx++) {
                const r = Math.max(Math.abs(dx), Math.abs(dy));
                set(cx + dx, cy + dy, r !== 2 && r !== 4);
            }
        }
    }
    if (version > 1) {
        const c = n - 7;
        for (let dy = -2; dy <= 2; dy++) for (let dx = -2; dx <= 2; dx++) set(c + dx, c + dy, Math.max(Math.abs(dx), Math.abs(dy)) !== 1);
    }
    const form = (mask: number) => {
        const bits = formatBits(mask);
        for (let k = 0; k < 15; k++) {
            const dark = ((bits >> k) & 1) === 1;
            const line = k < 6 ? k : k < 8 ? k + 1 : n - 15 + k;
            set(8, line, dark);
            set(k < 8 ? n - 1 - k : k < 9 ? 7 : 14 - k, 8, dark);
        }
        set(8, n - 8, true);
    };
    form(0);
    const words = codewords(bytes, version);
    let bit = 0;
    for (let right = n - 1; right > 0; right -= 2) {
        if (right === 6) right = 5;
        for (let step = 0; step < n; step++) {
            for (const x of [right, right - 1]) {
                const upward = ((right + 1) & 2) === 0;
                const y = upward ? n - 1 - step : step;
                if (fixed[y][x]) continue;
                cells[y][x] = bit < words.length * 8 && ((words[bit >> 3] >> (7 - (bit & 7))) & 1) === 1;
                bit++;
            }
        }
    }
    const masked = (mask: number) => {
        form(mask);
        return cells.map((row, y) => row.map((dark, x) => dark !== (!fixed[y][x] && MASKS[mask](x, y))));
    };
    let best = masked(0);
    let least = penalty(best);
    for (let mask = 1; mask < 8; mask++) {
        const next = masked(mask);
        const worth = penalty(next);
        if (worth < least) [best, least] = [next, worth];
    }
    return best;
}
