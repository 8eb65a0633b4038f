// Recording of the picture: as a video while it plays, or as evenly spaced frames.
import { zipSync } from 'fflate';
import { bytesOf } from './base64.js';

const element = (id) => document.getElementById(id);

/// A canvas without transparency, on which the picture is copied.
class Paper {
  constructor(source) {
    this.source = source;
    this.canvas = document.createElement('canvas');
    this.canvas.width = source.width - (source.width % 2); // as video encoders require
    this.canvas.height = source.height - (source.height % 2);
    this.context = this.canvas.getContext('2d');
  }

  paint() {
    const { width, height } = this.canvas;
    const style = getComputedStyle(document.documentElement);
    const shade = this.context.createRadialGradient(
      width / 2, 0.35 * height, 0, width / 2, 0.35 * height, 0.75 * Math.max(width, height));
    ['--middle', '--rim', '--edge'].forEach((name, i) =>
      shade.addColorStop([0, 0.6, 1][i], style.getPropertyValue(name)));
    this.context.fillStyle = shade;
    this.context.fillRect(0, 0, width, height);
    this.context.drawImage(this.source, 0, 0);
  }
}

function save(blob, name) {
  const link = Object.assign(document.createElement('a'), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/// The title as the name of a file.
function fileName(title) {
  return title.replace(/[^\p{L}\p{N}.-]+/gu, '_').replace(/^[_.]+|_+$/g, '').slice(0, 80) || 'motion';
}

function videoType() {
  return ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm']
    .find((type) => window.MediaRecorder?.isTypeSupported(type));
}

export class Recorder {
  #stopped = true;
  #paper;

  /// `show` draws the time of the player.
  constructor(source, player, show, title) {
    Object.assign(this, { source, player, show, name: fileName(title) });
    element('video').disabled = videoType() === undefined;
    element('video').addEventListener('click', () => this.#run(() => this.#video()));
    element('frames').addEventListener('click', () => this.#run(() => this.#frames()));
    element('stop').addEventListener('click', () => (this.#stopped = true));
  }

  /// Copies the picture to the recording, if there is one. Called after each drawing.
  drawn() {
    this.#paper?.paint();
  }

  async #run(record) {
    const { time, loops } = this.player;
    this.#stopped = false;
    this.player.loops = false;
    this.player.pause();
    this.#paper = new Paper(this.source);
    this.#offer(false);
    try {
      await record();
    } catch (error) {
      element('progress').textContent = `The recording failed: ${error.message}`;
    }
    this.#paper = undefined;
    this.#offer(true);
    this.player.pause();
    this.player.loops = loops;
    this.player.seek(time);
  }

  #offer(isIdle) {
    for (const id of ['video', 'frames']) element(id).hidden = !isIdle;
    element('stop').hidden = isIdle;
  }

  #tell(sentence) {
    element('progress').textContent = sentence;
  }

  async #video() {
    const { player } = this;
    player.seek(player.first);
    this.show();
    const stream = this.#paper.canvas.captureStream(Number(element('rate').value));
    const recorder = new MediaRecorder(stream, { mimeType: videoType(), videoBitsPerSecond: 12e6 });
    const pieces = [];
    recorder.addEventListener('dataavailable', ({ data }) => pieces.push(data));
    const end = new Promise((resolve) => recorder.addEventListener('stop', resolve));
    recorder.start();
    player.play();
    this.#tell('Recording the video.');
    while (player.playing && !this.#stopped) await new Promise(requestAnimationFrame);
    await new Promise((resolve) => setTimeout(resolve, 100)); // for the last frame
    recorder.stop();
    await end;
    for (const track of stream.getTracks()) track.stop();
    save(new Blob(pieces, { type: 'video/webm' }), `${this.name}.webm`);
    this.#tell(`Saved ${this.name}.webm.`);
  }

  async #frames() {
    const { player } = this;
    const step = player.speed / Number(element('rate').value);
    const count = Math.floor((player.last - player.first) / step + 1e-9) + 1;
    const files = {};
    for (let k = 0; k < count && !this.#stopped; ++k) {
      player.seek(player.first + k * step);
      this.show();
      const image = this.#paper.canvas.toDataURL('image/png'); // toBlob waits until the browser is idle
      const number = String(k + 1).padStart(String(count).length, '0');
      files[`${this.name}_${number}.png`] = bytesOf(image.slice(image.indexOf(',') + 1));
      this.#tell(`Frame ${k + 1} of ${count}.`);
      await new Promise((resolve) => setTimeout(resolve)); // shows the progress, and lets the user stop
    }
    if (this.#stopped) return this.#tell('Stopped.');
    save(new Blob([zipSync(files, { level: 0 })], { type: 'application/zip' }), `${this.name}.zip`);
    return this.#tell(`Saved ${count} frames in ${this.name}.zip.`);
  }
}
