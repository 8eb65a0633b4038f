// The picture of a motion.
import { Box3, Group, Matrix4, Vector3 } from 'three';
import { Camera } from './camera.js';
import { deflectionSlider } from './deflections.js';
import { extent } from './extent.js';
import { ground } from './ground.js';
import { layers } from './layers.js';
import { Meshes, trianglesIn, volumeOf } from './meshes.js';
import { names } from './names.js';
import { Run } from './run.js';
import { stage } from './stage.js';
import { tell } from './trouble.js';

/// The inertial axes are rotated so that y is up. `changed` is called when the picture must be redrawn.
export function picture(motion, draw, view, changed) {
  const model = new Group();
  const meshes = new Meshes(motion.files);
  const runs = motion.runs.map((run, number) => new Run(run, meshes, number));
  const { objects } = runs[0];
  if (meshes.broken.length > 0)
    tell(`These files cannot be shown: ${meshes.broken.join(', ')}.`, true);
  model.quaternion.setFromUnitVectors(new Vector3(...motion.up), new Vector3(0, 1, 0));
  model.add(...runs.map((run) => run.all));
  const { middle, size } = extent(model, runs, motion.carried);
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
  for (const run of runs) run.show(run.times[0]);
  camera.target.copy(middle());
  resize();
  camera.home();
  new ResizeObserver(resize).observe(view);
  layers(runs, size, changed);
  deflectionSlider(runs, changed);
  const updateName = names(view, runs, camera);

  return {
    camera,
    canvas: draw.domElement,
    setVisible(run, isVisible) {
      runs[run].all.visible = isVisible;
      changed();
    },
    pose(index) {
      const { position, quaternion } = objects[index];
      return { position: position.toArray(), quaternion: quaternion.toArray() };
    },
    /// The number of triangles, their bounding box, and the volume that they enclose.
    measure(index) {
      let triangles = 0;
      let volume = 0;
      const box = new Box3();
      const back = new Matrix4().copy(model.matrixWorld).invert();
      objects[index].updateMatrixWorld(true);
      objects[index].traverse((part) => {
        if (!part.isMesh) return;
        triangles += trianglesIn(part);
        const own = part.geometry.clone().applyMatrix4(part.matrixWorld).applyMatrix4(back);
        own.computeBoundingBox();
        box.union(own.boundingBox);
        volume += volumeOf(own);
      });
      return { triangles, volume, least: box.min.toArray(), most: box.max.toArray() };
    },
    show(time) {
      for (const run of runs) run.show(time);
      const target = middle();
      camera.aim(target);
      scene.light(target);
      plane?.follow(target);
      draw.render(scene, camera.lens);
      updateName();
    },
  };
}
