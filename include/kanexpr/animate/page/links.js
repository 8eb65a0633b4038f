// Shapes between two points. They are built along z, starting at 0; `stretch` sets their length.
import { CatmullRomCurve3, Group, Mesh, SphereGeometry, TubeGeometry, Vector3 } from 'three';
import { material } from './materials.js';
import { alongZ } from './solids.js';

export function rod([radius], colour, opacity) {
  const link = new Group();
  const made = material(colour, opacity);
  const bar = new Mesh(alongZ(radius, 1, 32).translate(0, 0, 0.5), made);
  const ends = [0, 1].map(() => new Mesh(new SphereGeometry(radius, 32, 16), made));
  link.add(bar, ...ends);
  link.stretch = (length) => {
    bar.scale.z = Math.max(length, 1e-9 * radius); // a scale of zero has no inverse
    ends[1].position.z = length;
  };
  return link;
}

/// A wire wound about the z axis, from 0 to 1, whose ends lead to the axis.
function winding(radius, turns) {
  const points = [];
  const steps = Math.max(8, Math.round(24 * turns));
  const straight = 0.1;
  for (let i = 0; i <= steps; ++i) {
    const part = i / steps;
    const angle = 2 * Math.PI * turns * part;
    const along = straight + (1 - 2 * straight) * part;
    points.push(new Vector3(radius * Math.cos(angle), radius * Math.sin(angle), along));
  }
  points.unshift(new Vector3(0, 0, 0), new Vector3(0, 0, straight / 2));
  points.push(new Vector3(0, 0, 1 - straight / 2), new Vector3(0, 0, 1));
  return new CatmullRomCurve3(points);
}

export function coil([radius, turns], colour, opacity) {
  const sides = 8;
  const wire = 0.14 * radius;
  const curve = winding(radius, turns);
  const steps = Math.max(64, Math.round(28 * turns));
  const geometry = new TubeGeometry(curve, steps, wire, sides);
  const positions = geometry.attributes.position;
  const centres = Array.from({ length: steps + 1 }, (_, i) => curve.getPointAt(i / steps).z);
  const offsets = Array.from({ length: positions.count }, (_, v) =>
    positions.getZ(v) - centres[Math.floor(v / (sides + 1))]);
  const link = new Mesh(geometry, material(colour, opacity));
  link.frustumCulled = false;
  link.stretch = (length) => {
    for (let v = 0; v < positions.count; ++v)
      positions.setZ(v, centres[Math.floor(v / (sides + 1))] * length + offsets[v]);
    positions.needsUpdate = true;
  };
  return link;
}
