// A plane with a grid that fades out, and the shadows on it.
import { Color, Group, Mesh, PlaneGeometry, ShaderMaterial, ShadowMaterial } from 'three';

const vertexShader = `
varying vec2 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

const fragmentShader = `
varying vec2 place;
uniform vec2 middle;
uniform float cell, reach;
uniform vec3 colour;
float lines(float size) {
  vec2 at = place / size;
  vec2 width = fwidth(at);
  vec2 near = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
  vec2 line = (1.0 - clamp(near - 0.35, 0.0, 1.0)) * (1.0 - smoothstep(0.15, 0.6, width));
  return max(line.x, line.y);
}
void main() {
  float fade = 1.0 - smoothstep(0.1 * reach, 0.9 * reach, distance(place, middle));
  float strength = max(0.2 * lines(cell), 0.42 * lines(5.0 * cell));
  gl_FragColor = vec4(colour, strength * fade);
}`;

/// 1, 2 or 5 times a power of ten.
function niceCell(size) {
  const power = 10 ** Math.floor(Math.log10(size));
  return power * [1, 2, 5, 10].find((step) => step * power >= size * 0.999);
}

export function ground(height, size) {
  const reach = 11 * size;
  const grid = new Mesh(
    new PlaneGeometry(2 * reach, 2 * reach).rotateX(-Math.PI / 2),
    new ShaderMaterial({
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      side: 2,
      uniforms: {
        middle: { value: [0, 0] },
        cell: { value: niceCell(size / 4) },
        reach: { value: reach },
        colour: { value: new Color('#8b939a') },
      },
    }),
  );
  const shadow = new Mesh(
    new PlaneGeometry(8 * size, 8 * size).rotateX(-Math.PI / 2),
    new ShadowMaterial({ opacity: 0.2, depthWrite: false }),
  );
  shadow.receiveShadow = true;
  const both = new Group();
  both.add(grid, shadow);
  both.follow = (target) => {
    both.position.set(target.x, height - 2e-3 * size, target.z);
    grid.material.uniforms.middle.value = [target.x, target.z];
  };
  return both;
}
