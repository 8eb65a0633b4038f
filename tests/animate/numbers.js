// Numbers of poses.
import assert from 'node:assert/strict';

/// A vector turned by the quaternion x, y, z, w.
export function turned([x, y, z, w], [a, b, c]) {
  const t = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [
    a + w * t[0] + y * t[2] - z * t[1],
    b + w * t[1] + z * t[0] - x * t[2],
    c + w * t[2] + x * t[1] - y * t[0],
  ];
}

export function assertNear(actual, wanted, what) {
  const near = wanted.every((value, i) => Math.abs(actual[i] - value) < 2e-6);
  assert.ok(near, `${what}: ${actual} not ${wanted}`);
}
