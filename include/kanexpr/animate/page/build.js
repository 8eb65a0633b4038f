// Bundles everything into one page: node build.js OUTPUT
import { buildSync, transformSync } from 'esbuild';
import { deflateRawSync } from 'node:zlib';
import { readFileSync, writeFileSync } from 'node:fs';

const [output = 'kanexpr.html'] = process.argv.slice(2);
const beside = (name) => new URL(name, import.meta.url);
const text = (name) => readFileSync(beside(name), 'utf8');

function put(page, place, content) {
  if (!page.includes(place)) throw new Error(`page.html does not contain ${place}`);
  return page.replace(place, () => content);
}

function bundled(entry) {
  return buildSync({
    absWorkingDir: new URL('.', import.meta.url).pathname,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2020',
    legalComments: 'none', // the licenses are in the page
    write: false,
  }).outputFiles[0].text;
}

function minified(css) {
  return transformSync(css, { loader: 'css', minify: true }).code;
}

const licenses = ['fflate', 'three', 'uplot']
  .map((name) => `${name}\n\n${text(`node_modules/${name}/LICENSE`).trim()}`).join('\n\n');
if (/--|>/.test(licenses)) throw new Error('a license cannot be written in a comment');
const script = deflateRawSync(bundled('viewer.js'), { level: 9 }).toString('base64');

let page = text('page.html');
page = put(page, '@licenses@', licenses);
page = put(page, '<link rel="stylesheet" href="page.css">',
  `<style>${minified(text('node_modules/uplot/dist/uPlot.min.css'))}${minified(text('page.css'))}</style>`);
page = put(page, '<script type="module" src="viewer.js"></script>',
  `<script type="text/plain" id="viewer">${script}</script>\n<script>${bundled('loader.js')}</script>`);
writeFileSync(output, page);
