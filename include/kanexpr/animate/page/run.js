// One run: its tracks, and its shapes as objects.
import { Color, Group } from 'three';
import { Anchor, moment, tracksOf } from './motion.js';
import { paletteColour } from './materials.js';
import { objectOf } from './shapes.js';

/// The first run has the colours of the picture; the others are translucent, each in one colour.
export function colourOfRun(index) {
  return index === 0 ? undefined : paletteColour(index);
}

function tint(object, colour) {
  object.traverse((part) => {
    part.castShadow = false;
    for (const made of [part.material ?? []].flat()) {
      made.color.lerp(new Color(colour), 0.75);
      made.opacity *= 0.55;
      made.transparent = true;
    }
  });
}

export class Run {
  constructor({ name, times, tracks, bendings, shapes }, meshes, number) {
    this.name = name;
    this.times = times;
    this.shapes = shapes;
    this.tracks = tracksOf(tracks, bendings);
    this.bends = false;
    this.objects = shapes.map((shape, index) => this.#object(shape, index, meshes));
    this.solids = this.objects.filter((_, index) => shapes[index].kind !== 'trace' && !shapes[index].layer);
    if (number > 0) for (const object of this.objects) tint(object, colourOfRun(number));
    this.all = new Group();
    this.all.add(...this.objects.map((object) => object.holder ?? object));
  }

  /// A shape of a layer is in a group, which is invisible while the layer is switched off.
  #object(shape, index, meshes) {
    const anchors = shape.anchors.map((anchor) => new Anchor(anchor, this.tracks));
    this.bends ||= anchors.some((anchor) => anchor.isDeformed);
    const object = objectOf({ ...shape, anchors, path: () => this.#path(anchors[0]) }, index, meshes);
    object.shape = shape;
    object.run = this;
    if (shape.layer) object.holder = new Group().add(object);
    return object;
  }

  /// The position of an anchor at all times, as one list of numbers.
  #path(anchor) {
    const count = anchor.track.isFixed ? 1 : this.times.length;
    const rows = [];
    for (let index = 0; index < count; ++index) {
      anchor.track.show({ index, part: 0 });
      rows.push(...anchor.position(anchor.at.clone()));
    }
    return rows;
  }

  show(time) {
    const now = moment(this.times, time);
    for (const track of this.tracks) track.show(now);
    for (const object of this.objects) object.show(now);
  }
}
