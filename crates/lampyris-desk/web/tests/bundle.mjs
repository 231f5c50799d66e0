// Bundles parts of the page's sources for tests that need no browser.

import { build } from 'esbuild';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const source = join(dirname(fileURLToPath(import.meta.url)), '..', 'src');

/** All that the named modules export, as one module. */
export async function load(...names) {
    const contents = names.map((name) => `export * from './${name}';`).join('\n');
    const { outputFiles } = await build({
        stdin: { contents, resolveDir: source, loader: 'ts' },
        bundle: true, format: 'esm', target: 'es2022', write: false, logLevel: 'error',
        jsx: 'automatic', jsxImportSource: 'preact',
    });
    const folder = await mkdtemp(join(tmpdir(), 'lampyris-page-'));
    const file = join(folder, 'page.mjs');
    await writeFile(file, outputFiles[0].contents);
    const module = await import(pathToFileURL(file));
    await rm(folder, { recursive: true });
    return module;
}

/** What a browser has and these sources look for. */
export function browserless() {
    const heard = new Map();
    Object.assign(globalThis, {
        window: globalThis,
        addEventListener: (kind, listener) => heard.set(kind, listener),
        requestAnimationFrame: (run) => setTimeout(() => run(performance.now()), 4),
        sessionStorage: { getItem: () => null, setItem() {} },
        localStorage: { getItem: () => null, setItem() {} },
        location: { protocol: 'http:', host: '127.0.0.1:1', hostname: '127.0.0.1', hash: '', pathname: '/', search: '' },
    });
}
