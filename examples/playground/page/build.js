// Bundles everything into one page: node build.js ENGINE MODELS OUTPUT
import { buildSync } from 'esbuild';
import { gzipSync } from 'node:zlib';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [engine, models, output] = process.argv.slice(2);
const here = new URL('.', import.meta.url).pathname;
const read = (name) => readFileSync(join(here, name), 'utf8');

/// The examples in the order in which the page offers them.
const order = ['pendulum', 'double_pendulum', 'cart_pole', 'spring_pendulum', 'gyroscope', 'four_bar', 'sleigh'];
const examples = order.map((name) => ({
  title: name.replaceAll('_', ' ').replace(/^./, (first) => first.toUpperCase()),
  model: readFileSync(join(models, `${name}.txt`), 'utf8'),
}));
writeFileSync(join(here, 'examples.js'), `export const examples = ${JSON.stringify(examples)};\n`);

function bundle(entry, more) {
  return buildSync({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    target: 'es2022',
    loader: { '.woff2': 'dataurl', '.woff': 'empty', '.ttf': 'empty' },
    legalComments: 'inline',
    write: false,
    outdir: here,
    ...more,
  }).outputFiles;
}

function put(page, place, content) {
  if (!page.includes(place)) throw new Error(`page.html does not contain ${place}`);
  return page.replace(place, () => content);
}

const files = bundle('main.js', { format: 'esm' });
const textOf = (ending) => files.filter((file) => file.path.endsWith(ending)).map((file) => file.text).join('\n');
const style = textOf('.css') + bundle('page.css', {})[0].text;
let page = read('page.html');
page = put(page, '<link rel="stylesheet" href="page.css">', `<style>${style}</style>`);
page = put(page, '<script type="module" src="main.js"></script>', `<script type="module">${textOf('.js').replaceAll('</script', '<\\/script')}</script>`);
page = put(page, '@engine@', gzipSync(readFileSync(engine), { level: 9 }).toString('base64'));
writeFileSync(output, page);
