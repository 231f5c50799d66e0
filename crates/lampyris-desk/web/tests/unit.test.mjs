// What the page reckons by itself: numbers as they are typed, where points are seen, how the eye moves, codes of links.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { browserless, load } from './bundle.mjs';

browserless();
const page = await load('units', 'camera', 'vec', 'swatch', 'overlay');
const later = await load('later/qr', 'later/gizmo', 'later/lamp', 'later/legend', 'later/thing', 'later/area', 'later/verdict', 'later/typed', 'later/there');

const near = (a, b, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);
const nearVec = (a, b, within = 1e-9) => a.forEach((v, k) => near(v, b[k], within));

test('numbers with units mean what people mean by them', () => {
    const cases = [
        ['80 %', 'level', 0.5, 0.8],
        ['80', 'level', 0.5, 0.8],
        ['450lm', 'level', 0.5, 0.5, 900],
        ['0.45 klm', 'level', 0.1, 0.5, 900],
        ['*0.8', 'level', 0.5, 0.4],
        ['*80%', 'level', 0.5, 0.4],
        ['/2', 'level', 0.5, 0.25],
        ['+10', 'level', 0.5, 0.6],
        ['-10', 'level', 0.5, 0.4],
        ['+90 lm', 'level', 0.5, 0.6, 900],
        ['-1/2 stop', 'level', 0.5, 0.5 * Math.SQRT1_2],
        ['+1 stop', 'level', 0.25, 0.5],
        ['-1 ev', 'level', 0.5, 0.25],
        ['full', 'level', 0.2, 1],
        ['out', 'level', 0.2, 0],
        ['-80', 'level', 0.5, 0],
        ['2700K', 'kelvin', 3000, 2700],
        ['+300', 'kelvin', 2700, 3000],
        ['30°', 'angle', 0, 30],
        ['-30', 'angle', 5, -30],
        ['+=30', 'angle', 5, 35],
        ['2.4m', 'length', 0, 2.4],
        ['2,4 m', 'length', 0, 2.4],
        ['75 cm', 'length', 0, 0.75],
        [`8'2"`, 'length', 0, 8 * 0.3048 + 2 * 0.0254],
        ['2m + 30cm', 'length', 0, 2.3],
        ['2 m - 30 cm', 'length', 0, 1.7],
        ['-1.5', 'length', 4, -1.5],
        ['+=10cm', 'length', 4, 4.1],
        ['1/2 ft', 'length', 0, 0.1524],
        ['50 fc', 'lux', 0, 538.195],
        ['60%', 'share', 0, 0.6],
        ['−1/3', 'ev', 8, -1 / 3],
    ];
    for (const [text, quantity, old, expected, flux] of cases) {
        const wish = page.parse(text, quantity, flux);
        assert.ok(wish.apply, `${text}: ${wish.why}`);
        near(wish.apply(old), expected, 1e-9 * Math.max(1, Math.abs(expected)));
    }
});

test('what cannot be understood is explained and changes nothing', () => {
    const cases = [
        ['', 'level'], ['abc', 'level'], ['50 K', 'level'], ['50 lm', 'level'], ['1/0', 'level'], ['/0', 'level'], ['*', 'level'],
        ['1 2', 'kelvin'], ['99', 'kelvin'], ['1e9 K', 'kelvin'], ['2 stop', 'kelvin'], ['--3', 'length'], ['3 m m', 'length'],
        ['3 lx', 'length'], ['1.2', 'share'], ['NaN', 'number'], ['Infinity', 'number'], ['0x10', 'number'],
    ];
    for (const [text, quantity] of cases) {
        const wish = page.parse(text, quantity);
        assert.ok(typeof wish.why === 'string' && wish.why.length > 5, `${text} as ${quantity} was taken`);
    }
});

test('what is shown can be typed', () => {
    for (const quantity of ['level', 'kelvin', 'angle', 'length', 'number', 'flux', 'lux', 'share', 'seconds']) {
        for (const value of [0, 0.5, 0.25, 1, 2700, 12345]) {
            const wish = page.parse(page.format(value, quantity), quantity, 1);
            const shown = page.format(value, quantity);
            if (wish.apply) assert.equal(page.format(wish.apply(-1), quantity), shown);
            else assert.ok(['kelvin', 'share', 'level', 'seconds'].includes(quantity), `${shown}: ${wish.why}`);
        }
    }
});

const camera = { eye: [1, 2, 1.6], target: [4, 3, 1.2], up: [0, 0, 1], fov: 60 };
const up = [0, 0, 1];

test('rays lead back to the pixels they came from', () => {
    for (const c of [camera, { ...camera, height: 4 }]) {
        const view = page.pinhole(c, 640, 480);
        for (const [x, y] of [[0, 0], [639.5, 479.5], [320, 240], [17, 401]]) {
            const { origin, direction } = page.ray(view, x, y);
            const [px, py] = page.project(view, page.add(origin, page.scale(direction, 7)));
            near(px, x, 1e-6);
            near(py, y, 1e-6);
        }
    }
});

test('a pinhole sees as much as its angle says', () => {
    const view = page.pinhole({ eye: [0, 0, 0], target: [0, 1, 0], up, fov: 90 }, 200, 100);
    nearVec(page.project(view, [0, 1, 1]), [100, 0, 1], 1e-9);
    nearVec(page.project(view, [2, 1, 0]), [200, 50, 1], 1e-9);
});

test('looking keeps the eye and the level horizon, walking keeps height and direction', () => {
    let c = camera;
    for (let k = 0; k < 50; k++) c = page.look(c, up, 0.3, 0.2 * (k % 2 ? -1 : 1));
    nearVec(c.eye, camera.eye);
    near(page.distance(c.eye, c.target), page.distance(camera.eye, camera.target), 1e-9);
    near(page.pinhole(c, 10, 10).side[2], 0, 1e-9);
    const steep = page.look(camera, up, 0, 10);
    near(Math.asin(page.normal(page.sub(steep.target, steep.eye))[2]), (89 * Math.PI) / 180, 1e-9);
    const w = page.walk(camera, up, 3, -1, 0);
    near(w.eye[2], camera.eye[2]);
    near(page.distance(w.eye, camera.eye), Math.sqrt(10), 1e-9);
    nearVec(page.sub(w.target, w.eye), page.sub(camera.target, camera.eye));
});

test('orbiting keeps the distance of the point, and the point in its pixel', () => {
    const pivot = [3, 3, 0.7];
    const c = page.orbit(camera, up, pivot, 0.7, -0.2);
    near(page.distance(c.eye, pivot), page.distance(camera.eye, pivot), 1e-9);
    const before = page.project(page.pinhole(camera, 640, 480), pivot);
    const after = page.project(page.pinhole(c, 640, 480), pivot);
    nearVec(after, before, 1e-6);
});

test('the point under the pointer stays under it while one goes nearer, and nobody goes through it', () => {
    const point = [3.5, 3.5, 0.75];
    const before = page.project(page.pinhole(camera, 640, 480), point);
    let c = page.dolly(camera, point, 0.8, 0.15, false);
    nearVec(page.project(page.pinhole(c, 640, 480), point).slice(0, 2), before.slice(0, 2), 1e-6);
    for (let k = 0; k < 100; k++) c = page.dolly(c, point, 0.5, 0.15, false);
    near(page.distance(c.eye, point), 0.15, 1e-9);
    c = page.dolly(c, point, 0.5, 0.15, true);
    assert.ok(page.dot(page.sub(c.eye, point), page.sub(camera.eye, point)) < 0, 'with Shift one goes on');
    const flat = { ...camera, height: 4 };
    const z = page.zoom(flat, page.pinhole(flat, 640, 480), 100, 90, 0.5);
    const under = page.ray(page.pinhole(flat, 640, 480), 100, 90).origin;
    nearVec(page.project(page.pinhole(z, 640, 480), under).slice(0, 2), [100, 90], 1e-6);
});

test('panning takes the point along', () => {
    const view = page.pinhole(camera, 640, 480);
    const point = page.add(camera.eye, page.scale(view.forward, 3));
    const moved = page.pan(camera, view, 40, -25, 3);
    nearVec(page.project(page.pinhole(moved, 640, 480), point).slice(0, 2), [360, 215], 1e-6);
});

test('plan and elevations show the whole room, north above and east to the right', () => {
    for (const above of [[0, 0, 1], [0, 1, 0], [1, 0, 0]]) {
        const bounds = [[-1, -2, -3], [5, 6, 7]];
        for (const which of page.PRESETS) {
            const c = page.preset(which, bounds, above, 1.5);
            const view = page.pinhole(c, 600, 400);
            for (const p of page.corners(bounds)) {
                const [x, y, depth] = page.project(view, p);
                assert.ok(x > 0 && x < 600 && y > 0 && y < 400 && depth > 0, `${which} ${above}`);
            }
            assert.ok(c.near > 1, 'the nearest side is cut away');
        }
        const { right, ahead } = page.compass(above);
        nearVec(page.cross(right, ahead), above);
        const plan = page.pinhole(page.preset('plan', bounds, above, 1.5), 600, 400);
        nearVec(plan.side, right);
        nearVec(plan.up, ahead);
    }
});

test('a framed box is seen whole and from where one looked', () => {
    const box = [[2, 2, 0], [3, 2.5, 0.75]];
    for (const c of [camera, { ...camera, height: 9 }]) {
        const framed = page.frame(c, box);
        const view = page.pinhole(framed, 640, 480);
        page.corners(box).forEach((p) => {
            const [x, y] = page.project(view, p);
            assert.ok(x > 0 && x < 640 && y > 0 && y < 480);
        });
        nearVec(view.forward, page.pinhole(c, 640, 480).forward);
    }
});

test('colours go to the display and back, whites are white where they should be', () => {
    for (const text of ['#000000', '#ffffff', '#7f3f10', '#0102fe']) assert.equal(page.hex(page.fromHex(text)), text);
    assert.equal(page.css([0.2, 0.2, 0.2]), '#ffffff');
});

test('pan and tilt are a direction, and back', () => {
    for (const above of [[0, 0, 1], [0, 1, 0]]) {
        for (const [pan, tilt] of [[0, 0], [90, 30], [-120, 75], [45, -20]]) {
            const d = later.fromPanTilt(pan, tilt, above);
            near(page.length(d), 1);
            nearVec(later.panTilt(d, above), [pan, tilt], 1e-9);
        }
    }
});

test('a turn is a quaternion, and back', () => {
    for (const axis of [0, 1, 2]) for (const angle of [-120, 0, 33, 180]) near(later.turnOf(later.about(axis, angle), axis), angle, 1e-9);
});

test('handles follow the pointer along lines and in planes', () => {
    const at = { origin: [0, 0, 5], direction: page.normal([1, 0, -1]) };
    nearVec(later.onPlane([0, 0, 1], [0, 0, 1], at), [4, 0, 1], 1e-9);
    assert.equal(later.onPlane([0, 0, 1], [0, 0, 1], { origin: [0, 0, 5], direction: [1, 0, 0] }), null);
    near(later.alongLine([0, 0, 1], [1, 0, 0], at), 4.5, 0.51);
    // The nearest point on the line is where the joining line is across both.
    const t = later.alongLine([0, 2, 0], [1, 0, 0], at);
    const onLine = [t, 2, 0];
    const s = page.dot(page.sub(onLine, at.origin), at.direction);
    const gap = page.sub(onLine, page.add(at.origin, page.scale(at.direction, s)));
    near(page.dot(gap, [1, 0, 0]), 0, 1e-9);
    near(page.dot(gap, at.direction), 0, 1e-9);
});

test('legends tick in ones, twos and fives', () => {
    assert.deepEqual(later.ticks(1, 100, 'log').map((v) => Number(v.toPrecision(3))), [1, 2, 5, 10, 20, 50, 100]);
    assert.deepEqual(later.ticks(0, 500, 'linear'), [0, 100, 200, 300, 400, 500]);
    assert.deepEqual(later.ticks(0.001, 100000, 'log').map((v) => Math.log10(v)).map(Math.round), [-3, -2, -1, 0, 1, 2, 3, 4, 5]);
});

test('the spacing of grids is that of the standard', () => {
    near(later.spacing(1), 0.2);
    near(later.spacing(10), 1);
    near(later.spacing(100), 5);
    near(later.spacing(1e6), 10);
});

test('areas have as many points as the library lays', () => {
    for (const [length, points] of [[0.4, 4], [0.6, 4], [1, 5], [2, 6], [5, 8], [10, 10], [50, 16]]) assert.deepEqual(later.counts([length, length]), [points, points]);
    assert.deepEqual(later.counts([30, 2]), [90, 6]);
    assert.deepEqual(later.counts([2, 30]), [6, 90]);
});

test('an area of the floor lies on the work plane, within its border; one of a desk on the desk', () => {
    const up = [0, 0, 1];
    const at = (point, normal = up) => ({ point, normal });
    const floor = later.between(at([1, 1, 0.2]), at([5, 3.5, 0.21]), up, 0.2, 0.75);
    nearVec(floor.corner, [1, 1, 0.95]);
    nearVec([...floor.u, ...floor.v, ...floor.normal], [4, 0, 0, 0, 2.5, 0, 0, 0, 1]);
    assert.equal(floor.border, 0.5);
    // 3 m by 1.5 m are left: twice as long as wide.
    assert.deepEqual([floor.columns, floor.rows], later.counts([3, 1.5]));
    const desk = later.between(at([5, 3.5, 0.95]), at([1, 1, 0.97]), up, 0.2, 0.75);
    nearVec(desk.corner, [1, 1, 0.95]);
    assert.equal(desk.border, 0);
    assert.deepEqual([desk.columns, desk.rows], later.counts([4, 2.5]));
    // From the desk to the floor or to a wall it is the room that is meant.
    for (const b of [at([5, 3.5, 0.2]), at([5, 3.5, 1.4], [0, -1, 0])]) {
        const room = later.between(at([1, 1, 0.95]), b, up, 0.2, 0.8);
        near(room.corner[2], 1);
        assert.equal(room.border, 0.5);
    }
    const sideways = later.between(at([0.3, 2, 1], [1, 0, 0]), at([0.3, 4, 5], [1, 0, 0]), [1, 0, 0], 0.3, 0.75);
    near(sideways.corner[0], 1.05);
    near(page.length(page.cross(sideways.u, sideways.v)), 8);
    assert.equal(later.between(at([1, 1, 0]), at([1.01, 5, 0]), up, 0, 0.75), null);
});

test('points of an area are in the middle of their cells, within the border where there is room for one', () => {
    const grid = { corner: [1, 2, 3], u: [4, 0, 0], v: [0, 0.8, 0], columns: 3, rows: 2, border: 0.5 };
    nearVec(page.gridPoint(grid, 0, 0), [2, 2.2, 3]);
    nearVec(page.gridPoint(grid, 2, 1), [4, 2.6, 3]);
    nearVec(page.gridPoint({ ...grid, border: undefined }, 0, 0), [1 + 4 / 6, 2.2, 3]);
});

test('one walks to where one may stand, and looks as before', () => {
    const to = (point, normal = up, c = camera) => later.standing(c, up, { point, normal });
    const there = to([5, 2, 0]);
    nearVec(there.eye, [5, 2, 1.6]);
    nearVec(page.sub(there.target, there.eye), page.sub(camera.target, camera.eye));
    for (const none of [to([5, 2, 0.75]), to([5, 2, 0], [1, 0, 0]), to([5, 2, 3], [0, 0, -1]), to([5, 2, 0], up, { ...camera, height: 4 })]) assert.equal(none, null);
});

test('axes and digits are found on every keyboard', () => {
    const cases = [
        // English; German, where Z and Y have each other's places; French, whose digits want Shift; Russian and Greek.
        ['x', 'KeyX', { axis: 0 }], ['Y', 'KeyY', { axis: 1 }], ['z', 'KeyZ', { axis: 2 }], ['z', 'KeyY', { axis: 2 }], ['y', 'KeyZ', { axis: 1 }],
        ['z', 'KeyW', { axis: 2 }], ['w', 'KeyZ', {}], ['&', 'Digit1', { sign: '1' }], ['1', 'Digit1', { sign: '1' }], ['-', 'Digit6', { sign: '-' }],
        ['ч', 'KeyX', { axis: 0 }], ['я', 'KeyZ', { axis: 2 }], ['χ', 'KeyX', { axis: 0 }], ['7', 'Numpad7', { sign: '7' }], [',', 'NumpadDecimal', { sign: '.' }],
        ['.', 'Period', { sign: '.' }], ['-', 'Slash', { sign: '-' }], ['Enter', 'NumpadEnter', { does: 'keep' }], ['Escape', 'Escape', { does: 'leave' }],
        ['Backspace', 'Backspace', { does: 'back' }], ['a', 'KeyQ', {}], ['ArrowUp', 'ArrowUp', {}], ['Tab', 'Tab', {}],
    ];
    for (const [key, code, expected] of cases) assert.deepEqual(later.strokeOf({ key, code }), expected, `${key} on ${code}`);
    for (const [signs, value] of [['1.5', 1.5], ['-.25', -0.25], ['5-', -5], ['-5-', 5], ['1..5', 1.5], ['-', 0], ['.', 0], ['', 0], ['-30', -30], ['123456789012', 123456789]]) {
        assert.equal(later.numberIn([...signs].reduce(later.typedOn, '')), value, signs);
    }
});

test('a verdict waits until the ± allows it, and is the plain comparison when figures are final', () => {
    const of = (value, error, least = 500) => ({ value, error, least });
    const cases = [
        [[of(522, 22)], 'met'], [[of(521.9, 22)], 'open'], [[of(500, 0)], 'met'], [[of(478, 22)], 'open'], [[of(477.9, 22)], 'missed'],
        [[of(1e6, null)], 'open'], [[of(0, null)], 'open'], [[of(530, Infinity)], 'open'], [[of(1, 1, 0)], 'met'],
        // All must be met; one that is surely missed decides.
        [[of(530, 22), of(0.65, 0.04, 0.6)], 'met'], [[of(530, 22), of(0.63, 0.04, 0.6)], 'open'],
        [[of(530, 22), of(0.55, 0.04, 0.6)], 'missed'], [[of(510, 22), of(0.55, 0.04, 0.6)], 'missed'], [[of(510, 22), of(0.7, null, 0.6)], 'open'],
    ];
    for (const [figures, expected] of cases) {
        assert.equal(later.verdict(figures, false), expected, JSON.stringify(figures));
        const plain = figures.every(({ value, least }) => value >= least) ? 'met' : 'missed';
        assert.equal(later.verdict(figures, true), plain, JSON.stringify(figures));
    }
    // Wherever the truth lies within the ±, what is decided is true of it, and what becomes known better is never turned round.
    for (let value = 450; value <= 550; value += 5) for (const error of [0, 3, 20, 60]) {
        const told = later.verdict([of(value, error)], false);
        for (let share = -1; share <= 1; share += 0.25) {
            const truth = value + share * error;
            if (told !== 'open') assert.equal(later.verdict([of(truth, 0)], true), told);
        }
    }
});

test('check bytes make a code divisible by its generator', () => {
    // ISO/IEC 18004, annex I: version 1-M, "01234567".
    const data = [0x10, 0x20, 0x0c, 0x56, 0x61, 0x80, 0xec, 0x11, 0xec, 0x11, 0xec, 0x11, 0xec, 0x11, 0xec, 0x11];
    assert.deepEqual(later.check(data, 10), [0xa5, 0x24, 0xd4, 0xc1, 0xed, 0x36, 0xc7, 0x87, 0x2c, 0x55]);
    // Table C.1 of the same: level L, mask 4 is 110011000101111.
    assert.equal(later.formatBits(4), 0b110011000101111);
    assert.equal(later.formatBits(0), 0b111011111000100);
});

test('codes have their finders, their timing, and room for a link', () => {
    for (const length of [1, 17, 18, 40, 78, 106, 134]) {
        const cells = later.qr('x'.repeat(length));
        const n = cells.length;
        const finder = (x0, y0) => {
            for (let y = 0; y < 7; y++) for (let x = 0; x < 7; x++) {
                const r = Math.max(Math.abs(x - 3), Math.abs(y - 3));
                assert.equal(cells[y0 + y][x0 + x], r !== 2);
            }
        };
        finder(0, 0);
        finder(n - 7, 0);
        finder(0, n - 7);
        for (let k = 8; k < n - 8; k++) {
            assert.equal(cells[6][k], k % 2 === 0);
            assert.equal(cells[k][6], k % 2 === 0);
        }
        assert.equal(cells[n - 8][8], true);
    }
    assert.equal(later.qr('x'.repeat(135)), null);
});
