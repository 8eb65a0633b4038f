// Where things are on the page, on screens of all sizes, and its colours.
import assert from 'node:assert/strict';

const panels = ['Show', 'Values', 'Plots', 'Record'];

/// The boxes of all parts of the page, with each panel open in turn.
function boxes(page) {
  return page.evaluate((names) => {
    const box = (element) => {
      const { left, right, top, bottom } = element.getBoundingClientRect();
      return { id: element.id || element.textContent, left, right, top, bottom };
    };
    const all = (selector) => [...document.querySelectorAll(selector)].filter((one) => one.offsetParent).map(box);
    return names.map((name) => {
      const button = [...document.querySelectorAll('footer button')].find((one) => one.textContent === name);
      button.click();
      const found = {
        name,
        title: box(document.getElementById('title')),
        panels: all('.panel, #plots-panel, footer'),
        controls: all('footer button, footer input, footer select, footer output'),
        size: [innerWidth, innerHeight],
        width: document.documentElement.scrollWidth,
      };
      button.click();
      return found;
    });
  }, panels);
}

function areApart(a, b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

/// Nothing covers the title, and everything is on the screen.
async function checkAllPanels(page, what) {
  for (const { name, title, panels: others, controls, size, width } of await boxes(page)) {
    assert.equal(others.length, 2, `${what}: ${name} and the player are open`);
    for (const other of others) assert.ok(areApart(title, other), `${what}: ${other.id} covers the title`);
    for (const one of controls)
      assert.ok(one.left >= 0 && one.top >= 0 && one.right <= size[0] + 0.5 && one.bottom <= size[1] + 0.5,
        `${what}: ${one.id} is not on the screen with ${name}`);
    assert.ok(width <= size[0], `${what}: the page is too wide with ${name}`);
  }
}

export async function checkLayout(page) {
  for (const [width, height] of [[1100, 700], [700, 500], [320, 568]]) {
    await page.setViewportSize({ width, height });
    await checkAllPanels(page, `${width}x${height}`);
  }
}

/// On a phone the picture is below the title, one panel is open at a time, and a touch shows a name.
export async function checkPhone(page) {
  await checkAllPanels(page, 'a phone');
  const boxOf = (id) => page.locator(`#${id}`).evaluate((one) => one.getBoundingClientRect().toJSON());
  const { left, top, width, height } = await boxOf('view');
  assert.ok((await boxOf('title')).bottom <= top);
  for (const name of panels) await page.getByRole('button', { name, exact: true }).tap();
  const open = page.locator('[aria-expanded="true"]');
  assert.deepEqual(await open.allTextContents(), ['Record']);
  await open.tap();

  await page.evaluate(() => window.kanexpr.seek(1.4));
  const name = page.locator('#name');
  for (let part = 0.3; part < 0.75 && !(await name.isVisible()); part += 0.05) {
    await page.touchscreen.tap(left + 0.5 * width, top + part * height);
    await page.waitForTimeout(100);
  }
  const names = await page.evaluate(() => window.kanexpr.shapes);
  assert.ok(names.includes(await name.textContent()));
}

/// The colours follow those of the system.
export async function checkColours(page, drawn) {
  const lightness = () => page.evaluate(() => {
    const [r, g, b] = getComputedStyle(document.querySelector('#loop')).backgroundColor.match(/[\d.]+/g).map(Number);
    const [x, y, z] = getComputedStyle(document.documentElement).color.match(/[\d.]+/g).map(Number);
    return [(r + g + b) / 765, (x + y + z) / 765];
  });
  const [paper, ink] = await lightness();
  assert.ok(paper > 0.9 && ink < 0.3);
  await page.emulateMedia({ colorScheme: 'dark' });
  const [darkPaper, darkInk] = await lightness();
  assert.ok(darkPaper < 0.3 && darkInk > 0.8);
  assert.ok((await drawn(page, 1)).share > 0.01);
  await page.emulateMedia({ colorScheme: 'light' });
}
