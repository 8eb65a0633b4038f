// The page: text, model, motion and results follow one another.
import 'katex/dist/katex.min.css';
import { openEditor } from './editor.js';
import { openEngine } from './engine.js';
import { EnergyChart } from './energy.js';
import { showEquations } from './equations.js';
import { examples } from './examples.js';
import { openForm } from './form.js';
import { Stage } from './stage.js';
import { download, identifier, wordsOf } from './take.js';
import { showState, showValues } from './values.js';

const longestStep = 1e-3; // s, of the Runge-Kutta method
const icons = { play: 'M8 5v14l11-7z', pause: 'M7 5h4v14H7zM13 5h4v14h-4z' };
const find = (name) => document.getElementById(name);

const began = performance.now();
const engine = await openEngine(find('engine').textContent);
const started = performance.now() - began;

const vocabulary = engine.vocabulary();
const chart = new EnergyChart(find('energy'), find('energies'));
const editor = openEditor(find('text'), vocabulary, changed);
const stage = new Stage(find('stage'), engine, {
  onDrag: (isOnlyView) => { if (!isOnlyView) moved(); dirty = true; },
  onRelease: () => { chart.restart(); dirty = true; },
});

let model = null, text = '', playing = false, last = 0, dirty = true, waiting = 0, shown = 'moving', entries = 'symbols';
let latex = '', derived = 0, nextNumbers = 0;

for (const { title } of examples) find('example').append(new Option(title, title));
find('example').onchange = () => open(examples.find((each) => each.title === find('example').value));

function open({ title, model: lines }) {
  find('name').value = identifier(title.toLowerCase());
  editor.text = lines;
  clearTimeout(waiting);
  read();
}

function changed() {
  clearTimeout(waiting);
  waiting = setTimeout(read, 180);
}

/// Derives the model that is written, or shows its mistake and keeps the last model.
function read() {
  const from = performance.now();
  const answer = engine.read(editor.text);
  derived = performance.now() - from;
  const { mistake } = answer;
  editor.show(mistake);
  document.body.classList.toggle('stale', Boolean(mistake));
  find('mistake').classList.toggle('wrong', Boolean(mistake));
  find('mistake').textContent = mistake
    ? (mistake.line ? `Line ${mistake.line}: ` : '') + mistake.sentence
    : `derived in ${derived < 1 ? derived.toFixed(1) : derived.toFixed(0)} ms`;
  if (mistake) return pause();
  model = answer;
  text = editor.text;
  stage.open(model);
  chart.restart();
  showResults();
  dirty = true;
}

function restart() {
  pause();
  engine.read(text);
  stage.open(model);
  chart.restart();
  showResults();
  dirty = true;
}

function play() {
  if (!model) return;
  playing = true;
  last = 0;
  showPlaying();
}
function pause() {
  playing = false;
  dirty = true;
  showPlaying();
}
function showPlaying() {
  find('play').firstElementChild.firstElementChild.setAttribute('d', playing ? icons.pause : icons.play);
  find('play').setAttribute('aria-label', playing ? 'Pause' : 'Play');
}
find('play').onclick = () => (playing ? pause() : play());
find('reset').onclick = restart;

addEventListener('keydown', (event) => {
  if (event.key !== ' ' || event.target.closest('.cm-editor, input, select, button, dialog')) return;
  event.preventDefault();
  find('play').click();
});

/// The state has changed other than by the motion.
function moved() {
  chart.restart();
  nextNumbers = 0;
}

function frame(now) {
  requestAnimationFrame(frame);
  if (!model || (!playing && !dirty)) return;
  if (playing && stage.held === undefined) {
    const duration = Math.min(0.05, last ? (now - last) / 1000 : 0) * Number(find('speed').value);
    if (duration > 0) {
      const trouble = engine.advance(duration, longestStep);
      if (trouble) stop(trouble);
    }
    chart.add(engine.time, engine.energy);
  }
  last = now;
  if (!playing && chart.samples.length === 0) chart.add(engine.time, engine.energy);
  stage.draw(!playing);
  chart.draw();
  find('clock').textContent = `${engine.time.toFixed(2)} s`;
  if (now > nextNumbers) showNumbers(now);
  dirty = false;
}

function stop(trouble) {
  pause();
  find('mistake').classList.add('wrong');
  find('mistake').textContent = `The motion ended at ${engine.time.toFixed(3)} s: ${trouble}`;
}

/// What changes with the state, a few times in a second.
function showNumbers(now) {
  nextNumbers = now + 200;
  if (shown === 'values') showState(find('values'), engine, model);
  if (!find('formulas').hidden && (entries === 'numbers' || (entries === 'symbolsHere' && !playing))) showFormulas();
}

function showFormulas() {
  latex = showEquations(find('equations'), engine, model, { isLinear: shown === 'linear', entries });
}

function showResults() {
  find('formulas').hidden = shown !== 'moving' && shown !== 'linear';
  find('values').hidden = shown !== 'values';
  find('take').hidden = shown !== 'take';
  if (shown === 'moving' && entries === 'symbolsHere') return choose('symbols');
  document.querySelector('[data-entries=symbolsHere]').hidden = shown !== 'linear';
  if (!model) return;
  if (!find('formulas').hidden) showFormulas();
  if (shown === 'values') showValues(find('values'), engine, model, () => { moved(); engine.satisfyConstraints(); dirty = true; });
  if (shown === 'take') showWords();
}

function show(tab) {
  if (tab !== 'model') shown = tab;
  document.body.dataset.view = tab;
  for (const each of document.querySelectorAll('[data-show]')) {
    const isIt = each.dataset.show === (isNarrow() ? tab : shown);
    each.setAttribute('aria-selected', String(isIt));
  }
  showResults();
}
const isNarrow = () => matchMedia('(width < 820px)').matches;
for (const each of document.querySelectorAll('[data-show]')) each.onclick = () => show(each.dataset.show);

function choose(next) {
  entries = next;
  for (const each of document.querySelectorAll('[data-entries]'))
    each.setAttribute('aria-pressed', String(each.dataset.entries === entries));
  if (model && !find('formulas').hidden) showFormulas();
}
for (const each of document.querySelectorAll('[data-entries]')) each.onclick = () => choose(each.dataset.entries);

async function copy(button, content) {
  const label = button.textContent;
  await navigator.clipboard?.writeText(content).then(() => { button.textContent = 'Copied'; }, () => {});
  setTimeout(() => { button.textContent = label; }, 1200);
}
find('copy-latex').onclick = (event) => copy(event.target, latex);
find('copy-words').onclick = (event) => copy(event.target, find('words').textContent);

const name = () => identifier(find('name').value);
function showWords() {
  find('taken').textContent = '';
  find('taken').classList.remove('wrong');
  find('words').textContent = wordsOf(engine, name());
}
find('name').oninput = () => { if (model) showWords(); };
for (const each of document.querySelectorAll('[data-take]'))
  each.onclick = () => {
    let trouble = '';
    try {
      download(engine, each.dataset.take, name());
    } catch (error) {
      trouble = error.message;
    }
    find('taken').textContent = trouble || `${each.textContent}: saved`;
    find('taken').classList.toggle('wrong', Boolean(trouble));
  };

/// The names that the text declares, for the form.
function declared() {
  const names = { frame: [], point: [], symbol: [] };
  const kinds = { pin: 'frame', rotated: 'frame', body_fixed: 'frame', space_fixed: 'frame', inertial: 'frame',
    origin: 'point', offset: 'point', slider: 'point' };
  if (!/^\s*inertial\b/m.test(editor.text)) names.frame.push('N');
  for (const [, word, called] of editor.text.matchAll(/^\s*(\w+)\s+(\w+)/gm)) if (kinds[word]) names[kinds[word]].push(called);
  return names;
}
for (const each of document.querySelectorAll('[data-add]'))
  each.onclick = () => openForm(find('add'), vocabulary, each.dataset.add, declared(), (line) => editor.add(line));
find('cancel').onclick = () => find('add').close();

showPlaying();
choose('symbols');
show(isNarrow() ? 'model' : 'moving');
open(examples[0]);
requestAnimationFrame(frame);

window.playground = {
  started,
  get derived() { return derived; },
  get playing() { return playing; },
  get text() { return editor.text; },
  set text(lines) { editor.text = lines; clearTimeout(waiting); read(); },
  get model() { return model; },
  get latex() { return latex; },
  engine,
};
