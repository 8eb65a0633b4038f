// node drive.js CHROMIUM DIRECTORY: opens the page in DIRECTORY without a network and looks at what it does.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { checkControls, checkDeflections, checkRuns } from './controls.js';
import { checkColours, checkLayout, checkPhone } from './layout.js';
import { assertNear, turned } from './numbers.js';
import { checkSweeps } from './sweeps.js';

const [browserPath, directory] = process.argv.slice(2);
const addressOf = (name) => pathToFileURL(join(directory, name)).href;
const address = addressOf('disc.html');
const read = (name) => JSON.parse(readFileSync(join(directory, name), 'utf8'));
const expected = read('disc.json');
const home = mkdtempSync(join(tmpdir(), 'kanexpr-page-'));

function launch(folder, options) {
  return chromium.launchPersistentContext(join(home, folder), {
    executablePath: browserPath,
    offline: true,
    reducedMotion: 'reduce',
    args: [
      '--no-sandbox', '--no-first-run', '--disable-background-networking', '--disable-component-update',
      '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
    ],
    ...options,
  });
}

const context = await launch('desktop', { viewport: { width: 640, height: 400 } });
const phone = await launch('phone', {
  viewport: { width: 390, height: 760 }, hasTouch: true, isMobile: true,
});
for (const each of [context, phone]) each.setDefaultTimeout(120_000); // a busy machine draws without a graphics card

try {
  const page = await context.newPage();
  const troubles = listen(page);
  await page.goto(address);
  await checkTitle(page);
  await checkPoses(page, expected);
  await checkMeshes(page);
  await checkBetween(page);
  await checkPicture(page);
  await checkScrubbing(page);
  await checkKeys(page);
  await checkPlaying(page);
  await checkResizing(page);
  await checkLayout(page);
  await checkControls(page, expected);
  await checkColours(page, drawn);
  await checkMotionByItself(page);
  assert.deepEqual(troubles, []);
  await page.close();
  await checkBrokenMeshes(context);
  await checkWithoutWebGL(context);
  for (const each of [context, phone]) await withPage(each, 'runs.html', checkRuns);
  await withPage(phone, 'disc.html', checkPhone);
  const [swept, beam] = [read('swept.json'), read('beam.json')];
  await withPage(context, 'beam.html', async (page) => {
    await checkPoses(page, beam);
    await checkDeflections(page);
  });
  await withPage(context, 'swept.html', (page) => checkSweeps(page, swept));
} finally {
  await context.close();
  await phone.close();
  rmSync(home, { recursive: true, force: true });
}

/// Opens a page, and requires that it has no trouble.
async function withPage(browser, name, check) {
  const page = await browser.newPage();
  const troubles = listen(page, addressOf(name));
  await page.goto(addressOf(name));
  await check(page);
  assert.deepEqual(troubles, []);
  await page.close();
}

/// Everything that the page says, but what is for its authors, and every request beyond the file itself.
function listen(page, own = address) {
  const troubles = [];
  page.on('console', (message) => {
    if (message.type() !== 'debug') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => {
    if (request.url() !== own && !/^(data|blob):/.test(request.url())) troubles.push(request.url());
  });
  return troubles;
}

async function checkTitle(page) {
  const title = 'A disc <on a circle> & @motion@</script>';
  assert.equal(await page.title(), title);
  assert.equal(await page.locator('h1').textContent(), title);
  assert.equal(await page.locator('#values th').first().textContent(), 't');
  assert.equal(await page.locator('#text').textContent(), 'A shape of every kind.');
  assert.equal(await page.locator('#trouble').isVisible(), false);
}

async function checkPoses(page, expected) {
  for (const { t, poses } of expected) {
    const seen = await page.evaluate((time) => {
      const { kanexpr } = window;
      kanexpr.seek(time);
      const poses = kanexpr.shapes.map((name) => kanexpr.pose(name));
      return { time: kanexpr.time, poses, names: kanexpr.shapes };
    }, t);
    assert.equal(seen.time, t);
    for (const { name, position, axes, vector } of poses) {
      const pose = seen.poses[seen.names.indexOf(name)];
      assertNear(pose.position, position, `${name} at ${t}`);
      if (vector) {
        const length = Math.hypot(...vector);
        assertNear(turned(pose.quaternion, [0, 0, 1]), vector.map((x) => x / length), `${name} at ${t}`);
      }
      axes?.forEach((axis, i) => {
        const unit = [0, 0, 0];
        unit[i] = 1;
        assertNear(turned(pose.quaternion, unit), axis, `axis ${i} of ${name} at ${t}`);
      });
    }
  }
}

/// The boxes around the wedges, from the files of all kinds.
async function checkMeshes(page) {
  for (const { t, poses } of expected) {
    const meshes = poses.filter((pose) => pose.corners);
    assert.equal(meshes.length, 5);
    const seen = await page.evaluate(([time, names]) => {
      window.kanexpr.seek(time);
      return names.map((name) => window.kanexpr.measure(name));
    }, [t, meshes.map((mesh) => mesh.name)]);
    meshes.forEach(({ name, corners }, k) => {
      const along = [0, 1, 2].map((i) => corners.map((corner) => corner[i]));
      assert.equal(seen[k].triangles, 4, name);
      assertNear(seen[k].least, along.map((values) => Math.min(...values)), `the least of ${name} at ${t}`);
      assertNear(seen[k].most, along.map((values) => Math.max(...values)), `the most of ${name} at ${t}`);
    });
  }
}

/// Halfway between two samples things are halfway.
async function checkBetween(page) {
  const [before, middle, after] = await page.evaluate(() =>
    [0.52, 0.53, 0.54].map((t) => {
      window.kanexpr.seek(t);
      return window.kanexpr.pose('rod from Dmc to Beside').position;
    }));
  assertNear(middle, before.map((value, i) => (value + after[i]) / 2), 'halfway');
  assert.ok(Math.hypot(...middle.map((value, i) => value - before[i])) > 1e-3);
}

/// The share of the points of the picture that something is drawn on, and the number of their colours.
function drawn(page, t) {
  return page.evaluate((time) => {
    window.kanexpr.seek(time);
    const source = document.querySelector('#view canvas');
    const copy = document.createElement('canvas');
    Object.assign(copy, { width: source.width, height: source.height });
    const paper = copy.getContext('2d');
    paper.drawImage(source, 0, 0);
    const points = new Uint32Array(paper.getImageData(0, 0, copy.width, copy.height).data.buffer);
    const solid = points.filter((point) => point >>> 24 > 200);
    return { share: solid.length / points.length, colours: new Set(solid).size };
  }, t);
}

async function checkPicture(page) {
  const pictures = [];
  for (const t of [0, 1.4]) {
    const { share, colours } = await drawn(page, t);
    assert.ok(share > 0.02 && share < 0.8, `the picture covers ${share}`);
    assert.ok(colours > 200, `the picture has ${colours} colours`);
    pictures.push(await page.screenshot());
  }
  assert.notDeepEqual(pictures[0], pictures[1]);
}

async function checkScrubbing(page) {
  await page.locator('#time').fill('4.5');
  assert.equal(await page.evaluate(() => window.kanexpr.time), 4.5);
  await page.waitForFunction(() => document.getElementById('clock').textContent === '4.50 / 6.00 s');
  assert.equal(await page.locator('#time').getAttribute('aria-valuetext'), '4.50 seconds');
}

async function checkKeys(page) {
  const time = () => page.evaluate(() => window.kanexpr.time);
  await page.keyboard.press('Home');
  assert.equal(await time(), 0);
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await time()) - 0.06) < 1e-9);
  await page.keyboard.press('End');
  assert.equal(await time(), 6);
}

async function checkPlaying(page) {
  const state = () => page.evaluate(() => [window.kanexpr.playing, window.kanexpr.time]);
  assert.deepEqual(await state(), [false, 6]);
  await page.keyboard.press(' '); // at the end: from the beginning
  await page.waitForFunction(() => {
    const { playing, time } = window.kanexpr;
    return playing && time > 0.1 && time < 5;
  });
  await page.getByRole('button', { name: 'Pause' }).click();
  const [playing, time] = await state();
  assert.equal(playing, false);
  await page.waitForTimeout(150);
  assert.deepEqual(await state(), [false, time]);
  await page.getByRole('button', { name: 'Play' }).waitFor();
}

async function checkResizing(page) {
  await page.setViewportSize({ width: 420, height: 500 });
  await page.waitForFunction(() => document.querySelector('#view canvas').clientWidth === 420);
  assert.ok((await drawn(page, 2)).share > 0.01);
}

/// It plays by itself, unless the reader wants less motion.
async function checkMotionByItself(page) {
  assert.equal(await page.evaluate(() => window.kanexpr.playing), false);
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await page.reload();
  await page.waitForFunction(() => window.kanexpr.playing && window.kanexpr.time > 0);
}

/// They are told, and the wedge is seen, in the colour of its file.
async function checkBrokenMeshes(context) {
  const page = await context.newPage();
  const requests = [];
  page.on('request', (request) => requests.push(request.url()));
  await page.goto(addressOf('broken.html'));
  assert.equal(await page.locator('#trouble').textContent(),
    'These files cannot be shown: cut.stl, vast.stl, words.stl, entities.dae, robot.dae, cut.dae, ' +
    'points.obj, odd.obj.');
  const [whole, none] = await page.evaluate(() => ['DAE', 'cut.stl'].map((name) => window.kanexpr.measure(name)));
  assert.deepEqual([whole.triangles, none.triangles], [4, 0]);
  const green = await page.evaluate(() => {
    window.kanexpr.seek(0);
    const source = document.querySelector('#view canvas');
    const paper = new OffscreenCanvas(source.width, source.height).getContext('2d');
    paper.drawImage(source, 0, 0);
    const points = paper.getImageData(0, 0, source.width, source.height).data;
    let count = 0;
    for (let i = 0; i < points.length; i += 4)
      if (points[i + 1] > 60 && points[i + 1] > 2 * Math.max(points[i], points[i + 2])) ++count;
    return (4 * count) / points.length;
  });
  assert.ok(green > 0.005, `${green} of the picture is green`);
  assert.deepEqual(requests.filter((url) => !url.startsWith('data:')), [addressOf('broken.html')]);
  await page.close();
}

async function checkWithoutWebGL(context) {
  const page = await context.newPage();
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(address);
  assert.match(await page.locator('#trouble').innerText(), /^This browser does not support WebGL/);
  await page.locator('#time').fill('1.4');
  await page.waitForFunction(() => document.getElementById('clock').textContent.startsWith('1.40'));
}
