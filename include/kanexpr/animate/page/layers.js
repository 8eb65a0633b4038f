// Groups of shapes that are shown on demand, such as all forces.

/// The layers of all runs, each with its objects. Arrows without a layer have the name ''.
function layersOf(runs) {
  const found = new Map();
  for (const run of runs)
    run.shapes.forEach(({ layer = '', kind }, index) => {
      if (!layer && kind !== 'arrow') return;
      if (!found.has(layer)) found.set(layer, []);
      found.get(layer).push(run.objects[index]);
    });
  return found;
}

/// The colour of the arrows of a layer.
export function colourOfLayer(name) {
  return { Forces: '#c9302c', Velocities: '#1f7a4d' }[name] ?? '#8568ae';
}

/// Sets the lengths of arrows and axes: the longest arrow of a layer is `scale` times half the picture.
function scaleArrows(objects, size, scale) {
  const longest = Math.max(...objects.map((object) => object.longest?.() ?? 0));
  const perUnit = longest > 0 ? (0.5 * scale * size) / longest : 0;
  for (const object of objects) {
    if (object.longest) Object.assign(object, { perUnit, width: 0.014 * size });
    object.setLength?.(0.25 * scale * size, 0.009 * size);
  }
}

function addSwitch(parent, name, changed) {
  const label = document.createElement('label');
  label.className = 'tick';
  const box = Object.assign(document.createElement('input'), { type: 'checkbox' });
  box.addEventListener('change', () => changed(box.checked));
  label.append(box, name);
  parent.append(label);
}

/// Adds a switch for each layer, and the slider of the arrows' length.
export function layers(runs, size, changed) {
  const all = layersOf(runs);
  const parent = document.getElementById('layers');
  const slider = document.getElementById('arrows');
  const scale = () => {
    for (const objects of all.values()) scaleArrows(objects, size, 10 ** slider.valueAsNumber);
    changed();
  };
  for (const [name, objects] of all) {
    if (name === '') continue;
    const show = (isShown) => {
      for (const object of objects) object.holder.visible = isShown;
      changed();
    };
    addSwitch(parent, name, show);
    show(false);
  }
  const areScaled = [...all.values()].flat().some((object) => object.longest || object.setLength);
  document.getElementById('arrow-size').hidden = !areScaled;
  slider.addEventListener('input', scale);
  scale();
}
