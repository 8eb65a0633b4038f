// Kinetic, potential and total energy of the last seconds, as bands and a line.
const kept = 300;

export class EnergyChart {
  constructor(canvas, readout) { Object.assign(this, { canvas, readout, samples: [] }); }

  restart() { this.samples = []; }

  add(t, { kinetic, potential }) {
    this.samples.push([t, kinetic, potential]);
    if (this.samples.length > kept) this.samples.shift();
  }

  draw() {
    const { samples, canvas } = this;
    const scale = devicePixelRatio, width = canvas.clientWidth, height = canvas.clientHeight;
    if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
    if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
    const paper = canvas.getContext('2d');
    paper.setTransform(scale, 0, 0, scale, 0, 0);
    paper.clearRect(0, 0, width, height);
    if (samples.length === 0) return;
    const all = samples.flatMap(([, T, V]) => [T, V, T + V]);
    const least = Math.min(0, ...all), most = Math.max(0, ...all, least + 1e-9);
    const y = (value) => height - 3 - ((value - least) / (most - least)) * (height - 6);
    const x = (i) => (i / (Math.max(samples.length, 60) - 1)) * width;
    const style = getComputedStyle(canvas);
    const curve = (value, color, thickness) => {
      paper.beginPath();
      samples.forEach((sample, i) => paper[i === 0 ? 'moveTo' : 'lineTo'](x(i), y(value(sample))));
      Object.assign(paper, { strokeStyle: style.getPropertyValue(color), lineWidth: thickness, lineJoin: 'round' });
      paper.stroke();
    };
    curve(([, T]) => T, '--kinetic', 1.5);
    curve(([, , V]) => V, '--potential', 1.5);
    curve(([, T, V]) => T + V, '--ink', 2);
    const [, T, V] = samples[samples.length - 1];
    for (const [name, value] of Object.entries({ T, V, E: T + V }))
      this.readout.querySelector(`[data-energy=${name}]`).textContent = digits(value);
  }
}

export function digits(value) {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  return (size >= 1e5 || size < 1e-3 ? value.toExponential(3) : value.toPrecision(5)).replace('-', '−');
}
