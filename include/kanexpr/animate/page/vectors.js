// Arrows and axes, which are seen through the shapes. Their size follows from that of the picture.
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';

const upright = new Vector3(0, 0, 1);
const direction = new Vector3();
const shaft = new CylinderGeometry(1, 1, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5);
const tip = new ConeGeometry(1, 1, 20).rotateX(Math.PI / 2).translate(0, 0, -0.5);

/// An arrow along z, from 0 to `length`.
function pointer(colour) {
  const made = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true, opacity: 0.9 });
  const both = new Group();
  const parts = [new Mesh(shaft, made), new Mesh(tip, made)];
  for (const part of parts) {
    part.userData.flat = true;
    part.renderOrder = 1;
  }
  both.add(...parts);
  both.stretch = (length, width) => {
    const head = Math.min(0.6 * length, 5 * width);
    parts[0].scale.set(0.6 * width, 0.6 * width, Math.max(length - head, 1e-9));
    parts[1].scale.set(1.8 * width, 1.8 * width, Math.max(head, 1e-9));
    parts[1].position.z = length;
  };
  return both;
}

/// An arrow whose vector is a track. `perUnit` and `width` are set once the size of the picture is known.
export function arrow(shape, colour) {
  const object = pointer(colour);
  const vector = shape.anchors[1].track;
  Object.assign(object, { perUnit: 1, width: 0.01 });
  object.show = () => {
    shape.anchors[0].position(object.position);
    const length = vector.position.length();
    object.visible = length * object.perUnit > 1e-3 * object.width;
    if (!object.visible) return;
    object.quaternion.setFromUnitVectors(upright, direction.copy(vector.position).divideScalar(length));
    object.stretch(length * object.perUnit, object.width);
  };
  object.magnitude = () => vector.position.length();
  object.longest = () => vector.longest();
  return object;
}

/// The axes of a frame: x red, y green, z blue.
export function frame(shape) {
  const object = new Group();
  const pointers = ['#c9483b', '#4d9a4f', '#3a6fb8'].map(pointer);
  pointers[0].rotation.y = Math.PI / 2;
  pointers[1].rotation.x = -Math.PI / 2;
  object.add(...pointers);
  object.setLength = (length, width) => {
    for (const one of pointers) one.stretch(length, width);
  };
  object.show = () => {
    shape.anchors[0].position(object.position);
    shape.anchors[0].turn(object.quaternion);
  };
  return object;
}
