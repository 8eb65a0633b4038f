// Bundles everything into one page: node build.js OUTPUT
import { buildSync, transformSync } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';

const [output = 'kanexpr.html'] = process.argv.slice(2);
const beside = (name) => new URL(name, import.meta.url);
const text = (name) => readFileSync(beside(name), 'utf8');

function put(page, place, content) {
  if (!page.includes(place)) throw new Error(`page.html does not contain ${place}`);
  return page.replace(place, () => content);
}

const script = buildSync({
  absWorkingDir: new URL('.', import.meta.url).pathname,
  entryPoints: ['viewer.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  legalComments: 'inline',
  write: false,
}).outputFiles[0].text;
const style = transformSync(text('page.css'), { loader: 'css', minify: true }).code;

let page = text('page.html');
page = put(page, '<link rel="stylesheet" href="page.css">', `<style>${style}</style>`);
page = put(page, '<script type="module" src="viewer.js"></script>', `<script>${script}</script>`);
writeFileSync(output, page);
