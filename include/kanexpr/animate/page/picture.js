// The picture of a motion.
import { Group, Vector3 } from 'three';
import { Camera } from './camera.js';
import { extent } from './extent.js';
import { ground } from './ground.js';
import { moment } from './motion.js';
import { objectOf } from './shapes.js';
import { stage } from './stage.js';

/// Inertial axes are turned so that y is up. `changed` is called when the picture is to be drawn again.
export function picture(motion, draw, view, changed) {
  const model = new Group();
  const objects = motion.shapes.map(objectOf);
  const solids = objects.filter((_, i) => motion.shapes[i].kind !== 'trace');
  model.quaternion.setFromUnitVectors(new Vector3(...motion.up), new Vector3(0, 1, 0));
  model.add(...objects);
  const { middle, size } = extent(model, solids, motion.times.length, motion.carried);
  const scene = stage(size);
  const plane = motion.ground === undefined ? undefined : ground(motion.ground, size);
  scene.add(model, ...(plane ? [plane] : []));

  const from = motion.seenFrom
    ? new Vector3(...motion.seenFrom).applyQuaternion(model.quaternion)
    : new Vector3(0.8, 0.45, 1);
  const camera = new Camera(view, {
    size, from: from.normalize(), follows: motion.carried, onGround: plane !== undefined, changed,
  });

  function resize() {
    draw.setSize(view.clientWidth, view.clientHeight);
    camera.resize(view.clientWidth, view.clientHeight);
    changed();
  }
  camera.target.copy(middle(moment(motion.times, motion.times[0])));
  resize();
  camera.home();
  new ResizeObserver(resize).observe(view);

  return {
    camera,
    pose(index) {
      const { position, quaternion } = objects[index];
      return { position: position.toArray(), quaternion: quaternion.toArray() };
    },
    show(now) {
      for (const object of objects) object.show(now);
      const target = middle(now);
      camera.aim(target);
      scene.light(target);
      plane?.follow(target);
      draw.render(scene, camera.lens);
    },
  };
}
