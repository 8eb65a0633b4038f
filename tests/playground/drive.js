// node drive.js CHROMIUM PAGE FOLDER: uses the page without a network, and leaves in FOLDER what it takes away.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const [browserPath, file, folder] = process.argv.slice(2);
const address = pathToFileURL(file).href;
const home = mkdtempSync(join(tmpdir(), 'kanexpr-playground-'));
const crane = `# a cart and a load on a rope
parameter m1 = 2, m2 = 1, l = 1.5, g = 9.81
input F = 0
origin O
slider C from O along N.x by x = 0.2, v
pin A on N about N.z by theta = 0.7, omega
offset P from C by -l*A.y
particle Cart at C mass m1
particle Load at P mass m2
gravity -g*N.y
force F*N.x at C
`;

const context = await chromium.launchPersistentContext(home, {
  executablePath: browserPath,
  offline: true,
  acceptDownloads: true,
  viewport: { width: 1280, height: 800 },
  args: ['--no-sandbox', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});
context.setDefaultTimeout(60_000);

try {
  const size = statSync(file).size;
  assert.ok(size <= 4e6, `the page has ${size} bytes`);
  const page = await context.newPage();
  const troubles = listen(page);
  await page.goto(address);
  await page.waitForFunction(() => window.playground?.model);
  const { started, derived } = await page.evaluate(() => ({ started: window.playground.started, derived: window.playground.derived }));
  await checkExamples(page);
  await checkTyping(page);
  await checkPlaying(page);
  await checkDragging(page);
  await checkNumbers(page);
  await checkLinearization(page);
  await checkValues(page);
  await checkTakingAway(page);
  await checkMistakes(page);
  await checkForm(page);
  await checkPhone(page);
  await checkLink(page);
  await checkLinkWithMistake(page);
  await checkDamagedLink(page);
  await checkTooLarge(page);
  await checkNames(page);
  await checkBlowUp(page);
  assert.deepEqual(troubles, []);
  console.log(`${(size / 1e6).toFixed(2)} MB; the engine started in ${started.toFixed(0)} ms and derived the first model in ${derived.toFixed(1)} ms`);
} finally {
  await context.close();
  rmSync(home, { recursive: true, force: true });
}

/// Everything that the page says, and every request beyond the file itself.
function listen(page) {
  const troubles = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => {
    if (request.url().split('#')[0] !== address && request.url() !== 'about:blank' && !/^(data|blob):/.test(request.url())) troubles.push(request.url());
  });
  return troubles;
}

async function type(page, text) {
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+A');
  await page.keyboard.insertText(text);
}
function latexOf(page, name) {
  return page.locator(`#equations [data-latex^="${name} ="]`).getAttribute('data-latex');
}
function energy(page) {
  return page.evaluate(() => {
    const { kinetic, potential } = window.playground.engine.energy;
    return kinetic + potential;
  });
}
function state(page) { return page.evaluate(() => [...window.playground.engine.state(4)]); }

async function checkExamples(page) {
  const titles = await page.locator('#example option').allTextContents();
  assert.ok(titles.length >= 5);
  for (const title of titles) {
    await page.selectOption('#example', title);
    assert.match(await page.locator('#mistake').textContent(), /^derived in/, title);
    await page.locator('#stage svg text').first().waitFor();
    assert.ok((await page.locator('#equations .katex').count()) >= 3, title);
    const before = await energy(page);
    const after = await page.evaluate(() => {
      const { engine } = window.playground;
      const trouble = engine.advance(1, 1e-3);
      return trouble || engine.energy.kinetic + engine.energy.potential;
    });
    assert.ok(Math.abs(after - before) < 1e-6 * Math.abs(before), `${title}: ${before} to ${after}`);
  }
}

async function checkTyping(page) {
  await type(page, crane);
  await page.waitForFunction(() => window.playground.model.coordinates[1]?.name === 'theta');
  const mass = await latexOf(page, 'M');
  assert.match(mass, /m_1 \+ m_2/);
  assert.match(mass, /l m_2 \\cos \\theta/);
  assert.match(mass, /l\^\{2\} m_2/);
}

async function checkPlaying(page) {
  const before = await energy(page);
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction(() => window.playground.engine.time > 1);
  await page.getByRole('button', { name: 'Pause' }).click();
  assert.ok(Math.abs((await energy(page)) - before) < 1e-6 * Math.abs(before), 'energy');
  const after = await state(page);
  assert.ok(Math.abs(after[1] - 0.7) > 1e-3);
  await page.getByRole('button', { name: 'Back to the start' }).click();
  assert.deepEqual(await state(page), [0.2, 0.7, 0, 0]);
}

async function checkDragging(page) {
  const [x, y] = await page.evaluate(() => {
    const figure = document.querySelector('#stage svg');
    const [place] = window.playground.engine.points(3).slice(2);
    const { x, y } = new DOMPoint(...place).matrixTransform(figure.getScreenCTM());
    return [x, y];
  });
  await page.mouse.move(x, y);
  await page.locator('#stage .ring').waitFor();
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 10, { steps: 5 });
  await page.mouse.up();
  const [, theta] = await state(page);
  assert.ok(theta < 0.69, `theta is ${theta}`);
  await page.getByRole('button', { name: 'Back to the start' }).click();
}

async function checkNumbers(page) {
  await page.getByRole('button', { name: 'Numbers here' }).click();
  assert.match(await latexOf(page, 'M'), /3\.0000 & 1\.1473/);
  await page.getByRole('button', { name: 'Symbols', exact: true }).click();
}

async function checkLinearization(page) {
  await page.getByRole('tab', { name: 'Values' }).click();
  await page.getByLabel('theta, exactly').fill('0');
  await page.getByRole('tab', { name: 'Linearized' }).click();
  await page.getByRole('button', { name: 'Symbols here' }).click();
  assert.match(await latexOf(page, 'A'), /\\frac\{g m_2\}\{m_1\}/);
  assert.match(await latexOf(page, 'B'), /\\frac\{1\}\{m_1\}/);
}

async function checkValues(page) {
  await page.getByRole('tab', { name: 'Values' }).click();
  await page.getByLabel('F, exactly').fill('3');
  await page.getByRole('button', { name: 'Back to the start' }).click();
  assert.equal(await page.evaluate(() => window.playground.engine.inputs(1)[0]), 3);
  await page.getByLabel('F, exactly').fill('0');
}

async function checkTakingAway(page) {
  writeFileSync(join(folder, 'crane.txt'), crane);
  await page.getByRole('tab', { name: 'Take away' }).click();
  await page.locator('#name').fill('crane');
  for (const [button, name] of [['C++ types', 'crane.hpp'], ['C', 'crane_c.zip'], ['FMU', 'crane.fmu']]) {
    const waiting = page.waitForEvent('download');
    await page.getByRole('button', { name: button, exact: true }).click();
    const taken = await waiting;
    assert.equal(taken.suggestedFilename(), name);
    await taken.saveAs(join(folder, name));
  }
  assert.match(await page.locator('#words').textContent(), /struct Load : particle<Load, P, m2> \{\};/);
}

async function checkMistakes(page) {
  await type(page, crane.replace('at P', 'at Q'));
  await page.waitForFunction(() => document.querySelector('#mistake').classList.contains('wrong'));
  assert.equal(await page.locator('#mistake').textContent(), 'Line 9: unknown point Q');
  await page.locator('.cm-lintRange-error').first().waitFor();
  assert.equal(await page.evaluate(() => window.playground.model.points.length), 3); // the last model stays
  await type(page, `${crane}parameter d`);
  await page.waitForFunction(() => document.querySelector('#mistake').textContent.startsWith('Line 12'));
  assert.equal(await page.locator('#mistake').textContent(),
    'Line 12: parameter d is declared but not used in the system');
}

async function checkForm(page) {
  await type(page, crane);
  await page.getByRole('button', { name: '+ Load' }).click();
  await page.locator('#add').getByLabel('Kind').selectOption('spring');
  await page.locator('#add [data-slot=point]').nth(0).selectOption('C');
  await page.locator('#add [data-slot=point]').nth(1).selectOption('O');
  await page.locator('#add [data-slot=scalar]').nth(0).fill('20');
  await page.locator('#add [data-slot=scalar]').nth(1).fill('');
  await page.getByRole('button', { name: 'Add', exact: true }).click();
  assert.ok((await page.evaluate(() => window.playground.text)).endsWith('\nspring C to O stiffness 20\n'));
  await page.getByRole('tab', { name: 'Equations' }).click();
  await page.waitForFunction(() => window.playground.latex.includes('20 x'));
}

async function checkPhone(page) {
  for (const width of [390, 320]) {
    await page.setViewportSize({ width, height: 844 });
    await page.reload();
    await page.waitForFunction(() => window.playground?.model);
    assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth <= window.innerWidth), `${width} pixels are too narrow`);
    await page.getByRole('tab', { name: 'Model' }).click();
    assert.ok(await page.locator('.cm-content').isVisible());
    await page.getByRole('tab', { name: 'Equations' }).click();
    assert.ok(!(await page.locator('.cm-content').isVisible()));
    assert.ok(await page.locator('#equations .formula').first().isVisible());
  }
}

async function checkLink(page) {
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.reload();
  await page.waitForFunction(() => window.playground?.model);
  assert.ok((await page.evaluate(() => window.playground.text)).startsWith(crane)); // of the last visit
  const link = await page.evaluate((text) => window.playground.linkTo(text), crane.replace('0.7', '0.5'));
  await page.evaluate(() => localStorage.clear());
  await page.goto('about:blank');
  await page.goto(link);
  await page.waitForFunction(() => window.playground?.model);
  assert.equal((await state(page))[1], 0.5);
}

function said(page) { return page.locator('#mistake').textContent(); }
function isStale(page) { return page.evaluate(() => document.body.classList.contains('stale')); }
function addressOf(page, text) { return page.evaluate((lines) => window.playground.linkTo(lines), text); }
async function open(page, link) {
  await page.evaluate(() => localStorage.clear());
  await page.goto('about:blank');
  await page.goto(link);
  await page.waitForFunction(() => window.playground?.model);
}

async function checkLinkWithMistake(page) {
  const wrong = crane.replace('at P', 'at Q');
  await open(page, await addressOf(page, wrong));
  assert.equal(await page.evaluate(() => window.playground.text), wrong);
  assert.equal(await said(page), 'Line 9: unknown point Q');
  assert.ok(await isStale(page));
  const other = await addressOf(page, crane.replace('0.7', '0.3'));
  await page.evaluate((to) => { location.href = to; }, other); // in the same tab
  await page.waitForFunction(() => window.playground.text.includes('0.3'));
  assert.match(await said(page), /^derived in/);
}

async function checkDamagedLink(page) {
  const link = await addressOf(page, crane);
  for (const damaged of [`${link.split('#')[0]}#AAAA`, link.slice(0, -20), `${link.split('#')[0]}#%%%`]) {
    await open(page, damaged);
    assert.equal(await said(page), 'this link is damaged, and its model cannot be read');
  }
  await page.evaluate((text) => { window.playground.text = text; }, `${crane}\0parameter d`);
  assert.match(await said(page), /^Line 12: unknown word ␀/);
}

/// A large model is refused, or derived; in each case the next one is as on a fresh page, also after a trap.
async function checkTooLarge(page) {
  await page.evaluate((text) => { window.playground.text = text; }, crane);
  const before = await page.evaluate(() => window.playground.engine.equations(false, 'symbols'));
  const nested = `${crane}force ${'('.repeat(132)}m1${')'.repeat(132)}*N.x at P\n`;
  await page.evaluate((text) => { window.playground.text = text; }, nested);
  assert.equal(await said(page), 'Line 12: the expression is nested more than 100 levels deep');
  const powers = Array.from({ length: 200 }, (_, i) => `x^${i + 2}`).join(' + ');
  for (const term of [`(${powers})`, `${'sin('.repeat(99)}x${')'.repeat(99)}`, `(${'x + '.repeat(900)}x)`]) {
    await page.evaluate((text) => { window.playground.text = text; }, `${crane}force ${term}*N.x at P\n`);
    assert.match(await said(page), /^derived in|^this model is too large for this page$/);
    await page.evaluate((text) => { window.playground.text = text; }, crane);
    assert.match(await said(page), /^derived in/);
    assert.deepEqual(await page.evaluate(() => window.playground.engine.equations(false, 'symbols')), before);
  }
  const trap = await page.evaluate(() => { // beyond the memory of the engine
    try { return window.playground.engine.drag(1e8, 0, 0); } catch (error) { return error.message; }
  });
  assert.equal(trap, 'this model is too large for this page');
  assert.deepEqual(await page.evaluate(() => window.playground.engine.equations(false, 'symbols')), before);
}

async function checkNames(page) {
  await page.getByRole('tab', { name: 'Take away' }).click();
  for (const [name, expected] of [['class', 'class_'], ['9lives', 'n9lives'], ['_my crane_', 'my_crane']]) {
    await page.locator('#name').fill(name);
    assert.ok((await page.locator('#words').textContent()).includes(`namespace ${expected} {`), name);
  }
}

async function checkBlowUp(page) {
  await page.evaluate((text) => { window.playground.text = text; },
    crane.replace('v\n', 'v = 100\n').replace('force F*N.x', 'force 1e6*v^3*N.x').replace('input F = 0\n', ''));
  await page.getByRole('button', { name: 'Play' }).click();
  await page.waitForFunction(() => document.querySelector('#mistake').textContent.startsWith('The motion ended'));
  await page.locator('#name').fill('crane');
  assert.match(await page.locator('#taken').textContent(), /^the value of \w+ is not finite; go back to the start$/);
  await page.getByRole('button', { name: 'Back to the start' }).click();
  assert.match(await said(page), /^derived in/);
  assert.match(await page.locator('#words').textContent(), /initial_state\{\{x, 0\.2\}/);
}
