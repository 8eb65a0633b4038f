// Solids along curves that bend: sweeps and cables.
import { Box3, BufferAttribute, BufferGeometry, Mesh, ShapeUtils, Sphere, Vector2, Vector3 } from 'three';
import { Curve } from './curve.js';
import { material } from './materials.js';
import { outlines } from './profiles.js';

const normal = new Vector3();
const upward = new Vector3();

/// The indices of the triangles: a tube from ring to ring, and two ends. The vertices of the ends follow those of
/// the tube.
function trianglesOf(outline, rings) {
  const triangles = [];
  const count = outline.flat().length; // vertices of a ring
  for (let ring = 0; ring + 1 < rings; ++ring) {
    let at = ring * count;
    for (const strip of outline) {
      for (let k = 0; k + 1 < strip.length; ++k, ++at)
        triangles.push(at, at + 1, at + count + 1, at, at + count + 1, at + count);
      ++at;
    }
  }
  const contour = outline.flatMap((strip) => strip.slice(0, -1));
  const faces = ShapeUtils.triangulateShape(contour.map(([x, y]) => new Vector2(x, y)), []);
  const start = rings * count;
  for (const [a, b, c] of faces) triangles.push(start + a, start + c, start + b);
  for (const [a, b, c] of faces) triangles.push(...[a, b, c].map((k) => start + contour.length + k));
  return { triangles, contour: contour.length };
}

/// The fraction of the length of the curve at each ring.
function fractionsOf({ centers }) {
  const lengths = [0];
  for (let i = 1; i < centers.length; ++i) lengths.push(lengths[i - 1] + centers[i].distanceTo(centers[i - 1]));
  const whole = lengths.at(-1);
  return { whole, fractions: lengths.map((length, i) => (whole > 0 ? length / whole : i / (lengths.length - 1))) };
}

/// Five numbers for each vertex of each ring: its place x, y in the profile, and its normal along x, y and the
/// tangent. They do not change while the curve bends.
function verticesOf(first, last, curve) {
  const { whole, fractions } = fractionsOf(curve);
  const [starts, ends] = [first.flat(), last.flat()];
  const numbers = new Float32Array(5 * curve.rings * starts.length);
  let at = 0;
  for (const part of fractions)
    starts.forEach((start, k) => {
      const [x, y, across, up] = start.map((value, i) => value + part * (ends[k][i] - value));
      const widening = whole > 0
        ? ((ends[k][0] - start[0]) * across + (ends[k][1] - start[1]) * up) / whole : 0;
      const length = Math.hypot(across, up, widening) || 1;
      numbers.set([x, y, across / length, up / length, -widening / length], at);
      at += 5;
    });
  return numbers;
}

/// A shape through several places. The mesh is at the first of them, in inertial axes.
export function sweep(shape, colour) {
  const { first, last } = outlines(shape.profile, shape.sizes);
  const curve = new Curve(shape.anchors, shape.placed === 'pose', shape.straight);
  const count = first.flat().length;
  const { triangles, contour } = trianglesOf(first, curve.rings);
  const vertices = curve.rings * count + 2 * contour;
  const positions = new BufferAttribute(new Float32Array(3 * vertices), 3);
  const normals = new BufferAttribute(new Float32Array(3 * vertices), 3);
  const reach = Math.max(...[...first.flat(), ...last.flat()].map(([x, y]) => Math.hypot(x, y)));
  const geometry = new BufferGeometry().setIndex(triangles)
    .setAttribute('position', positions).setAttribute('normal', normals);
  Object.assign(geometry, { boundingBox: new Box3(), boundingSphere: new Sphere() });
  const object = new Mesh(geometry, material(colour, shape.opacity));
  let local;

  function placeRing(ring, origin) {
    const tangent = curve.tangents[ring];
    const across = curve.across[ring];
    const center = curve.centers[ring].sub(origin);
    upward.crossVectors(tangent, across);
    for (let k = ring * count, at = 5 * k; k < (ring + 1) * count; ++k, at += 5) {
      normal.copy(across).multiplyScalar(local[at]).addScaledVector(upward, local[at + 1]).add(center);
      normal.toArray(positions.array, 3 * k);
      normal.copy(across).multiplyScalar(local[at + 2]).addScaledVector(upward, local[at + 3])
        .addScaledVector(tangent, local[at + 4]).toArray(normals.array, 3 * k);
    }
    geometry.boundingBox.expandByPoint(center);
  }

  /// Copies the contour of a ring to the vertices of an end, whose normal is along the tangent.
  function placeEnd(ring, start, sign) {
    normal.copy(curve.tangents[ring]).multiplyScalar(sign);
    let from = ring * count;
    let to = start;
    for (const strip of first) {
      for (let k = 0; k + 1 < strip.length; ++k, ++from, ++to) {
        positions.array.copyWithin(3 * to, 3 * from, 3 * from + 3);
        normal.toArray(normals.array, 3 * to);
      }
      ++from;
    }
  }

  object.show = () => {
    curve.update();
    local ??= verticesOf(first, last, curve);
    object.position.copy(curve.places[0]);
    geometry.boundingBox.makeEmpty();
    for (let ring = 0; ring < curve.rings; ++ring) placeRing(ring, object.position);
    placeEnd(0, curve.rings * count, -1);
    placeEnd(curve.rings - 1, curve.rings * count + contour, 1);
    geometry.boundingBox.expandByScalar(reach).getBoundingSphere(geometry.boundingSphere);
    positions.needsUpdate = true;
    normals.needsUpdate = true;
  };
  return object;
}
