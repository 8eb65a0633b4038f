// The switches of the runs below the title.
import { dashOf } from './plots.js';
import { colourOfRun } from './run.js';

function swatch(number) {
  const line = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  line.setAttribute('class', 'dash');
  line.setAttribute('viewBox', '0 0 26 8');
  line.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(line.namespaceURI, 'path');
  path.setAttribute('d', 'M0 4h26');
  path.setAttribute('stroke', colourOfRun(number) ?? 'currentColor');
  path.setAttribute('stroke-dasharray', dashOf(number).join(' '));
  line.append(path);
  return line;
}

/// `changed` is called with the number of a run after its `visible` has changed.
export function runSwitches(runs, changed) {
  const parent = document.getElementById('runs');
  parent.hidden = runs.length < 2;
  if (runs.length < 2) return;
  runs.forEach((run, number) => {
    const label = document.createElement('label');
    label.className = 'tick';
    const box = Object.assign(document.createElement('input'), { type: 'checkbox', checked: true });
    box.addEventListener('change', () => {
      run.visible = box.checked;
      changed(number);
    });
    label.append(box, swatch(number), run.name);
    parent.append(label);
  });
}
