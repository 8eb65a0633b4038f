// The position and size of a system.
import { Box3, Sphere, Vector3 } from 'three';

function momentsOf(times) {
  const most = 60;
  return times.filter((_, index) => index % Math.max(1, Math.floor(times.length / most)) === 0);
}

/// `middle()` is the center of the first run as it is shown, at its current position if it travels; `size` is
/// the radius of the region to show around it.
export function extent(model, runs, travels) {
  const mean = ({ solids }) => {
    const sum = new Vector3();
    for (const object of solids) sum.add(object.position);
    return sum.divideScalar(solids.length).applyQuaternion(model.quaternion);
  };
  if (runs.every(({ solids }) => solids.length === 0)) return { middle: () => new Vector3(), size: 1 };

  const whole = new Box3();
  for (const run of runs) {
    for (const time of momentsOf(run.times)) {
      run.show(time);
      model.updateMatrixWorld(true);
      const box = run.solids.reduce((all, object) => all.expandByObject(object), new Box3());
      whole.union(travels ? box.translate(mean(run).negate()) : box);
    }
  }
  const { center, radius } = whole.getBoundingSphere(new Sphere());
  const size = radius > 0 ? radius : 1;
  if (!travels) return { middle: () => center, size };
  return { middle: () => mean(runs[0]).add(center), size };
}
