// The small form: adds a joint, a body or a load as a line of the text.
const suggestions = { scalar: '1', vector: 'N.z', scalars: '0, 0, 1', vectors: 'N.x, N.y', number: '0', letters: 'zxz' };

/// Opens the form for one group of words; `names` are the frames, points and symbols of the model so far.
export function openForm(dialog, { words }, group, names, add) {
  const choice = dialog.querySelector('select'), fields = dialog.querySelector('.fields');
  const meaning = dialog.querySelector('.meaning'), preview = dialog.querySelector('.preview');
  const offered = words.filter((each) => each.group === group);
  dialog.querySelector('h2').textContent = `Add a ${group.toLowerCase()}`;
  choice.replaceChildren(...offered.map(({ word }) => new Option(word.replaceAll('_', ' '), word)));
  const line = () => written(offered.find((each) => each.word === choice.value), fields);
  const update = () => { preview.textContent = line(); };
  const choose = () => {
    const word = offered.find((each) => each.word === choice.value);
    meaning.textContent = word.meaning;
    fields.replaceChildren(...parts(word.pattern).map((part) => field(part, names)));
    update();
  };
  choice.onchange = choose;
  fields.oninput = update;
  dialog.querySelector('form').onsubmit = () => add(line());
  choose();
  dialog.showModal();
}

/// The parts of a pattern: words that stay and slots; optional parts keep their brackets.
function parts(pattern) {
  return pattern.match(/\{[^}]*\}|\[|\]|[^\s[\]{}]+/g).map((text) => (
    text.startsWith('{') ? { slot: text.slice(1, -1) } : { text }));
}

function field(part, names) {
  if (!part.slot) {
    const fixed = document.createElement('span');
    fixed.textContent = part.text;
    if (part.text === '[' || part.text === ']') fixed.hidden = true;
    return fixed;
  }
  const known = names[part.slot];
  const input = document.createElement(known?.length ? 'select' : 'input');
  input.dataset.slot = part.slot;
  input.setAttribute('aria-label', part.slot);
  if (known?.length) input.replaceChildren(...known.map((name) => new Option(name)));
  else Object.assign(input, { placeholder: part.slot, value: suggestions[part.slot] ?? '', size: 8, autocapitalize: 'off' });
  return input;
}

/// The line; an optional part is left out if its first slot is empty.
function written(word, fields) {
  const out = [word.word];
  let optional = null;
  for (const each of fields.children) {
    const text = each.dataset.slot ? each.value.trim() : each.textContent;
    if (text === '[' && !each.dataset.slot) optional = [];
    else if (text === ']' && !each.dataset.slot) {
      if (optional.every((part) => part !== '')) out.push(...optional);
      optional = null;
    } else (optional ?? out).push(text);
  }
  return out.join(' ').replaceAll(' ,', ',').replaceAll(' :', ':');
}
