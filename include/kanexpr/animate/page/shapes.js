// The shapes of a picture as objects that can be shown at any time.
import { Vector3 } from 'three';
import * as links from './links.js';
import { colourOf } from './materials.js';
import { placeBetween, turnBetween } from './motion.js';
import * as solids from './solids.js';
import { trace } from './trace.js';

const upright = new Vector3(0, 0, 1);
const end = new Vector3();

function solid(shape, colour, meshes) {
  const object = shape.kind === 'mesh'
    ? meshes.object(shape, colour)
    : solids[shape.kind](shape.sizes, colour, shape.opacity);
  const stride = shape.placed === 'pose' ? 7 : 3;
  object.show = (now) => {
    placeBetween(shape.rows, stride, 0, now, object.position);
    if (stride === 7) turnBetween(shape.rows, stride, 3, now, object.quaternion);
  };
  return object;
}

function link(shape, colour) {
  const object = links[shape.kind](shape.sizes, colour, shape.opacity);
  object.show = (now) => {
    placeBetween(shape.rows, 6, 0, now, object.position);
    placeBetween(shape.rows, 6, 3, now, end).sub(object.position);
    const length = end.length();
    if (length > 0) object.quaternion.setFromUnitVectors(upright, end.divideScalar(length));
    object.stretch(length);
  };
  return object;
}

export function objectOf(shape, index, meshes) {
  const colour = colourOf(shape, index);
  if (shape.kind === 'trace') return trace(shape, colour);
  const object = shape.placed === 'ends' ? link(shape, colour) : solid(shape, colour, meshes);
  object.traverse((part) => {
    part.castShadow = shape.opacity > 0.5 && !part.userData.flat;
    part.receiveShadow = true;
  });
  return object;
}
