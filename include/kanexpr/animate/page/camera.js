// The camera, which the user rotates about the system and which may follow it.
import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

export class Camera {
  /// `from` is the initial direction to the eye.
  constructor(view, { size, from, follows, onGround, changed }) {
    this.lens = new PerspectiveCamera(32, 1, 0.02 * size, 80 * size);
    this.orbit = new OrbitControls(this.lens, view);
    this.orbit.minDistance = 0.3 * size;
    this.orbit.maxDistance = 30 * size;
    if (onGround) this.orbit.maxPolarAngle = 0.497 * Math.PI;
    this.orbit.addEventListener('change', changed);
    this.size = size;
    this.from = from;
    this.follows = follows;
    this.target = new Vector3();
  }

  home() {
    const half = (this.lens.fov * Math.PI) / 360;
    const narrow = Math.min(1, this.lens.aspect);
    const distance = (0.9 * this.size) / Math.sin(half) / narrow;
    this.orbit.target.copy(this.target);
    this.lens.position.copy(this.target).addScaledVector(this.from, distance);
    this.orbit.update();
  }

  /// Sets the current position of the system.
  aim(target) {
    if (this.follows) {
      this.lens.position.add(target).sub(this.target);
      this.orbit.target.add(target).sub(this.target);
      this.orbit.update();
    }
    this.target.copy(target);
  }

  resize(width, height) {
    this.lens.aspect = width / height;
    this.lens.updateProjectionMatrix();
  }
}
