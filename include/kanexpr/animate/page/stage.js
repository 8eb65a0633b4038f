// The renderer and the light.
import { DirectionalLight, HemisphereLight, PCFShadowMap, Scene, WebGLRenderer } from 'three';

export function renderer(view) {
  const made = new WebGLRenderer({ antialias: true, alpha: true });
  made.setPixelRatio(Math.min(window.devicePixelRatio, 2));
  made.shadowMap.enabled = true;
  made.shadowMap.type = PCFShadowMap;
  view.append(made.domElement);
  return made;
}

/// Light from above that moves with the system, so that its shadow is equally sharp everywhere.
export function stage(size) {
  const scene = new Scene();
  const sun = new DirectionalLight('#fffaf0', 2.4);
  const reach = 1.6 * size;
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 4;
  sun.shadow.normalBias = 0.004 * size;
  Object.assign(sun.shadow.camera, {
    left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1 * size, far: 12 * size,
  });
  const fill = new DirectionalLight('#dfe9ff', 0.5);
  scene.add(sun, sun.target, fill, fill.target, new HemisphereLight('#ffffff', '#c9c4ba', 1.7));
  scene.light = (target) => {
    sun.target.position.copy(target);
    sun.position.copy(target).add({ x: 2.2 * size, y: 4.5 * size, z: 1.6 * size });
    fill.target.position.copy(target);
    fill.position.copy(target).add({ x: -3 * size, y: size, z: -2 * size });
  };
  return scene;
}
