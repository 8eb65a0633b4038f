// Files to take away: C++ words, C, and the sources of an FMU.
import { strToU8, zipSync } from 'fflate';

const midnightOf1980 = new Date(1980, 0, 1);

/// An archive without compression and dates: the same model gives the same bytes.
function archive(files) {
  const entries = Object.fromEntries(files.map(({ path, text }) => [path, strToU8(text)]));
  return zipSync(entries, { level: 0, mtime: midnightOf1980 });
}

function save(name, bytes, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/// The model as text, for the page to show.
export function wordsOf(engine, name) { return engine.take('words', name)[0].text; }

export function download(engine, kind, name) {
  const files = engine.take(kind, name);
  if (kind === 'words') save(`${name}.hpp`, files[0].text, 'text/plain');
  if (kind === 'c') save(`${name}_c.zip`, archive(files), 'application/zip');
  if (kind === 'fmu') save(`${name}.fmu`, archive(files), 'application/zip');
}

/// A name for files and namespaces: letters, digits and underscores.
export function identifier(title) {
  const letters = title.trim().replace(/[\W_]+/g, '_').replace(/^_|_$/g, '');
  return letters.replace(/^(?=\d)/, 'n') || 'model';
}
