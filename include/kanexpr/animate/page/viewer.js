// Reads the motion of a system from the page and shows it.
import { controls } from './controls.js';
import { moment } from './motion.js';
import { picture } from './picture.js';
import { Player } from './player.js';
import { renderer } from './stage.js';
import { tell } from './trouble.js';
import { values } from './values.js';

const motion = JSON.parse(document.getElementById('motion').textContent);
document.getElementById('title').textContent = motion.title;
document.getElementById('text').textContent = motion.text;

function withoutPicture(error) {
  tell('This browser does not support WebGL, which the picture requires; the values at each time are still shown.');
  document.getElementById('panel').open = true;
  console.warn(error.message);
  return { camera: { follows: false, home() {} }, pose() {}, measure() {}, show() {} };
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

const [run] = motion.runs;
const player = new Player(run.times[0], run.times.at(-1), changed);
const seen = withPicture();
const showControls = controls(player, seen.camera);
const showValues = values(motion.nameOfTime, run.columns);

function show() {
  const now = moment(run.times, player.time);
  seen.show(player.time);
  showControls();
  showValues(player.time, now);
}

/// For scripts: the functions of the controls, and the pose and the extent of a shape in inertial axes.
window.kanexpr = {
  shapes: run.shapes.map((shape) => shape.name),
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
