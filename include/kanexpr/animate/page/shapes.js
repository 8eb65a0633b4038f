// The shapes of a picture as objects that can be shown at any time.
import { Vector3 } from 'three';
import * as links from './links.js';
import { colourOfLayer } from './layers.js';
import { colourOf } from './materials.js';
import * as solids from './solids.js';
import { sweep } from './sweeps.js';
import { trace } from './trace.js';
import { arrow, frame } from './vectors.js';

const upright = new Vector3(0, 0, 1);
const end = new Vector3();

function solid(shape, colour, meshes) {
  const object = shape.kind === 'mesh'
    ? meshes.object(shape, colour)
    : solids[shape.kind](shape.sizes, colour, shape.opacity);
  object.show = () => {
    shape.anchors[0].position(object.position);
    if (shape.placed === 'pose') shape.anchors[0].turn(object.quaternion);
  };
  return object;
}

function link(shape, colour) {
  const object = links[shape.kind](shape.sizes, colour, shape.opacity);
  object.show = () => {
    shape.anchors[0].position(object.position);
    shape.anchors[1].position(end).sub(object.position);
    const length = end.length();
    if (length > 0) object.quaternion.setFromUnitVectors(upright, end.divideScalar(length));
    object.stretch(length);
  };
  return object;
}

function objectWithShadow(shape, colour, meshes) {
  if (shape.profile) return sweep(shape, colour);
  return shape.placed === 'ends' ? link(shape, colour) : solid(shape, colour, meshes);
}

export function objectOf(shape, index, meshes) {
  const colour = colourOf(shape, index);
  if (shape.kind === 'trace') return trace(shape, colour);
  if (shape.kind === 'arrow') return arrow(shape, shape.colour ?? colourOfLayer(shape.layer));
  if (shape.kind === 'frame') return frame(shape);
  const object = objectWithShadow(shape, colour, meshes);
  object.traverse((part) => {
    part.castShadow = shape.opacity > 0.5 && !part.userData.flat;
    part.receiveShadow = true;
  });
  return object;
}
