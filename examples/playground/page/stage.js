// The figure: fits it, drags its points, and turns the view of spatial models.
const reach = 34; // pixels on the screen within which a point is grasped

export class Stage {
  /// Calls `onDrag` when a point has moved, and `onTurn` when only the view or a mark has changed.
  constructor(element, engine, { onDrag, onTurn }) {
    Object.assign(this, { element, engine, onDrag, onTurn, model: null, turned: [0, 0], trace: [] });
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

  /// The view grows with the motion and does not shrink, so that the ground stands still; a system that goes far
  /// away is followed instead.
  #fit(figure, [x, y, width, height]) {
    const next = { left: x, top: y, right: x + width, bottom: y + height };
    this.box ??= this.#first(next);
    const box = this.box;
    for (const [low, high, most] of [['left', 'right', this.most.width], ['top', 'bottom', this.most.height]]) {
      const goesHigher = next[high] > box[high], goesLower = next[low] < box[low];
      box[low] = Math.min(box[low], next[low]);
      box[high] = Math.max(box[high], next[high]);
      if (goesHigher) box[low] = Math.max(box[low], box[high] - most);
      if (goesLower) box[high] = Math.min(box[high], box[low] + most);
    }
    const margin = 0.04 * Math.max(box.right - box.left, box.bottom - box.top);
    figure.setAttribute('viewBox', [box.left - margin, box.top - margin, box.right - box.left + 2 * margin,
      box.bottom - box.top + 2 * margin].join(' '));
    figure.removeAttribute('width'), figure.removeAttribute('height');
  }

  /// The first view: the figure with some room on the other side of the origin, where a pendulum will swing.
  #first(box) {
    const width = box.right - box.left, height = box.bottom - box.top, least = 160;
    this.most = { width: 3 * Math.max(width, height), height: 3 * Math.max(width, height) };
    if (!this.model.planar || height < 0.4 * width) {
      const room = Math.max(0, least - height) / 2;
      return { ...box, top: box.top - room, bottom: box.bottom + room };
    }
    const half = 0.55 * Math.max(-box.left, box.right);
    return { ...box, left: Math.min(box.left, -half), right: Math.max(box.right, half) };
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
    if (this.held !== undefined) this.onTurn();
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
      this.onTurn();
    } else {
      const near = this.#pointNear(event);
      this.element.style.cursor = near !== undefined ? 'grab' : this.model.planar ? 'default' : 'move';
      if (near !== this.near) this.near = near, this.onTurn();
    }
  }
  #release() {
    const moved = this.held !== undefined;
    this.held = this.from = undefined;
    if (moved) this.onDrag();
  }
}
