// Shapes of fixed size. Their axis, if they have one, is z.
import {
  CircleGeometry, ConeGeometry, CylinderGeometry, Group, Mesh, SphereGeometry, TorusGeometry,
} from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { darker, lighter, material } from './materials.js';

export function alongZ(radius, length, sides = 48) {
  return new CylinderGeometry(radius, radius, length, sides).rotateX(Math.PI / 2);
}

export function box([x, y, z], colour, opacity) {
  const rounding = 0.08 * Math.min(x, y, z);
  return new Mesh(new RoundedBoxGeometry(x, y, z, 3, rounding), material(colour, opacity));
}

export function ellipsoid([x, y, z], colour, opacity) {
  return new Mesh(new SphereGeometry(1, 48, 32).scale(x, y, z), material(colour, opacity));
}

export function sphere([radius], colour, opacity) {
  return new Mesh(new SphereGeometry(radius, 48, 32), material(colour, opacity));
}

export function cone([radius, length], colour, opacity) {
  const solid = new Group();
  const open = new ConeGeometry(radius, length, 64).rotateX(-Math.PI / 2).translate(0, 0, length / 2);
  solid.add(new Mesh(open, material(colour, opacity)));
  solid.add(marks(radius, length, 1, colour, opacity));
  return solid;
}

/// Marked quarters on an end, which show the rotation of the shape.
function marks(radius, height, side, colour, opacity) {
  const both = new Group();
  for (const start of [0, Math.PI]) {
    const quarter = new Mesh(
      new CircleGeometry(0.92 * radius, 24, start, Math.PI / 2),
      material(lighter(colour, 0.55), opacity),
    );
    quarter.userData.flat = true;
    if (side < 0) quarter.rotation.y = Math.PI;
    quarter.position.z = height + side * 1e-3 * radius;
    both.add(quarter);
  }
  return both;
}

export function cylinder([radius, length], colour, opacity) {
  const solid = new Group();
  solid.add(new Mesh(alongZ(radius, length, 64), material(colour, opacity)));
  for (const side of [1, -1]) solid.add(marks(radius, (side * length) / 2, side, colour, opacity));
  return solid;
}

export function ring([radius, thickness], colour, opacity) {
  const tube = new TorusGeometry(radius - thickness / 2, thickness / 2, 20, 96);
  return new Mesh(tube, material(colour, opacity));
}

export function wheel([radius, thickness], colour, opacity) {
  const solid = new Group();
  const rim = radius - thickness;
  const spokes = 16;
  solid.add(ring([radius, thickness], darker(colour, 0.8), opacity));
  solid.add(ring([rim + 0.3 * thickness, 0.5 * thickness], colour, opacity));
  solid.add(new Mesh(alongZ(0.09 * radius, 1.6 * thickness), material(darker(colour, 0.4), opacity)));
  for (let i = 0; i < spokes; ++i) {
    const own = i === 0; // the quarter that the eye can follow
    const width = (own ? 0.032 : 0.011) * radius;
    const spoke = new Mesh(
      new CylinderGeometry(width, width, rim, 8).translate(0, rim / 2, 0),
      material(own ? '#e8892b' : '#8c949c', opacity),
    );
    spoke.rotation.z = (2 * Math.PI * i) / spokes;
    solid.add(spoke);
  }
  return solid;
}

function arrow(length, colour, opacity) {
  const solid = new Group();
  const made = material(colour, opacity);
  solid.add(new Mesh(alongZ(0.02 * length, 0.8 * length, 16).translate(0, 0, 0.4 * length), made));
  const tip = new ConeGeometry(0.06 * length, 0.2 * length, 24).rotateX(Math.PI / 2);
  solid.add(new Mesh(tip.translate(0, 0, 0.9 * length), made));
  return solid;
}

export function axes([length], colour, opacity) {
  const three = new Group();
  const x = arrow(length, '#c9483b', opacity);
  const y = arrow(length, '#4d9a4f', opacity);
  x.rotation.y = Math.PI / 2;
  y.rotation.x = -Math.PI / 2;
  three.add(x, y, arrow(length, '#3a6fb8', opacity));
  return three;
}
