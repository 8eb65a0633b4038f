// The columns of all runs, matched by their names.
import { paletteColour } from './materials.js';

/// Each quantity has a name, a unit, a group such as "Speeds", a colour, and its column in each run that has
/// one.
export function quantitiesOf(runs) {
  const found = [];
  runs.forEach((run, k) => {
    for (const column of run.columns) {
      const { name, unit = '', group } = column;
      let one = found.find((other) => other.name === name && other.unit === unit && other.group === group);
      if (!one) found.push((one = { name, unit, group, columns: [], colour: paletteColour(found.length) }));
      one.columns[k] = column;
    }
  });
  return found;
}

export function title({ name, unit }) {
  return unit ? `${name} [${unit}]` : name;
}
