// M, f, A and B in LaTeX, in symbols or as numbers.
import katex from 'katex';
import { digits } from './energy.js';

/// The LaTeX of a matrix, or a sentence if it is too long.
function matrix(name, { rows, columns, entries, operations }) {
  if (rows * columns === 0) return null;
  if (!entries) return { name, rows, columns, operations };
  const text = entries.map((each) => (typeof each === 'number' ? digits(each).replace('−', '-') : shortened(each)));
  const lines = Array.from({ length: rows }, (_, i) => text.slice(i * columns, (i + 1) * columns).join(' & '));
  return { name, latex: `${name} = \\begin{bmatrix} ${lines.join(' \\\\[2pt] ')} \\end{bmatrix}` };
}

/// LaTeX in which decimal numbers have at most four significant digits.
function shortened(latex) {
  return latex.replace(/\d+\.\d{4,}/g, (number) => String(Number(Number(number).toPrecision(4))));
}

const column = (all) => `\\begin{bmatrix} ${all.join(' \\\\ ')} \\end{bmatrix}`;

function headings(model) {
  const free = (all) => all.filter((each) => !each.dependent).map((each) => each.latex);
  const rates = free(model.speeds).map((each) => each.replace(/^(\\mathrm\{[^}]*\}|\\?\w+?)(?=_|$)/, '\\dot{$1}'));
  const state = [...free(model.coordinates), ...free(model.speeds)];
  const inputs = model.inputs.map((each) => each.latex);
  return {
    moving: `M \\dot u = f, \\qquad \\dot u = ${column(rates)}`,
    linear: `\\delta\\dot x = A\\,\\delta x${inputs.length ? ' + B\\,\\delta r' : ''}, \\qquad x = ${column(state)}` +
      (inputs.length ? `, \\quad r = ${column(inputs)}` : ''),
  };
}

function equationsOf(engine, isLinear, entries) {
  try {
    return engine.equations(isLinear, entries);
  } catch (error) {
    return { mistake: error.message };
  }
}

export function showEquations(element, engine, model, { isLinear, entries }) {
  const answer = equationsOf(engine, isLinear, entries);
  if (answer.mistake) {
    element.replaceChildren(Object.assign(document.createElement('p'), { className: 'long', textContent: answer.mistake }));
    return '';
  }
  const heading = headings(model)[isLinear ? 'linear' : 'moving'];
  const formulas = Object.entries(answer).map(([name, each]) => matrix(name, each)).filter(Boolean);
  element.replaceChildren(formula(heading, 'heading'), ...formulas.map((each) => (
    each.latex ? formula(each.latex, 'formula') : sentence(each))));
  return [heading, ...formulas.filter((each) => each.latex).map((each) => each.latex)].join('\n\n');
}

function formula(latex, kind) {
  const block = document.createElement('div');
  block.className = kind;
  block.dataset.latex = latex;
  katex.render(latex, block, { displayMode: true, throwOnError: false, strict: false });
  return block;
}

function sentence({ name, rows, columns, operations }) {
  const text = document.createElement('p');
  text.className = 'long';
  text.textContent = `${name} is a ${rows} × ${columns} matrix with ${operations} operations, too long to read here. ` +
    'The files to take away contain it, and so do the numbers.';
  return text;
}
