// The table of the time, the coordinates and the speeds.
import { between } from './motion.js';

function written(value) {
  if (value === 0) return '0';
  const size = Math.abs(value);
  return (size >= 1e5 || size < 1e-4 ? value.toExponential(3) : value.toFixed(4)).replace('-', '−');
}

export function values(nameOfTime, columns) {
  const body = document.getElementById('values');
  const cells = [nameOfTime, ...columns.map((column) => column.name)].map((name) => {
    const row = body.insertRow();
    const head = document.createElement('th');
    head.scope = 'row';
    head.textContent = name;
    row.append(head);
    return row.insertCell();
  });
  return function show(time, now) {
    cells[0].textContent = written(time);
    columns.forEach((column, i) => (cells[i + 1].textContent = written(between(column.values, now))));
  };
}
