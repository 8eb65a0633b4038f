// Meshes from the files that are embedded in the page.
import { BackSide, Box3, DoubleSide, Group, Mesh, Texture, Vector3 } from 'three';
import { ColladaComposer } from 'three/addons/loaders/collada/ColladaComposer.js';
import { ColladaParser } from 'three/addons/loaders/collada/ColladaParser.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { bytesOf } from './base64.js';
import { material } from './materials.js';

const noTextures = { load: () => new Texture() }; // textures are in separate files

function text(bytes) {
  return new TextDecoder().decode(bytes);
}

/// Reads a mesh in the axes of the file, regardless of the up axis that it declares, as robot descriptions
/// expect.
function dae(bytes) {
  const { library, asset, collada } = new ColladaParser().parse(text(bytes));
  const { scene } = new ColladaComposer(library, collada, noTextures, noTextures).compose();
  scene.scale.multiplyScalar(asset.unit);
  return scene;
}

/// Omits separate lines and points; otherwise, three.js would read faces as lines, too.
function obj(bytes) {
  return new OBJLoader().parse(text(bytes).replace(/^[lp]\s.*$/gm, ''));
}

/// Normals in such files are often zero.
function stl(bytes) {
  const geometry = new STLLoader().parse(bytes.buffer);
  geometry.computeVertexNormals();
  return new Mesh(geometry);
}

const readers = { dae, obj, stl };

export function trianglesIn({ geometry }) {
  return Math.floor((geometry.index ?? geometry.getAttribute('position')).count / 3);
}

/// The volume enclosed by triangles that face outward.
export function volumeOf(geometry) {
  const { index, attributes: { position } } = geometry;
  const corners = [0, 1, 2].map(() => new Vector3());
  let sum = 0;
  for (let k = 0; k < trianglesIn({ geometry }); ++k) {
    corners.forEach((corner, i) => corner.fromBufferAttribute(position, index ? index.getX(3 * k + i) : 3 * k + i));
    sum += corners[0].dot(corners[1].cross(corners[2])) / 6;
  }
  return sum;
}

/// The meshes in a file, without its lights, lines and cameras.
function partsOf({ kind, data }) {
  const whole = readers[kind](bytesOf(data));
  whole.updateMatrixWorld(true);
  const parts = [];
  whole.traverse((part) => {
    if (!part.isMesh || trianglesIn(part) === 0) return;
    if (!part.geometry.hasAttribute('normal')) part.geometry.computeVertexNormals();
    parts.push(part);
  });
  const box = parts.reduce((all, part) => all.expandByObject(part), new Box3());
  const numbers = [...box.min.toArray(), ...box.max.toArray()];
  if (!numbers.every(Number.isFinite)) throw new Error('it contains no triangles');
  return parts;
}

/// Only COLLADA specifies materials, often with a wrong opacity. Not all meshes have outward-facing triangles.
function surface(own, isColoured, colour, opacity) {
  const made = material(isColoured && !own.isMeshBasicMaterial ? own.color : colour, opacity);
  made.side = DoubleSide;
  made.shadowSide = BackSide; // avoids speckles from self-shadowing
  return made;
}

/// Reads each file once, when it is first needed.
export class Meshes {
  #files;
  #read = new Map();
  /// The names of files that cannot be shown.
  broken = [];

  constructor(files) {
    this.#files = new Map(files.map((file) => [file.name, file]));
  }

  #parts(name) {
    if (this.#read.has(name)) return this.#read.get(name);
    let parts = [];
    try {
      parts = partsOf(this.#files.get(name));
    } catch (error) {
      console.warn(`${name}: ${error.message}`);
      this.broken.push(name);
    }
    this.#read.set(name, parts);
    return parts;
  }

  object(shape, colour) {
    const scaled = new Group();
    scaled.scale.fromArray(shape.sizes);
    const isColoured = shape.colour === undefined && this.#files.get(shape.file).kind === 'dae';
    for (const part of this.#parts(shape.file)) {
      const surfaces = [part.material].flat().map((own) => surface(own, isColoured, colour, shape.opacity));
      const copy = new Mesh(part.geometry, Array.isArray(part.material) ? surfaces : surfaces[0]);
      copy.matrixAutoUpdate = false;
      copy.matrix.copy(part.matrixWorld);
      scaled.add(copy);
    }
    return new Group().add(scaled);
  }
}
