// The values of inputs, state and parameters, which change the model while it moves.
import katex from 'katex';

/// A slider from none to twice the value, or around zero, and a field for any number.
function row(symbol, value, set) {
  const line = document.createElement('div');
  line.className = 'value';
  const name = document.createElement('span');
  katex.render(symbol.latex, name);
  const slider = document.createElement('input');
  const span = value === 0 ? 10 : 2 * Math.abs(value);
  Object.assign(slider, { type: 'range', min: value > 0 ? span / 1000 : -span, max: span, step: span / 1000, value });
  slider.setAttribute('aria-label', symbol.name);
  const field = document.createElement('input');
  Object.assign(field, { type: 'number', step: 'any', value });
  field.setAttribute('aria-label', `${symbol.name}, exactly`);
  slider.oninput = () => { field.value = Number(slider.value).toPrecision(4); set(Number(slider.value)); };
  field.oninput = () => {
    if (field.value === '' || !Number.isFinite(field.valueAsNumber)) return;
    slider.value = field.value;
    set(field.valueAsNumber);
  };
  line.append(name, slider, field);
  return line;
}

export function showValues(element, engine, model, onChange) {
  const states = [...model.coordinates, ...model.speeds];
  const group = (title, symbols, numbers) => {
    if (symbols.length === 0) return [];
    const heading = document.createElement('h3');
    heading.textContent = title;
    return [heading, ...symbols.map((symbol, i) => row(symbol, numbers()[i], (value) => {
      numbers()[i] = value;
      onChange();
    }))];
  };
  element.replaceChildren(
    ...group('Inputs', model.inputs, () => engine.inputs(model.inputs.length)),
    ...group('State', states, () => engine.state(states.length)),
    ...group('Parameters', model.parameters, () => engine.parameters(model.parameters.length)));
  states.forEach((symbol) => {
    for (const each of element.querySelectorAll('input')) {
      if (each.getAttribute('aria-label')?.split(',')[0] === symbol.name) each.dataset.state = symbol.name;
    }
  });
}

/// Shows the state of this moment in its rows, except in the one that is being edited.
export function showState(element, engine, model) {
  const symbols = [...model.coordinates, ...model.speeds], numbers = engine.state(symbols.length);
  symbols.forEach((symbol, i) => {
    for (const each of element.querySelectorAll(`[data-state="${symbol.name}"]`))
      if (each !== document.activeElement) each.value = Number(numbers[i].toPrecision(5));
  });
}
