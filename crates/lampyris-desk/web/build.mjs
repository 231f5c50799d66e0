// Bundles the page into dist: fixed names, white space kept, identifiers shortened, the same bytes from the same sources.
// `--check` also holds the result against the budget of sizes; `--watch` builds again whenever a source changes.

import { build, context } from 'esbuild';
import { copyFile, mkdir, readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const require = createRequire(import.meta.url);
const dist = join(here, 'dist');

/** kB after gzip, at most. */
const BUDGET = { 'desk.js': 42, 'desk.js + gizmo.js': 110, 'desk.css': 12, all: 120 };

const options = {
    absWorkingDir: here,
    bundle: true,
    format: 'esm',
    target: 'es2022',
    minifyIdentifiers: true,
    minifySyntax: true,
    jsxSideEffects: true,
    legalComments: 'none',
    charset: 'utf8',
    logLevel: 'warning',
    jsx: 'automatic',
    jsxImportSource: 'preact',
    outdir: 'dist',
};
/** The file that is loaded first, and the one that comes after the first picture and takes from it all that both need. */
const first = { ...options, entryPoints: { desk: 'src/main.tsx' } };
const FIRST = './desk.js';
const second = {
    ...options,
    entryPoints: { gizmo: 'src/later/index.ts' },
    plugins: [{
        name: 'taken from the first file',
        setup: (build) => build.onResolve({ filter: /^(\.\.\/desk|preact.*|@preact\/.*)$/ }, () => ({ path: FIRST, external: true })),
    }],
};

/** The licence texts of all that is in the bundle, each once. */
async function licences() {
    const packages = ['preact', '@preact/signals', '@preact/signals-core'];
    const texts = [];
    for (const name of packages) {
        const folder = join(here, 'node_modules', name);
        const { version, license } = require(join(folder, 'package.json'));
        const text = await readFile(join(folder, 'LICENSE'), 'utf8');
        texts.push(`${name} ${version} (${license})\n\n${text.trim()}\n`);
    }
    return `What the page of the lighting desk contains besides Lampyris' own code.\n\n${texts.join('\n---\n\n')}`;
}

async function finish() {
    await mkdir(dist, { recursive: true });
    for (const name of ['index.html', 'icons.svg']) await copyFile(join(here, 'src', name), join(dist, name));
    await writeFile(join(dist, 'THIRD-PARTY.txt'), await licences());
}

async function check() {
    const size = async (name) => gzipSync(await readFile(join(dist, name)), { level: 9 }).length / 1000;
    const sizes = {};
    for (const name of ['index.html', 'desk.js', 'gizmo.js', 'desk.css', 'icons.svg', 'THIRD-PARTY.txt']) {
        sizes[name] = await size(name);
    }
    const all = Object.values(sizes).reduce((a, b) => a + b, 0);
    const got = { ...sizes, 'desk.js + gizmo.js': sizes['desk.js'] + sizes['gizmo.js'], all };
    let over = false;
    for (const [name, kilobytes] of Object.entries(got)) {
        const most = BUDGET[name];
        if (most && kilobytes > most) over = true;
        console.log(`${name.padEnd(20)} ${kilobytes.toFixed(1).padStart(7)} kB${most ? ` of ${most}` : ''}`);
    }
    if (over) {
        console.error('the bundle is larger than its budget');
        process.exitCode = 1;
    }
}

if (process.argv.includes('--watch')) {
    await finish();
    for (const each of [first, second]) await (await context(each)).watch();
} else {
    for (const each of [first, second]) await build(each);
    await finish();
    if (process.argv.includes('--check')) await check();
}
