// The materials of shapes.
import { Color, MeshStandardMaterial } from 'three';

const palette = ['#4a7fb5', '#d0694a', '#6f9e54', '#dfa63c', '#8568ae', '#3a9d93', '#99705a', '#687488'];

export function paletteColour(index) {
  return palette[index % palette.length];
}

/// Shapes without a specified colour take these in turn.
export function colourOf(shape, index) {
  return new Color(shape.colour ?? paletteColour(index));
}

export function material(colour, opacity = 1) {
  return new MeshStandardMaterial({
    color: colour,
    roughness: 0.5,
    metalness: 0.05,
    opacity,
    transparent: opacity < 1,
    depthWrite: opacity === 1,
  });
}

export function lighter(colour, part) {
  return colour.clone().lerp(new Color('#ffffff'), part);
}

export function darker(colour, part) {
  return colour.clone().lerp(new Color('#14181c'), part);
}
