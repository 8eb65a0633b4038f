// The tracks of a motion, interpolated between the samples.
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

const next = new Vector3();
const nextTurn = new Quaternion();

/// The path of a point or the poses of a rigid body. `show` sets its position and orientation.
class Track {
  #rows;
  #stride;

  constructor({ turns, rows }) {
    this.#rows = rows;
    this.#stride = turns ? 7 : 3;
    this.position = new Vector3();
    this.turn = new Quaternion();
    this.show({ index: 0, part: 0 });
  }

  get isFixed() {
    return this.#rows.length === this.#stride;
  }

  /// The greatest length of the position, which is a vector.
  longest() {
    let most = 0;
    for (let at = 0; at < this.#rows.length; at += this.#stride)
      most = Math.max(most, Math.hypot(...this.#rows.slice(at, at + 3)));
    return most;
  }

  show({ index, part }) {
    const moves = !this.isFixed;
    const at = moves ? index * this.#stride : 0;
    this.position.fromArray(this.#rows, at);
    if (this.#stride === 7) this.turn.fromArray(this.#rows, at + 3).normalize();
    if (!moves || part === 0) return;
    this.position.lerp(next.fromArray(this.#rows, at + this.#stride), part);
    if (this.#stride === 7)
      this.turn.slerp(nextTurn.fromArray(this.#rows, at + this.#stride + 3).normalize(), part);
  }
}

const deflected = [0, 0, 0, 0, 0, 0];
const axis = new Vector3();

/// The poses of a station that bends relative to another track: its position and its rotation vector, in the axes
/// of that track, are a mean and a weighted sum of deflections.
class BentTrack {
  #base;
  #rows;
  #mean;
  #deflections;

  constructor(base, { rows }, { mean, deflections }) {
    this.#base = base;
    this.#rows = rows;
    this.#mean = mean;
    this.#deflections = deflections;
    this.position = new Vector3();
    this.turn = new Quaternion();
    this.show({ index: 0, part: 0 });
  }

  get isFixed() {
    return false;
  }

  show(now) {
    const { index, part } = now;
    this.#base.show(now);
    const count = this.#deflections.length;
    for (let i = 0; i < 6; ++i) deflected[i] = this.#mean[i];
    for (let k = 0; k < count; ++k) {
      const here = this.#rows[index * count + k];
      const weight = part === 0 ? here : here + part * (this.#rows[(index + 1) * count + k] - here);
      for (let i = 0; i < 6; ++i) deflected[i] += weight * this.#deflections[k][i];
    }
    this.position.fromArray(deflected).applyQuaternion(this.#base.turn).add(this.#base.position);
    const angle = axis.fromArray(deflected, 3).length();
    if (angle > 0) this.turn.setFromAxisAngle(axis.divideScalar(angle), angle);
    else this.turn.identity();
    this.turn.premultiply(this.#base.turn);
  }
}

/// The tracks of a run, those that bend among the others.
export function tracksOf(tracks, bendings) {
  const all = tracks.map((track) => track && new Track(track));
  for (const bending of bendings)
    for (const part of bending.parts) all[part.track] = new BentTrack(all[bending.base], bending, part);
  return all;
}

/// The factor by which the deformations of flexible bodies are drawn larger than they are.
export const deflections = { factor: 1 };

const straight = new Vector3();
const straightTurn = new Quaternion();

/// Multiplies the angle of a rotation.
function multiplyAngle(turn, factor) {
  const sine = Math.hypot(turn.x, turn.y, turn.z);
  if (sine === 0) return turn;
  const half = factor * Math.atan2(sine, Math.abs(turn.w));
  const part = (Math.sign(turn.w || 1) * Math.sin(half)) / sine;
  return turn.set(part * turn.x, part * turn.y, part * turn.z, Math.cos(half));
}

/// A point or a frame that is fixed in the body of a track. If the deformation of a flexible body moves it, there
/// is also an anchor at its undeformed place.
export class Anchor {
  #undeformed;

  constructor({ track, at = [0, 0, 0], turn = [0, 0, 0, 1], undeformed }, tracks) {
    this.track = tracks[track];
    this.at = new Vector3(...at);
    this.own = new Quaternion(...turn).normalize();
    this.#undeformed = undeformed && new Anchor(undeformed, tracks);
  }

  get isDeformed() {
    return this.#undeformed !== undefined;
  }
  get #isMagnified() {
    return this.isDeformed && deflections.factor !== 1;
  }

  position(result) {
    result.copy(this.at).applyQuaternion(this.track.turn).add(this.track.position);
    if (!this.#isMagnified) return result;
    this.#undeformed.position(straight);
    return result.sub(straight).multiplyScalar(deflections.factor).add(straight);
  }

  turn(result) {
    result.copy(this.track.turn).multiply(this.own);
    if (!this.#isMagnified) return result;
    this.#undeformed.turn(straightTurn).conjugate();
    multiplyAngle(result.premultiply(straightTurn), deflections.factor);
    return result.premultiply(straightTurn.conjugate());
  }
}
