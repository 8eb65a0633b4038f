// The engine of kanexpr in WebAssembly: texts and numbers instead of addresses.
const encoder = new TextEncoder(), decoder = new TextDecoder();

/// What the C library asks of an operating system; the engine neither reads nor writes files.
function system(memory) {
  const unsupported = 52;
  const known = {
    proc_exit(code) { throw new Error(`the engine ended with code ${code}`); },
    clock_time_get(id, precision, at) {
      new DataView(memory().buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    environ_sizes_get(count, size) {
      const view = new DataView(memory().buffer);
      view.setUint32(count, 0, true), view.setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
  };
  return new Proxy({}, { get: (_, name) => known[name] ?? (() => unsupported), has: () => true });
}

const tooLarge = 'this model is too large for this page';

/// Opens the engine from its compressed bytes as base64.
export async function openEngine(packed) {
  const zipped = Uint8Array.fromBase64?.(packed) ?? Uint8Array.from(atob(packed), (each) => each.charCodeAt(0));
  const bytes = await new Response(new Blob([zipped]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  const module = await WebAssembly.compile(bytes);
  const prepare = () => {
    let engine;
    const imports = { wasi_snapshot_preview1: system(() => engine.memory) };
    const begin = ({ exports }) => { engine = exports, engine._initialize?.(); return engine; };
    return { imports, begin };
  };
  const start = () => {
    const { imports, begin } = prepare();
    return begin(new WebAssembly.Instance(module, imports));
  };
  const { imports, begin } = prepare();
  return new Engine(begin(await WebAssembly.instantiate(module, imports)), start);
}

/// A function that fails, since the stack or the memory does not suffice, leaves the engine unusable. Another one
/// takes its place, with the last valid model at its start, and the caller gets a sentence.
class Engine {
  #start;
  #wasm;
  #last = '';

  /// `start` returns another engine at once.
  constructor(wasm, start) {
    this.#start = start;
    this.#wasm = this.#guarded(wasm);
  }

  #guarded(exports) {
    return new Proxy({}, {
      get: (_, name) => (typeof exports[name] !== 'function' ? exports[name] : (...values) => {
        try {
          return exports[name](...values);
        } catch {
          this.#wasm = this.#guarded(this.#start());
          const last = this.#last;
          this.#last = ''; // so that it is tried once
          if (last) this.read(last);
          throw new Error(tooLarge);
        }
      }),
    });
  }

  /// The words of lines and the functions, for the editor.
  vocabulary() { return JSON.parse(this.#text(this.#wasm.vocabulary())); }

  /// Builds and derives a model. A model with a mistake leaves the last one in place.
  read(text) {
    try {
      const answer = JSON.parse(this.#call('read', text));
      if (!answer.mistake) this.#last = text;
      return answer;
    } catch (error) {
      return { mistake: { line: 0, sentence: error.message } };
    }
  }
  /// M and f, or A and B; `entries` are symbols, numbers, or symbolsHere: the state as numbers.
  equations(areLinearized, entries) {
    const shown = ['symbols', 'numbers', 'symbolsHere'].indexOf(entries);
    return JSON.parse(this.#text(this.#wasm.equations(areLinearized ? 1 : 0, shown)));
  }

  get time() { return this.#wasm.time(); }
  set time(t) { this.#wasm.set_time(t); }
  get energy() { return { kinetic: this.#wasm.kinetic_energy(), potential: this.#wasm.potential_energy() }; }
  /// `state(4)[0] = 1` sets the first coordinate; likewise parameters and inputs.
  state(count) { return this.#numbers(this.#wasm.state(), count); }
  parameters(count) { return this.#numbers(this.#wasm.parameters(), count); }
  inputs(count) { return this.#numbers(this.#wasm.inputs(), count); }

  satisfyConstraints() { return this.#wasm.satisfy_constraints() !== 0; }
  /// Returns why the motion ends, or nothing.
  advance(duration, step) { return this.#text(this.#wasm.advance(duration, step)); }

  svg(hasLabels) { return this.#text(this.#wasm.svg(hasLabels ? 1 : 0)); }
  points(count) {
    const all = this.#numbers(this.#wasm.points(), 2 * count);
    return Array.from({ length: count }, (_, i) => [all[2 * i], all[2 * i + 1]]);
  }
  drag(point, x, y) { this.#wasm.drag(point, x, y); }
  turn(azimuth, elevation) { this.#wasm.turn(azimuth, elevation); }

  /// The files of a model: kind is words, c or fmu. Throws the sentence that says why there are none.
  take(kind, name) {
    const { mistake, files } = JSON.parse(this.#call(`take_${kind}`, name));
    if (mistake) throw new Error(mistake);
    return files;
  }

  #numbers(at, count) { return new Float64Array(this.#wasm.memory.buffer, at, count); }
  #text(at) {
    const bytes = new Uint8Array(this.#wasm.memory.buffer, at);
    return decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
  }
  #call(name, text) {
    const bytes = encoder.encode(text.replaceAll('\0', '␀')); // a zero byte would end the text
    const at = this.#wasm.allocate(bytes.length + 1);
    const there = new Uint8Array(this.#wasm.memory.buffer, at, bytes.length + 1);
    there.set(bytes), there[bytes.length] = 0;
    const answer = this.#text(this.#wasm[name](at));
    this.#wasm.release(at);
    return answer;
  }
}
