// The surfaces of sweeps and cables, straight and bent to arcs.
import assert from 'node:assert/strict';

const accuracy = 1.5e-3; // of the length; a curve is drawn in at least 48 steps

function assertClose(actual, wanted, what) {
  wanted.forEach((value, i) => assert.ok(Math.abs(actual[i] - value) < accuracy, `${what}: ${actual} not ${wanted}`));
}

/// A bent shape keeps its volume, because the centers of the profiles are in the neutral plane (Pappus); it is
/// positive if all triangles face outward. Its extent is that of the arc.
export async function checkSweeps(page, expected) {
  for (const { name, volume, extents, unevenness = accuracy } of expected) {
    const seen = await page.evaluate((of) => [0, 1, 2].map((t) => {
      window.kanexpr.seek(t);
      return window.kanexpr.measure(of);
    }), name);
    seen.forEach((measured, k) => {
      const what = `${name} at ${k}`;
      assert.ok(Math.abs(measured.volume / volume - 1) < unevenness, `${what}: ${measured.volume} not ${volume}`);
      if (!extents[k]) return;
      assertClose(measured.least, extents[k].least, `the least of ${what}`);
      assertClose(measured.most, extents[k].most, `the most of ${what}`);
    });
  }
}
