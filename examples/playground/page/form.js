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

/// The frames and points that a text declares, for the fields of the form.
export function namesIn(text) {
  const names = { frame: /^\s*inertial\b/m.test(text) ? [] : ['N'], point: [] };
  const kinds = { frame: ['inertial', 'pin', 'rotated', 'body_fixed', 'space_fixed'], point: ['origin', 'offset', 'slider'] };
  for (const [, word, name] of text.matchAll(/^\s*(\w+)\s+(\w+)/gm))
    for (const kind of Object.keys(kinds)) if (kinds[kind].includes(word)) names[kind].push(name);
  return names;
}

/// The parts of a pattern: words that stay and slots. Parts in brackets are optional.
function parts(pattern) {
  let isOptional = false;
  return pattern.match(/\{[^}]*\}|\[|\]|[^\s[\]{}]+/g).map((text) => {
    if (text === '[' || text === ']') isOptional = text === '[';
    return text.startsWith('{') ? { slot: text.slice(1, -1), isOptional } : { text };
  });
}

function field({ text, slot, isOptional }, names) {
  if (!slot) return Object.assign(document.createElement('span'), { textContent: text, hidden: text === '[' || text === ']' });
  const known = names[slot];
  const input = document.createElement(known?.length ? 'select' : 'input');
  input.dataset.slot = slot;
  input.required = !isOptional;
  input.setAttribute('aria-label', slot);
  if (known?.length) {
    input.replaceChildren(...(isOptional ? [''] : []).concat(known).map((name) => new Option(name)));
    if (!isOptional) input.value = known[known.length - 1];
  } else {
    Object.assign(input, { placeholder: slot, size: 8, autocapitalize: 'off', value: isOptional ? '' : suggestions[slot] ?? '' });
  }
  return input;
}

/// The line; an optional part is left out if one of its slots is empty.
function written(word, fields) {
  const out = [word.word];
  let optional = null;
  for (const each of fields.children) {
    const { slot } = each.dataset;
    const text = slot ? each.value.trim() : each.textContent;
    if (!slot && text === '[') optional = [];
    else if (!slot && text === ']') {
      if (!optional.includes('')) out.push(...optional);
      optional = null;
    } else if (optional) optional.push(text);
    else out.push(text || `<${slot}>`);
  }
  return out.join(' ').replaceAll(' ,', ',').replaceAll(' :', ':');
}
