// What the controls of the page do.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { assertNear, turned } from './numbers.js';

const seek = (page, t) => page.evaluate((time) => window.kanexpr.seek(time), t);
const timeOf = (page) => page.evaluate(() => window.kanexpr.time);
const button = (page, name) => page.getByRole('button', { name, exact: true });

export async function checkControls(page, expected) {
  await page.setViewportSize({ width: 900, height: 600 });
  await checkPanels(page);
  await checkValues(page, expected);
  await checkPlots(page);
  await checkLayers(page);
  await checkNames(page);
  await checkLoop(page);
  await checkSpeed(page);
  await checkFrames(page);
  await checkVideo(page);
  await checkKeyboard(page);
}

/// Opens a panel with the pointer or the keyboard.
async function open(page, name, key) {
  const one = button(page, name);
  if (key) {
    await one.focus();
    await page.keyboard.press(key);
  } else {
    await one.click();
  }
  assert.equal(await one.getAttribute('aria-expanded'), 'true');
  assert.ok(await page.getByRole('region', { name, exact: true }).isVisible(), name);
}

/// One panel at a time is over the picture, and plots are below it.
async function checkPanels(page) {
  const isOpen = async (name) => (await button(page, name).getAttribute('aria-expanded')) === 'true';
  await open(page, 'Plots', 'Enter');
  for (const [name, key] of [['Show', ' '], ['Values'], ['Record', 'Enter']]) await open(page, name, key);
  assert.deepEqual(await Promise.all(['Show', 'Values', 'Plots', 'Record'].map(isOpen)), [false, false, true, true]);
  await button(page, 'Record').click();
  assert.ok(!(await isOpen('Record')) && !(await page.locator('#record-panel').isVisible()));
}

async function checkValues(page, expected) {
  await open(page, 'Values');
  const units = {
    q1: 'rad', q2: 'rad', q3: 'rad', u1: 'rad/s', u2: 'rad/s', u3: 'rad/s', 'kinetic energy': 'J',
    'potential energy': 'J', 'total energy': 'J', 'height of Dmc': 'm',
  };
  for (const { t, columns } of expected) {
    await seek(page, t);
    assert.equal(await page.locator('#values tr').count(), 1 + Object.keys(columns).length);
    for (const [name, value] of Object.entries(columns)) {
      const row = page.locator('#values tr', { has: page.getByRole('rowheader', { name, exact: true }) });
      const text = value === 0 ? '0' : value.toFixed(4);
      assert.deepEqual(await row.locator('td').allTextContents(), [text, units[name] ?? ''], name);
    }
  }
  await button(page, 'Values').click();
}

/// The share of a plot that curves of this colour cover.
function inked(page, index) {
  return page.locator('.chart canvas').nth(index).evaluate((canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) {
      const [least, most] = [Math.min(data[i], data[i + 1], data[i + 2]), Math.max(data[i], data[i + 1], data[i + 2])];
      if (data[i + 3] > 100 && most - least > 60) ++count;
    }
    return (4 * count) / data.length;
  });
}

async function checkPlots(page) {
  const charts = page.locator('.chart');
  await charts.first().waitFor();
  assert.equal(await charts.count(), 1);
  assert.equal(await charts.getAttribute('aria-label'), 'q1 [rad], q3 [rad] over time');
  assert.ok((await inked(page, 0)) > 1e-3);
  assert.deepEqual(await page.locator('#choices legend').allTextContents(),
    ['Coordinates', 'Speeds', 'Energies', 'Quantities']);

  await page.getByRole('checkbox', { name: 'kinetic energy [J]' }).check();
  assert.equal(await charts.count(), 2);
  assert.equal(await charts.nth(1).getAttribute('aria-label'), 'kinetic energy [J] over time');
  await page.getByRole('checkbox', { name: 'q3 [rad]' }).focus();
  await page.keyboard.press(' ');
  assert.equal(await charts.first().getAttribute('aria-label'), 'q1 [rad] over time');

  const boxOf = (chart) => page.locator('.u-over').nth(chart).boundingBox();
  const isMarked = async (chart, t) => {
    const box = await boxOf(chart);
    const { x } = await page.locator('.now').nth(chart).boundingBox();
    return Math.abs(x - box.x - (t / 6) * box.width) < 2;
  };
  const before = await timeOf(page);
  assert.ok(before > 0 && await isMarked(0, before) && await isMarked(1, before), 'the markers of new plots');
  for (const t of [0, 1.5, 6]) {
    await seek(page, t);
    assert.ok(await isMarked(0, t), `the marker at ${t}`);
  }
  const box = await boxOf(0);
  await page.mouse.click(box.x + 0.75 * box.width, box.y + 0.5 * box.height);
  assert.ok(Math.abs((await timeOf(page)) - 4.5) < 0.03);
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.25 * box.width, box.y + 0.5 * box.height, { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs((await timeOf(page)) - 1.5) < 0.03);
  await button(page, 'Plots').click();
}

function redness(page) {
  return page.evaluate(() => {
    window.kanexpr.seek(1.4);
    const source = document.querySelector('#view canvas');
    const paper = new OffscreenCanvas(source.width, source.height).getContext('2d');
    paper.drawImage(source, 0, 0);
    const { data } = paper.getImageData(0, 0, source.width, source.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i] > 150 && Math.max(data[i + 1], data[i + 2]) < 80) ++count;
    return count;
  });
}

/// Layers are off at first; the slider scales the arrows of all layers.
async function checkLayers(page) {
  await open(page, 'Show');
  const boxes = page.locator('#layers input');
  assert.deepEqual(await page.locator('#layers label').allTextContents(),
    ['Forces', 'Velocities', 'Frames', 'Angular velocities']);
  for (let i = 0; i < 4; ++i) assert.equal(await boxes.nth(i).isChecked(), false);
  assert.equal(await page.locator('#deflection-size').isVisible(), false);
  const before = await redness(page);
  await page.getByLabel('Forces', { exact: true }).focus();
  await page.keyboard.press(' ');
  assert.ok((await redness(page)) > before + 100, 'the force is drawn');
  const length = () => page.evaluate(() => {
    const { least, most } = window.kanexpr.measure('force at Dmc');
    return most[2] - least[2];
  });
  const short = await length();
  await page.getByLabel('Arrow length').focus();
  await page.keyboard.press('ArrowRight');
  await seek(page, 1.4);
  assert.ok(Math.abs((await length()) / short - 10 ** 0.1) < 1e-3);
  await page.getByLabel('Forces', { exact: true }).uncheck();
  assert.ok(Math.abs((await redness(page)) - before) < 20);
  await page.getByRole('button', { name: 'Reset view' }).click();
  await button(page, 'Show').click();
}

/// The slider of the deflections multiplies the displacement and the rotation of the station at x = 7/8 of the beam
/// x² q1 + x³ q2; pages without flexible bodies do not show it.
export async function checkDeflections(page) {
  await open(page, 'Show');
  const slider = page.getByLabel('Deflections');
  const stationAt = (t) => page.evaluate((time) => {
    window.kanexpr.seek(time);
    return window.kanexpr.pose('station');
  }, t);
  const [t, x] = [0.85, 7 / 8];
  const [q1, q2] = [0.2 * Math.sin(3 * t), 0.1 * Math.cos(8 * t)];
  const root = { x: Math.sin(0.45 * t) / 3, y: (2 * Math.sin(0.45 * t)) / 3, w: Math.cos(0.45 * t) };
  const rootTurn = [root.x, root.y, root.y, root.w];
  const slope = 2 * x * q1 + 3 * x * x * q2;
  for (const [steps, factor] of [[0, 1], [3, 10 ** 0.3]]) {
    await slider.focus();
    for (let i = 0; i < steps; ++i) await page.keyboard.press('ArrowRight');
    assert.equal(await slider.getAttribute('aria-valuetext'), `× ${Number(factor.toPrecision(2))}`);
    const { position, quaternion } = await stationAt(t);
    const place = turned(rootTurn, [x, factor * x * x * (q1 + x * q2), 0]);
    assertNear(position, [place[0] + t, place[1], place[2]], `the station at ${factor}`);
    const tangent = turned(rootTurn, [Math.cos(factor * slope), Math.sin(factor * slope), 0]);
    assertNear(turned(quaternion, [0, 0, 1]), tangent, `the axis of the station at ${factor}`);
  }
  await button(page, 'Show').click();
}

/// The name of the shape under the pointer.
async function checkNames(page) {
  const name = page.locator('#name');
  const { names, width, height } = await page.evaluate(() => ({
    names: window.kanexpr.shapes, width: innerWidth, height: innerHeight,
  }));
  const seen = new Set();
  for (let row = 0.3; row < 0.7; row += 0.05) {
    await page.mouse.move(0.5 * width, row * height);
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
    if (await name.isVisible()) seen.add(await name.textContent());
  }
  assert.ok(seen.size > 0 && [...seen].every((text) => names.includes(text)), [...seen].join(', '));
  await page.mouse.move(5, 0.5 * height);
  await page.waitForFunction(() => document.getElementById('name').hidden);
}

async function checkLoop(page) {
  const loop = button(page, 'Loop');
  await page.keyboard.press('l');
  assert.equal(await loop.getAttribute('aria-pressed'), 'true');
  await seek(page, 5.9);
  await button(page, 'Play').click();
  await page.waitForFunction(() => window.kanexpr.playing && window.kanexpr.time < 3);
  await button(page, 'Pause').click();
  await loop.click();
  assert.equal(await loop.getAttribute('aria-pressed'), 'false');
}

async function checkSpeed(page) {
  await seek(page, 0);
  const elapsed = (speed) => page.evaluate(async (value) => {
    const select = document.getElementById('speed');
    select.value = value;
    select.dispatchEvent(new Event('change'));
    window.kanexpr.play();
    const frame = () => new Promise(requestAnimationFrame);
    await frame();
    const [from, start] = [window.kanexpr.time, performance.now()];
    while (performance.now() - start < 300) await frame();
    const passed = window.kanexpr.time - from;
    window.kanexpr.pause();
    return passed / ((performance.now() - start) / 1000);
  }, speed);
  const slow = await elapsed('0.1');
  assert.ok(slow > 0 && slow < 0.2, `0.1x plays at ${slow}`);
  await page.getByLabel('Playback speed').selectOption('10×');
  await button(page, 'Play').click();
  await page.waitForFunction(() => !window.kanexpr.playing && window.kanexpr.time === 6);
}

/// The bytes of the file that a button saves.
async function saved(page, name) {
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, name).click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/// At ten times the speed and 15 frames per second, a frame every 2/3 s.
async function checkFrames(page) {
  await page.setViewportSize({ width: 660, height: 400 });
  await open(page, 'Record');
  await page.getByLabel('Frames per second').selectOption('15');
  await seek(page, 2);
  const { name, bytes } = await saved(page, 'Frames (PNG)');
  assert.equal(name, 'A_disc_on_a_circle_motion_script.zip');
  const starts = [];
  for (let at = 0; (at = bytes.indexOf('\x89PNG\r\n', at, 'latin1')) >= 0; ++at) starts.push(at);
  assert.equal(starts.length, 10);
  assert.ok(bytes.includes('A_disc_on_a_circle_motion_script_01.png'));
  const size = await page.evaluate(() => {
    const { width, height } = document.querySelector('#view canvas');
    return [width - (width % 2), height - (height % 2)];
  });
  assert.deepEqual([bytes.readUInt32BE(starts[0] + 16), bytes.readUInt32BE(starts[0] + 20)], size);
  const length = starts[1] - starts[0] - 200; // without the header of the next file
  const [first, sixth] = [starts[0], starts[5]].map((start) => bytes.subarray(start, start + length));
  assert.ok(!first.equals(sixth));
  assert.equal(await page.locator('#progress').textContent(), `Saved 10 frames in ${name}.`);
  assert.equal(await timeOf(page), 2);

  await page.getByLabel('Playback speed').selectOption('0.05×');
  await button(page, 'Frames (PNG)').click();
  await button(page, 'Stop').dispatchEvent('click');
  await page.waitForFunction(() => document.getElementById('progress').textContent === 'Stopped.');
}

/// A browser can play the video, which has the size of the picture.
async function checkVideo(page) {
  await page.getByLabel('Playback speed').selectOption('4×');
  const { name, bytes } = await saved(page, 'Video (WebM)');
  assert.equal(name, 'A_disc_on_a_circle_motion_script.webm');
  assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3);
  const player = await page.context().newPage();
  const played = await player.evaluate(async (source) => {
    const video = Object.assign(document.createElement('video'), { src: source, muted: true });
    await new Promise((resolve, reject) => {
      video.addEventListener('loadeddata', resolve);
      video.addEventListener('error', () => reject(video.error));
    });
    return [video.videoWidth, video.videoHeight];
  }, `data:video/webm;base64,${bytes.toString('base64')}`);
  await player.close();
  const size = await page.evaluate(() => {
    const { width, height } = document.querySelector('#view canvas');
    return [width - (width % 2), height - (height % 2)];
  });
  assert.deepEqual(played, size);
  await page.getByLabel('Playback speed').selectOption('1×');
  await button(page, 'Record').click();
}

/// The Tab key reaches every control.
async function checkKeyboard(page) {
  await page.locator('#view').focus();
  const reached = new Set();
  for (let i = 0; i < 12; ++i) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.textContent));
  }
  for (const one of ['play', 'time', 'speed', 'loop', 'Show', 'Values', 'Plots', 'Record'])
    assert.ok(reached.has(one), one);
}

/// Two runs of different length.
export async function checkRuns(page) {
  const names = ['leans to the left', 'leans to the right'];
  assert.deepEqual(await page.locator('#runs label').allTextContents(), names);
  assert.equal(await page.evaluate(() => document.getElementById('time').max), '6');
  await open(page, 'Values');
  await seek(page, 5);
  const row = page.locator('#values tr', { has: page.getByRole('rowheader', { name: 'q1', exact: true }) });
  assert.deepEqual(await row.locator('td').allTextContents(), ['4.0000', '−2.0000', 'rad']); // −0.5 · 4 s
  assert.deepEqual(await page.locator('#values-panel thead th').allTextContents(), ['', ...names, '']);

  await open(page, 'Plots');
  await page.locator('.chart').first().waitFor();
  const both = await inked(page, 0);
  const visible = () => page.evaluate(() => {
    window.kanexpr.seek(0.2);
    return document.querySelector('#view canvas').toDataURL();
  });
  const together = await visible();
  await page.getByLabel(names[1]).focus();
  await page.keyboard.press(' ');
  assert.ok((await inked(page, 0)) < 0.8 * both);
  assert.notEqual(await visible(), together);
  await page.getByLabel(names[1]).check();
  assert.equal(await visible(), together);
}
