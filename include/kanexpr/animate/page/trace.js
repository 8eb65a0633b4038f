// The path of a point up to the time shown.
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { Vector3 } from 'three';

export function trace(shape, colour) {
  const rows = shape.path();
  const geometry = new LineGeometry().setPositions(rows.length > 3 ? rows : [...rows, ...rows]);
  const segments = geometry.attributes.instanceStart.data; // six numbers each: from, to
  const line = new Line2(geometry, new LineMaterial({ color: colour, linewidth: 2.5, transparent: true,
    opacity: shape.opacity }));
  line.frustumCulled = false;
  let cut = 0;
  line.show = (now) => {
    const last = segments.count - 1;
    segments.array.set(rows.slice(3 * cut + 3, 3 * cut + 6), 6 * cut + 3);
    cut = Math.min(now.index, last);
    if (now.index <= last) shape.anchors[0].position(head).toArray(segments.array, 6 * cut + 3);
    segments.needsUpdate = true;
    geometry.instanceCount = cut + 1;
  };
  return line;
}

const head = new Vector3();
