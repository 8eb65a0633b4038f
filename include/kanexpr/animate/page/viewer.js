// Reads the motion of a system from the page and shows it.
import { controls } from './controls.js';
import { openPanel, panels } from './panels.js';
import { picture } from './picture.js';
import { Player } from './player.js';
import { plots } from './plots.js';
import { quantitiesOf } from './quantities.js';
import { Recorder } from './record.js';
import { runSwitches } from './runs.js';
import { renderer } from './stage.js';
import { tell } from './trouble.js';
import { values } from './values.js';

const motion = JSON.parse(document.getElementById('motion').textContent);
document.getElementById('title').textContent = motion.title;
document.getElementById('text').textContent = motion.text;

function withoutPicture(error) {
  tell('This browser does not support WebGL, which the picture requires; the values at each time are still shown.');
  openPanel('values-panel');
  document.querySelector('[aria-controls="record-panel"]').disabled = true;
  console.warn(error.message);
  return { camera: { follows: false, home() {} }, pose() {}, measure() {}, setVisible() {}, show() {} };
}

let due = false;
function changed() {
  if (due) return;
  due = true;
  requestAnimationFrame(() => {
    due = false;
    show();
  });
}

function withPicture() {
  const view = document.getElementById('view');
  let draw;
  try {
    draw = renderer(view);
  } catch (error) {
    return withoutPicture(error);
  }
  return picture(motion, draw, view, changed);
}

const { runs } = motion;
for (const run of runs) run.visible = true;
const quantities = quantitiesOf(runs);
const player = new Player(
  Math.min(...runs.map((run) => run.times[0])), Math.max(...runs.map((run) => run.times.at(-1))), changed);
panels(changed);
const seen = withPicture();
const showControls = controls(player, seen.camera);
const showValues = values(motion.nameOfTime, quantities, runs);
const plotted = plots(quantities, runs, motion.nameOfTime, player);
runSwitches(runs, (number) => {
  seen.setVisible(number, runs[number].visible);
  plotted.draw();
});
const recorder = seen.canvas && new Recorder(seen.canvas, player, show, motion.title);

function show() {
  seen.show(player.time);
  recorder?.drawn();
  showControls();
  showValues(player.time);
  plotted.show(player.time);
}

/// For scripts: the functions of the controls, and the pose and the extent of a shape of the first run, in
/// inertial axes.
window.kanexpr = {
  shapes: runs[0].shapes.map((shape) => shape.name),
  seek(t) {
    player.seek(t);
    show();
  },
  play: () => player.play(),
  pause: () => player.pause(),
  get time() {
    return player.time;
  },
  get playing() {
    return player.playing;
  },
  pose(name) {
    return seen.pose(this.shapes.indexOf(name));
  },
  measure(name) {
    return seen.measure(this.shapes.indexOf(name));
  },
};

show();
if (!window.matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
