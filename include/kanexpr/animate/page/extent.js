// The position and size of a system.
import { Box3, Sphere, Vector3 } from 'three';

function moments(count) {
  const most = 60;
  const step = Math.max(1, Math.floor(count / most));
  const found = [];
  for (let index = 0; index < count; index += step) found.push({ index, part: 0 });
  return found;
}

/// `middle(now)` is the center of the system, at its current position if it travels; `size` is the radius of
/// the region to show around it.
export function extent(model, solids, count, travels) {
  const boxAt = (now) => {
    for (const object of solids) object.show(now);
    model.updateMatrixWorld(true);
    return solids.reduce((box, object) => box.expandByObject(object), new Box3());
  };
  const mean = (now) => {
    const sum = new Vector3();
    for (const object of solids) {
      object.show(now);
      sum.add(object.position);
    }
    return sum.divideScalar(solids.length).applyQuaternion(model.quaternion);
  };
  if (solids.length === 0) return { middle: () => new Vector3(), size: 1 };

  const whole = new Box3();
  for (const now of moments(count)) {
    const box = boxAt(now);
    whole.union(travels ? box.translate(mean(now).negate()) : box);
  }
  const { center, radius } = whole.getBoundingSphere(new Sphere());
  const size = radius > 0 ? radius : 1;
  if (!travels) return { middle: () => center, size };
  return { middle: (now) => mean(now).add(center), size };
}
