// The table of the time and of all columns of the runs.
import { between, moment } from './motion.js';

export function written(value) {
  if (value === 0) return '0';
  const size = Math.abs(value);
  return (size >= 1e5 || size < 1e-4 ? value.toExponential(3) : value.toFixed(4)).replace('-', '−');
}

function addRow(body, name, unit, count) {
  const row = body.insertRow();
  const head = document.createElement('th');
  head.scope = 'row';
  head.textContent = name;
  row.append(head);
  const cells = Array.from({ length: count }, () => row.insertCell());
  const last = row.insertCell();
  last.className = 'unit';
  last.textContent = unit;
  return cells;
}

function nameRuns(table, runs) {
  const row = table.createTHead().insertRow();
  for (const name of ['', ...runs.map((run) => run.name), '']) {
    const head = document.createElement('th');
    head.scope = 'col';
    head.textContent = name;
    row.append(head);
  }
}

export function values(nameOfTime, quantities, runs) {
  const panel = document.getElementById('values-panel');
  const body = document.getElementById('values');
  if (runs.length > 1) nameRuns(panel.querySelector('table'), runs);
  const [clock] = addRow(body, nameOfTime, 's', 1);
  clock.colSpan = runs.length;
  const rows = quantities.map(({ name, unit }) => addRow(body, name, unit, runs.length));
  return function show(time) {
    if (panel.hidden) return;
    clock.textContent = written(time);
    runs.forEach((run, k) => {
      const now = moment(run.times, time);
      quantities.forEach(({ columns }, i) => {
        if (columns[k]) rows[i][k].textContent = written(between(columns[k].values, now));
      });
    });
  };
}
