// The page: the text, the model that it describes, its motion and its results.
import 'katex/dist/katex.min.css';
import { openEditor } from './editor.js';
import { openEngine } from './engine.js';
import { examples } from './examples.js';
import { find } from './find.js';
import { namesIn, openForm } from './form.js';
import { keep, linked, linkTo, remembered } from './keep.js';
import { Player } from './player.js';
import { copy, Results } from './results.js';

const damaged = 'this link is damaged, and its model cannot be read';
const pause = 180; // ms in which nobody types before the model is derived

const began = performance.now();
const engine = await openEngine(find('engine').textContent);
const started = performance.now() - began;
const vocabulary = engine.vocabulary();

let model = null, text = '', derived = 0, waiting = 0;

const editor = openEditor(find('text'), vocabulary, () => {
  clearTimeout(waiting);
  waiting = setTimeout(read, pause);
});
const results = new Results(engine, {
  onValues: () => {
    engine.satisfyConstraints();
    player.change();
  },
});
const player = new Player(engine, {
  onFrame: (now) => results.follow(now, player.playing),
  onTrouble: (sentence) => say(sentence, true),
  onRestart: () => {
    player.pause();
    if (model) restart();
  },
});

function say(sentence, isWrong) {
  find('mistake').classList.toggle('wrong', isWrong);
  find('mistake').textContent = sentence;
}

function open() {
  player.open(model);
  results.open(model);
}

/// Returns to the initial state, with the parameters and inputs of this moment.
function restart() {
  const parameters = [...engine.parameters(model.parameters.length)], inputs = [...engine.inputs(model.inputs.length)];
  engine.read(text);
  engine.parameters(parameters.length).set(parameters);
  engine.inputs(inputs.length).set(inputs);
  engine.satisfyConstraints();
  if (!document.body.classList.contains('stale')) sayDerived();
  open();
}

function sayDerived() { say(`derived in ${derived.toFixed(derived < 1 ? 1 : 0)} ms`, false); }

/// Derives the model that is written, or shows its mistake and keeps the last model.
function read() {
  clearTimeout(waiting);
  const from = performance.now();
  const answer = engine.read(editor.text);
  derived = performance.now() - from;
  const { mistake } = answer;
  editor.show(mistake);
  document.body.classList.toggle('stale', Boolean(mistake));
  if (mistake) {
    player.pause();
    return say((mistake.line ? `Line ${mistake.line}: ` : '') + mistake.sentence, true);
  }
  sayDerived();
  model = answer;
  text = editor.text;
  if (!examples.some((each) => each.model === text)) keep(text);
  player.pause();
  open();
}

function show({ title, model: lines }) {
  results.name = title;
  editor.text = lines;
  read();
}

for (const { title } of examples) find('example').append(new Option(title));
find('example').onchange = () => {
  const chosen = examples.find((each) => each.title === find('example').value);
  if (chosen) show(chosen);
};
find('link').onclick = (event) => copy(event.target, linkTo(editor.text));
for (const each of document.querySelectorAll('[data-add]'))
  each.onclick = () => openForm(find('add'), vocabulary, each.dataset.add, namesIn(editor.text), (line) => editor.add(line));
find('cancel').onclick = () => find('add').close();

/// Shows a text that is not an example, with its mistake if it has one; the figure then needs another model.
function showOwn(lines) {
  if (find('example').options[0].text !== 'Your model') find('example').prepend(new Option('Your model'));
  find('example').selectedIndex = 0;
  show({ title: 'model', model: lines });
  if (model) return;
  text = examples[0].model;
  model = engine.read(text);
  open();
}

/// Shows the model of the link, or the one of the last visit, or an example.
function showFirst() {
  const link = linked(), earlier = link || remembered();
  if (earlier) showOwn(earlier);
  else show(examples[find('example').selectedIndex = 0]);
  if (link === null) say(damaged, true);
}
showFirst();
addEventListener('hashchange', () => {
  const link = linked();
  if (link) showOwn(link);
  if (link === null) say(damaged, true);
});

window.playground = {
  engine, linkTo, started,
  get derived() { return derived; },
  get playing() { return player.playing; },
  get model() { return model; },
  get latex() { return results.latex; },
  get text() { return editor.text; },
  set text(lines) { editor.text = lines; read(); },
};
