// Interpolation between the samples.
import { Quaternion, Vector3 } from 'three';

/// The last sample at or before a time, and the fraction of the interval to the next one, from 0 to 1.
export function moment(times, t) {
  let low = 0;
  let high = times.length - 1;
  if (t >= times[high]) return { index: high, part: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return { index: low, part: Math.max(0, (t - times[low]) / (times[low + 1] - times[low])) };
}

export function between(values, { index, part }) {
  return part === 0 ? values[index] : values[index] + part * (values[index + 1] - values[index]);
}

export function placeBetween(rows, stride, first, { index, part }, result = new Vector3()) {
  const at = index * stride + first;
  result.fromArray(rows, at);
  return part === 0 ? result : result.lerp(next.fromArray(rows, at + stride), part);
}

export function turnBetween(rows, stride, first, { index, part }, result = new Quaternion()) {
  const at = index * stride + first;
  result.fromArray(rows, at).normalize();
  return part === 0 ? result : result.slerp(nextTurn.fromArray(rows, at + stride).normalize(), part);
}

const next = new Vector3();
const nextTurn = new Quaternion();
