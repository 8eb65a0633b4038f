// Plots of the columns over time. Their cursor is the time shown.
import uPlot from 'uplot';
import { title } from './quantities.js';

const dashes = [[], [7, 4], [2, 3], [9, 3, 2, 3]];

/// A line that marks each run in plots, and its number of pixels.
export function dashOf(run) {
  return dashes[run % dashes.length];
}

function inherited(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name);
}

function varies({ columns: [first] }) {
  return first !== undefined && first.values.some((value) => value !== first.values[0]);
}

/// The choices at first: some of the coordinates that change.
function firstChoices(quantities) {
  const moving = quantities.filter(varies);
  const [first] = moving;
  return moving.filter(({ group, unit }) => group === first.group && unit === first.unit).slice(0, 3);
}

function choices(quantities, chosen, changed) {
  const parent = document.getElementById('choices');
  for (const group of new Set(quantities.map((quantity) => quantity.group))) {
    const set = document.createElement('fieldset');
    const legend = document.createElement('legend');
    legend.textContent = group;
    set.append(legend);
    for (const quantity of quantities.filter((one) => one.group === group)) {
      const label = document.createElement('label');
      label.className = 'tick';
      const box = Object.assign(document.createElement('input'), {
        type: 'checkbox', checked: chosen.has(quantity),
      });
      const swatch = document.createElement('span');
      swatch.className = 'swatch';
      swatch.style.borderColor = quantity.colour;
      box.addEventListener('change', () => {
        if (box.checked) chosen.add(quantity);
        else chosen.delete(quantity);
        changed();
      });
      label.append(box, swatch, title(quantity));
      set.append(label);
    }
    parent.append(set);
  }
}

function axis(label, size) {
  const grid = { stroke: inherited('--line'), width: 1 };
  return {
    stroke: inherited('--faint'), grid, ticks: grid, font: '12px system-ui', labelFont: '12px system-ui',
    label: label || undefined, labelSize: 18, size, labelGap: 0,
  };
}

/// The curves of all visible runs, and a table of the times and values of each run.
function curves(shown, runs) {
  const series = [{}];
  const tables = [];
  runs.forEach((run, k) => {
    if (!run.visible) return;
    const own = shown.filter((quantity) => quantity.columns[k]);
    tables.push([run.times, ...own.map((quantity) => quantity.columns[k].values)]);
    for (const { colour } of own)
      series.push({
        stroke: colour, width: 1.6, dash: dashOf(k), spanGaps: true, points: { show: false }, pxAlign: 0,
      });
  });
  return { series, tables };
}

class Chart {
  constructor(parent, unit, shown, runs, nameOfTime, player) {
    this.player = player;
    this.parent = Object.assign(document.createElement('div'), { className: 'chart' });
    this.parent.setAttribute('role', 'img');
    this.parent.setAttribute('aria-label', `${shown.map(title).join(', ')} over time`);
    parent.append(this.parent);
    const { series, tables } = curves(shown, runs);
    this.line = Object.assign(document.createElement('div'), { className: 'now' });
    this.plot = new uPlot({
      ...this.#size(),
      series,
      hooks: { draw: [() => this.plot && this.show(player.time)] },
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { show: false }, x: false, y: false },
      scales: { x: { time: false, range: [player.first, Math.max(player.last, player.first + 1e-9)] } },
      axes: [axis(`${nameOfTime} [s]`, 34), axis(unit ? `[${unit}]` : '', 52)],
    }, tables.length > 1 ? uPlot.join(tables) : (tables[0] ?? [[]]), this.parent);
    this.plot.over.append(this.line);
    this.#seekWithPointer();
  }

  #size() {
    return { width: this.parent.clientWidth, height: this.parent.clientHeight };
  }

  #seekWithPointer() {
    const { over } = this.plot;
    const seek = (event) => {
      if (event.buttons !== 1) return;
      this.player.seek(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x'));
    };
    over.addEventListener('pointerdown', (event) => {
      over.setPointerCapture(event.pointerId);
      seek(event);
    });
    over.addEventListener('pointermove', seek);
  }

  resize() {
    this.plot.setSize(this.#size());
  }

  show(time) {
    this.line.style.left = `${this.plot.valToPos(time, 'x')}px`;
  }

  remove() {
    this.plot.destroy();
    this.parent.remove();
  }
}

/// Returns a function that shows a time, and one that draws the plots anew.
export function plots(quantities, runs, nameOfTime, player) {
  const panel = document.getElementById('plots-panel');
  const parent = document.getElementById('charts');
  const chosen = new Set(quantities.some(varies) ? firstChoices(quantities) : []);
  let charts = [];

  function draw() {
    for (const chart of charts) chart.remove();
    charts = [];
    if (panel.hidden) return;
    const shown = quantities.filter((quantity) => chosen.has(quantity));
    for (const unit of new Set(shown.map((quantity) => quantity.unit)))
      charts.push(new Chart(parent, unit, shown.filter((one) => one.unit === unit), runs, nameOfTime, player));
    for (const chart of charts) chart.resize(); // now that all of them share the width
  }
  function show(time) {
    if (!panel.hidden && charts.length === 0 && chosen.size > 0) draw();
    if (panel.hidden) return;
    for (const chart of charts) chart.show(time);
  }
  choices(quantities, chosen, draw);
  new ResizeObserver(() => {
    for (const chart of charts) chart.resize();
  }).observe(parent);
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
  return { show, draw };
}
