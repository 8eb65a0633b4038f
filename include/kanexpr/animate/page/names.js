// The name of the shape under the pointer.
import { Raycaster, Vector2 } from 'three';
import { written } from './values.js';

function isShown(object) {
  for (let part = object; part; part = part.parent) if (!part.visible) return false;
  return true;
}

function textOf(object, runs) {
  const { shape } = object;
  const whose = runs.length > 1 && object.run.name ? ` (${object.run.name})` : '';
  const size = object.magnitude ? `: ${written(object.magnitude())} ${shape.unit ?? ''}`.trimEnd() : '';
  return shape.name + whose + size;
}

/// Arrows and axes are seen through the shapes, so they come first. A trace has a name only where it is drawn.
function nearest(hits) {
  const drawn = hits.filter(({ object, faceIndex }) => !object.isLine2 || faceIndex < object.geometry.instanceCount);
  return drawn.find(({ object }) => object.renderOrder > 0) ?? drawn[0];
}

function named(part) {
  let object = part;
  while (object && !object.shape) object = object.parent;
  return object;
}

const pause = 100; // milliseconds between updates while the picture moves

/// Shows the name at the pointer, or at the last touch. Returns a function that updates it.
export function names(view, runs, camera) {
  const label = document.getElementById('name');
  const caster = new Raycaster();
  caster.params.Line2 = { threshold: 8 }; // pixels
  const objects = runs.flatMap((run) => run.objects);
  let pointer;
  let updated = 0;

  function update() {
    if (!pointer) return;
    updated = performance.now();
    const box = view.getBoundingClientRect();
    const at = new Vector2(
      (2 * (pointer.clientX - box.left)) / box.width - 1, 1 - (2 * (pointer.clientY - box.top)) / box.height);
    caster.setFromCamera(at, camera.lens);
    const hit = nearest(caster.intersectObjects(objects.filter(isShown)));
    label.hidden = hit === undefined;
    if (!hit) return;
    label.textContent = textOf(named(hit.object), runs);
    const right = Math.min(pointer.clientX + 14, window.innerWidth - label.offsetWidth - 6);
    label.style.left = `${right}px`;
    label.style.top = `${Math.max(4, pointer.clientY - label.offsetHeight - 10)}px`;
  }
  function leave() {
    pointer = undefined;
    label.hidden = true;
  }
  let due = false;
  function move(event) {
    if (event.type === 'pointermove' && event.buttons !== 0) return leave(); // turns the picture
    pointer = event;
    if (due) return undefined;
    due = true;
    return requestAnimationFrame(() => {
      due = false;
      update();
    });
  }
  view.addEventListener('pointermove', move);
  view.addEventListener('pointerup', move);
  view.addEventListener('pointerleave', (event) => event.pointerType === 'mouse' && leave());
  return () => performance.now() - updated > pause && update();
}
