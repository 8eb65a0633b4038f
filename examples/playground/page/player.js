// Play, pause and back to the start: lets the model move in the time of the page.
import { EnergyChart } from './energy.js';
import { find } from './find.js';
import { Stage } from './stage.js';

const longestStep = 1e-3; // s, of the Runge-Kutta method
const longestFrame = 0.05; // s; a busy machine shows slow motion
const icons = { play: 'M8 5v14l11-7z', pause: 'M7 5h4v14H7zM13 5h4v14h-4z' };

export class Player {
  playing = false;
  #model = null;
  #isDirty = false;
  #last = 0;

  /// Calls `onFrame` after each frame, and `onTrouble` with the reason why a motion ended.
  constructor(engine, { onFrame, onTrouble, onRestart }) {
    Object.assign(this, { engine, onFrame, onTrouble });
    this.chart = new EnergyChart(find('energy'), find('energies'));
    this.stage = new Stage(find('stage'), engine, {
      onDrag: () => this.change(),
      onTurn: () => { this.#isDirty = true; },
    });
    find('play').onclick = () => (this.playing ? this.pause() : this.play());
    find('reset').onclick = onRestart;
    addEventListener('keydown', (event) => {
      if (event.key !== ' ' || event.target.closest('.cm-editor, input, select, button, dialog')) return;
      event.preventDefault();
      find('play').click();
    });
    this.pause();
    requestAnimationFrame((now) => this.#frame(now));
  }

  /// Shows another model at its first state.
  open(model) {
    this.#model = model;
    this.stage.open(model);
    this.change();
  }

  play() {
    if (!this.#model) return;
    this.playing = true;
    this.#last = 0;
    this.#showIcon('pause');
  }
  pause() {
    this.playing = false;
    this.#isDirty = true;
    this.#showIcon('play');
  }
  /// The state or the values have changed other than by the motion.
  change() {
    this.chart.restart();
    this.#isDirty = true;
  }

  #showIcon(name) {
    find('play').querySelector('path').setAttribute('d', icons[name]);
    find('play').setAttribute('aria-label', name === 'play' ? 'Play' : 'Pause');
  }

  #frame(now) {
    requestAnimationFrame((next) => this.#frame(next));
    if (!this.#model || (!this.playing && !this.#isDirty)) return;
    try {
      this.#show(now);
    } catch (error) {
      this.pause();
      this.#isDirty = false;
      this.onTrouble(error.message);
    }
  }

  #show(now) {
    if (this.playing && this.stage.held === undefined) this.#advance(now);
    this.#last = now;
    if (this.playing || this.chart.samples.length === 0) this.chart.add(this.engine.time, this.engine.energy);
    this.stage.draw(!this.playing);
    this.chart.draw();
    find('clock').textContent = `${this.engine.time.toFixed(2)} s`;
    this.#isDirty = false;
    this.onFrame(now);
  }

  #advance(now) {
    const elapsed = this.#last ? (now - this.#last) / 1000 : 0;
    const duration = Math.min(longestFrame, elapsed) * Number(find('speed').value);
    const trouble = duration > 0 && this.engine.advance(duration, longestStep);
    if (!trouble) return;
    this.pause();
    this.onTrouble(`The motion ended at ${this.engine.time.toFixed(3)} s: ${trouble}`);
  }
}
