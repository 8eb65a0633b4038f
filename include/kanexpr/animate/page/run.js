// One run: its tracks, and its shapes as objects.
import { Anchor, moment, Track } from './motion.js';
import { objectOf } from './shapes.js';

export class Run {
  constructor({ times, tracks, shapes }, meshes) {
    this.times = times;
    this.shapes = shapes;
    this.tracks = tracks.map((track) => new Track(track));
    this.objects = shapes.map((shape, index) => {
      const anchors = shape.anchors.map((anchor) => new Anchor(anchor, this.tracks));
      return objectOf({ ...shape, anchors, path: () => this.#path(anchors[0]) }, index, meshes);
    });
    this.solids = this.objects.filter((_, index) => shapes[index].kind !== 'trace');
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
