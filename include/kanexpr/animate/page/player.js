// The time that is shown, and its playback.

const longestFrame = 0.25; // in seconds; a page that was hidden continues where it was
export class Player {
  constructor(first, last, changed) {
    this.first = first;
    this.last = last;
    this.speed = 1;
    this.loops = false;
    this.time = first;
    this.playing = false;
    this.changed = changed;
  }

  seek(t) {
    this.time = Math.min(this.last, Math.max(this.first, Number(t)));
    this.changed();
  }

  play() {
    if (this.playing || this.last <= this.first) return;
    if (this.time >= this.last) this.time = this.first;
    this.playing = true;
    this.before = undefined;
    requestAnimationFrame((now) => this.#step(now));
    this.changed();
  }

  pause() {
    this.playing = false;
    this.changed();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  #step(now) {
    if (!this.playing) return;
    const passed = Math.min(longestFrame, (now - (this.before ?? now)) / 1000);
    this.before = now;
    this.time += passed * this.speed;
    if (this.time >= this.last && this.loops)
      this.time = this.first + ((this.time - this.first) % (this.last - this.first));
    this.time = Math.min(this.last, this.time);
    if (this.time >= this.last) this.playing = false;
    else requestAnimationFrame((later) => this.#step(later));
    this.changed();
  }
}
