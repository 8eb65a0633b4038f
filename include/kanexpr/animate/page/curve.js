// A smooth curve through places that move, with straight parts. Nothing is allocated while it moves.
import { Quaternion, Vector3 } from 'three';

const first = new Vector3();
const second = new Vector3();
const along = new Vector3();
const turn = new Quaternion();

/// Adds a chord divided by its squared length, which points along the circle through three points.
function addInverse(sum, chord) {
  const square = chord.lengthSq();
  return square > 0 ? sum.addScaledVector(chord, 1 / square) : sum;
}

/// The rings of a curve: their centers, their tangents, and the x axes of their profiles, which are perpendicular
/// to the tangents. Part i between the places i and i + 1 is straight if `straight` contains i.
export class Curve {
  constructor(anchors, hasAxes, straight = []) {
    const vectors = (count) => Array.from({ length: count }, () => new Vector3());
    const count = anchors.length;
    this.steps = Math.max(4, Math.ceil(48 / (count - 1))); // between two places
    this.rings = this.steps * (count - 1) + 1;
    this.anchors = anchors;
    this.hasAxes = hasAxes;
    this.straight = new Set(straight);
    this.places = vectors(count);
    this.directions = vectors(count);
    this.turns = hasAxes ? anchors.map(() => new Quaternion()) : [];
    this.centers = vectors(this.rings);
    this.tangents = vectors(this.rings);
    this.across = vectors(this.rings);
  }

  /// Moves the rings to the places of the anchors.
  update() {
    for (let i = 0; i < this.places.length; ++i) this.anchors[i].position(this.places[i]);
    if (this.hasAxes) this.#readAxes();
    else this.#findDirections();
    this.tangents[0].copy(this.directions[0]);
    this.#startAcross();
    for (let i = 0; i + 1 < this.places.length; ++i) this.#interpolate(i);
  }

  #readAxes() {
    for (let i = 0; i < this.places.length; ++i) {
      this.anchors[i].turn(this.turns[i]);
      this.directions[i].set(0, 0, 1).applyQuaternion(this.turns[i]);
    }
  }

  /// The direction at a point is that of the circle through it and its neighbours; the first and the last part
  /// of the curve are arcs.
  #findDirections() {
    const { places, directions } = this;
    const last = places.length - 1;
    for (let i = 1; i < last; ++i) {
      const sum = directions[i].set(0, 0, 0);
      addInverse(sum, first.subVectors(places[i], places[i - 1]));
      addInverse(sum, second.subVectors(places[i + 1], places[i]));
      if (sum.lengthSq() > 0) sum.normalize();
      else sum.set(0, 0, 1);
    }
    this.#endInArc(directions[0], places[0], places[1], last > 1 ? directions[1] : undefined);
    this.#endInArc(directions[last], places[last - 1], places[last], last > 1 ? directions[last - 1] : undefined);
    this.#joinStraightParts();
  }

  /// The direction at the end of a straight part is along this part. Between two of them, where the curve has a
  /// corner, it is midway.
  #joinStraightParts() {
    const { places, directions, straight } = this;
    for (const i of straight) {
      first.subVectors(places[i + 1], places[i]);
      if (first.lengthSq() === 0) continue;
      first.normalize();
      if (straight.has(i - 1) && second.addVectors(first, along).lengthSq() > 0.01) directions[i].copy(second).normalize();
      else directions[i].copy(first);
      directions[i + 1].copy(first);
      along.copy(first);
    }
  }

  /// Reflects the direction at the other end of the part about its chord.
  #endInArc(direction, from, to, other) {
    first.subVectors(to, from);
    if (first.lengthSq() > 0) first.normalize();
    else first.set(0, 0, 1);
    if (other) direction.copy(first).multiplyScalar(2 * first.dot(other)).sub(other);
    else direction.copy(first);
  }

  #startAcross() {
    const across = this.across[0];
    if (this.hasAxes) across.set(1, 0, 0).applyQuaternion(this.turns[0]);
    else across.set(Math.abs(this.tangents[0].x) < 0.8 ? 1 : 0, 0.6, 0);
    this.#straighten(across, this.tangents[0]);
  }

  #straighten(across, tangent) {
    across.addScaledVector(tangent, -across.dot(tangent)).normalize();
  }

  /// The cubic polynomial with the given places and directions at both ends. The lengths of its derivatives are
  /// such that it follows an arc, except for terms of sixth order in the angle.
  #interpolate(i) {
    if (this.straight.has(i)) return this.#interpolateLinearly(i);
    const { places, directions, steps } = this;
    const chord = first.subVectors(places[i + 1], places[i]).length();
    const cosine = Math.max(-1, Math.min(1, directions[i].dot(directions[i + 1])));
    const speed = (2 * chord) / (1 + Math.sqrt((1 + cosine) / 2));
    for (let k = i === 0 ? 0 : 1; k <= steps; ++k) {
      const u = k / steps;
      const ring = i * steps + k;
      this.centers[ring].copy(places[i]).multiplyScalar((1 + 2 * u) * (1 - u) ** 2)
        .addScaledVector(places[i + 1], u * u * (3 - 2 * u))
        .addScaledVector(directions[i], speed * u * (1 - u) ** 2)
        .addScaledVector(directions[i + 1], speed * u * u * (u - 1));
      const tangent = this.tangents[ring].subVectors(places[i + 1], places[i]).multiplyScalar(6 * u * (1 - u))
        .addScaledVector(directions[i], speed * (1 - u) * (1 - 3 * u))
        .addScaledVector(directions[i + 1], speed * u * (3 * u - 2));
      if (tangent.lengthSq() > 0) tangent.normalize();
      else tangent.copy(directions[i]);
      this.#turnProfile(ring, i, u);
    }
  }

  #interpolateLinearly(i) {
    const { places, directions, steps } = this;
    for (let k = i === 0 ? 0 : 1; k <= steps; ++k) {
      const ring = i * steps + k;
      this.centers[ring].lerpVectors(places[i], places[i + 1], k / steps);
      const tangent = this.tangents[ring];
      if (k === steps) tangent.copy(directions[i + 1]);
      else tangent.subVectors(places[i + 1], places[i]).normalize();
      this.#turnProfile(ring, i, k / steps);
    }
  }

  /// The profile rotates uniformly between two places with axes, else as little as possible.
  #turnProfile(ring, i, u) {
    const across = this.across[ring];
    if (this.hasAxes) across.set(1, 0, 0).applyQuaternion(turn.slerpQuaternions(this.turns[i], this.turns[i + 1], u));
    else if (ring > 0) across.copy(this.across[ring - 1]);
    this.#straighten(across, this.tangents[ring]);
  }
}
