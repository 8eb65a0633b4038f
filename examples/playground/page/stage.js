// The figure: fits it, drags its points, and turns the view of spatial models.
const reach = 34; // pixels on the screen within which a point is grasped

export class Stage {
  constructor(element, engine, { onDrag, onRelease }) {
    Object.assign(this, { element, engine, onDrag, onRelease, model: null, turned: [0, 0], trace: [] });
    element.addEventListener('pointerdown', (event) => this.#press(event));
    element.addEventListener('pointermove', (event) => this.#move(event));
    for (const end of ['pointerup', 'pointercancel']) element.addEventListener(end, () => this.#release());
  }

  /// Shows a model from its first view.
  open(model) {
    this.model = model;
    this.box = null;
    this.turned = [0, 0];
    this.trace = [];
  }

  draw(hasLabels) {
    const svg = this.engine.svg(hasLabels);
    if (!svg) return;
    this.element.innerHTML = svg;
    const figure = this.element.firstElementChild;
    this.#fit(figure, figure.getAttribute('viewBox').split(' ').map(Number));
    if (hasLabels) this.trace = [];
    else this.#follow(figure);
    this.#mark(figure);
  }

  /// The view grows with the motion and never shrinks, so that the ground stands still.
  #fit(figure, [x, y, width, height]) {
    const next = { left: x, top: y, right: x + width, bottom: y + height };
    if (!this.box) {
      const half = Math.max(-next.left, next.right); // as far to the left as to the right of the origin
      this.box = next;
      if (this.model.planar && height > 0.4 * width) Object.assign(this.box, { left: -half, right: half });
    }
    const box = this.box;
    for (const side of ['left', 'top']) box[side] = Math.min(box[side], next[side]);
    for (const side of ['right', 'bottom']) box[side] = Math.max(box[side], next[side]);
    const margin = 0.04 * Math.max(box.right - box.left, box.bottom - box.top);
    figure.setAttribute('viewBox', [box.left - margin, box.top - margin, box.right - box.left + 2 * margin,
      box.bottom - box.top + 2 * margin].join(' '));
    figure.removeAttribute('width'), figure.removeAttribute('height');
  }

  /// The path of the last point.
  #follow(figure) {
    const points = this.engine.points(this.model.points.length);
    this.trace.push(points[points.length - 1]);
    if (this.trace.length > 240) this.trace.shift();
    if (this.trace.length < 2) return;
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('class', 'trace');
    path.setAttribute('d', 'M' + this.trace.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L'));
    figure.prepend(path);
  }

  /// A ring around the point under the pointer.
  #mark(figure) {
    const point = this.held ?? this.near;
    if (point === undefined) return;
    const [x, y] = this.engine.points(this.model.points.length)[point];
    const ring = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
    for (const [name, value] of Object.entries({ class: 'ring', cx: x, cy: y, r: 11 })) ring.setAttribute(name, value);
    figure.append(ring);
  }

  #place(event) {
    const to = this.element.firstElementChild?.getScreenCTM();
    return to && new DOMPoint(event.clientX, event.clientY).matrixTransform(to.inverse());
  }
  #pointNear(event) {
    const to = this.element.firstElementChild?.getScreenCTM();
    if (!to) return undefined;
    let best, least = reach;
    this.engine.points(this.model.points.length).forEach(([x, y], i) => {
      const at = new DOMPoint(x, y).matrixTransform(to);
      const distance = Math.hypot(at.x - event.clientX, at.y - event.clientY);
      if (distance <= least) [best, least] = [i, distance];
    });
    return best;
  }

  #press(event) {
    if (!this.model) return;
    this.element.setPointerCapture(event.pointerId);
    this.held = this.#pointNear(event);
    this.from = this.held === undefined && !this.model.planar ? [event.clientX, event.clientY, ...this.turned] : null;
    if (this.held !== undefined) this.onDrag();
  }
  #move(event) {
    if (!this.model) return;
    if (this.held !== undefined) {
      const { x, y } = this.#place(event);
      this.engine.drag(this.held, x, y);
      this.onDrag();
    } else if (this.from) {
      const [x, y, azimuth, elevation] = this.from;
      this.turned = [azimuth - (event.clientX - x) / 160,
        Math.max(-1.5, Math.min(1, elevation + (event.clientY - y) / 160))];
      this.engine.turn(...this.turned);
      this.trace = [];
      this.onDrag(true);
    } else {
      const near = this.#pointNear(event);
      this.element.style.cursor = near !== undefined ? 'grab' : this.model.planar ? 'default' : 'move';
      if (near !== this.near) this.near = near, this.onDrag(true);
    }
  }
  #release() {
    const moved = this.held !== undefined;
    this.held = this.from = undefined;
    if (moved) this.onRelease();
  }
}
