// The panels below the figure: equations, values, and files to take away.
import { showEquations } from './equations.js';
import { find } from './find.js';
import { download, identifier, wordsOf } from './take.js';
import { showState, showValues } from './values.js';

const isNarrow = () => matchMedia('(width < 820px)').matches;
const all = (selector) => document.querySelectorAll(selector);

export async function copy(button, content) {
  const label = button.textContent;
  await navigator.clipboard?.writeText(content).then(() => { button.textContent = 'Copied'; }, () => {});
  setTimeout(() => { button.textContent = label; }, 1200);
}

export class Results {
  latex = '';
  #model = null;
  #shown = 'moving';
  #entries = 'symbols';
  #nextNumbers = 0;

  /// Calls `onValues` when the reader has changed a value.
  constructor(engine, { onValues }) {
    Object.assign(this, { engine, onValues });
    for (const each of all('[data-show]')) each.onclick = () => this.#show(each.dataset.show);
    for (const each of all('[data-entries]')) each.onclick = () => this.#choose(each.dataset.entries);
    for (const each of all('[data-take]')) each.onclick = () => this.#take(each);
    find('copy-latex').onclick = (event) => copy(event.target, this.latex);
    find('copy-words').onclick = (event) => copy(event.target, find('words').textContent);
    find('name').oninput = () => this.update();
    this.#show(isNarrow() ? 'model' : 'moving');
  }

  open(model) {
    this.#model = model;
    this.update();
  }

  get name() { return identifier(find('name').value); }
  set name(title) { find('name').value = identifier(title.toLowerCase()); }

  get #showsFormulas() { return this.#shown === 'moving' || this.#shown === 'linear'; }

  /// Shows the chosen panel anew.
  update() {
    if (this.#shown === 'moving' && this.#entries === 'symbolsHere') this.#entries = 'symbols';
    for (const each of all('[data-entries]')) each.setAttribute('aria-pressed', String(each.dataset.entries === this.#entries));
    document.querySelector('[data-entries=symbolsHere]').hidden = this.#shown !== 'linear';
    find('formulas').hidden = !this.#showsFormulas;
    find('values').hidden = this.#shown !== 'values';
    find('take').hidden = this.#shown !== 'take';
    if (!this.#model) return;
    if (this.#showsFormulas) this.#showFormulas();
    if (this.#shown === 'values') showValues(find('values'), this.engine, this.#model, this.onValues);
    if (this.#shown === 'take') this.#showWords();
  }

  /// Shows what changes with the state, a few times in a second.
  follow(now, isMoving) {
    if (now < this.#nextNumbers && isMoving) return;
    this.#nextNumbers = now + 200;
    const changes = this.#entries === 'numbers' || (this.#entries === 'symbolsHere' && !isMoving);
    if (this.#shown === 'values') showState(find('values'), this.engine, this.#model);
    else if (this.#showsFormulas && changes) this.#showFormulas();
  }

  #show(tab) {
    if (tab !== 'model') this.#shown = tab;
    document.body.dataset.view = tab;
    for (const each of all('[data-show]')) {
      const isIt = each.dataset.show === (isNarrow() ? tab : this.#shown);
      each.setAttribute('aria-selected', String(isIt));
      if (isIt) each.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    }
    this.update();
  }

  #choose(entries) {
    this.#entries = entries;
    this.update();
  }

  #showFormulas() {
    const how = { isLinear: this.#shown === 'linear', entries: this.#entries };
    this.latex = showEquations(find('equations'), this.engine, this.#model, how);
  }

  #showWords() {
    this.#say('');
    find('words').textContent = '';
    try {
      find('words').textContent = wordsOf(this.engine, this.name);
    } catch (error) {
      this.#say(error.message, true);
    }
  }

  #take(button) {
    try {
      download(this.engine, button.dataset.take, this.name);
      this.#say(`Saved as ${button.textContent}`);
    } catch (error) {
      this.#say(error.message, true);
    }
  }
  #say(text, isWrong = false) {
    find('taken').textContent = text;
    find('taken').classList.toggle('wrong', isWrong);
  }
}
