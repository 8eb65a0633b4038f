// The outlines of profiles, counterclockwise about the z axis. An outline is a list of smooth strips of vertices
// [x, y, outward normal x, y]; the edges between strips are sharp.

function polygon(corners) {
  return corners.map(([x, y], i) => {
    const [nextX, nextY] = corners[(i + 1) % corners.length];
    const length = Math.hypot(nextX - x, nextY - y) || 1;
    const normal = [(nextY - y) / length, (x - nextX) / length];
    return [[x, y, ...normal], [nextX, nextY, ...normal]];
  });
}

function circle([radius]) {
  const sides = 24;
  return [Array.from({ length: sides + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / sides;
    const [x, y] = [Math.cos(angle), Math.sin(angle)];
    return [radius * x, radius * y, x, y];
  })];
}

function rectangle([width, height]) {
  const [x, y] = [width / 2, height / 2];
  return polygon([[x, -y], [x, y], [-x, y], [-x, -y]]);
}

function iSection([width, height, thickness]) {
  const [x, y] = [width / 2, height / 2];
  const web = Math.min(thickness / 2, 0.999 * x);
  const flange = y - Math.min(thickness, 0.999 * y); // where it begins
  const right = [[x, -y], [x, -flange], [web, -flange], [web, flange], [x, flange], [x, y]];
  return polygon([...right, ...right.map(([a, b]) => [-a, -b])]);
}

/// Half the thickness of a NACA four-digit airfoil and its slope, for chord 1, thickness 1 and a closed trailing edge.
function naca(x) {
  const half = 5 * (0.2969 * Math.sqrt(x) - x * (0.126 + x * (0.3516 - x * (0.2843 - 0.1036 * x))));
  const slope = 5 * (0.14845 / Math.sqrt(x) - 0.126 - x * (0.7032 - x * (0.8529 - 0.4144 * x)));
  return [half, slope];
}

function airfoil([chord, thickness]) {
  const steps = 20;
  return [Array.from({ length: 2 * steps + 1 }, (_, i) => {
    const x = (1 + Math.cos((Math.PI * i) / steps)) / 2; // dense at both edges
    const side = i <= steps ? 1 : -1;
    if (i === steps) return [-chord / 4, 0, -1, 0];
    const [half, slope] = naca(x);
    const normal = [-thickness * slope, chord];
    const length = Math.hypot(...normal);
    return [(x - 0.25) * chord, side * half * thickness, normal[0] / length, (side * normal[1]) / length];
  })];
}

const outlineOf = { circle, rectangle, i_section: iSection, airfoil };
const sizesOf = { circle: 1, rectangle: 2, i_section: 3, airfoil: 2 };

/// The outlines at the first and the last place, which are equal unless there are twice as many sizes.
export function outlines(profile, sizes) {
  const count = sizesOf[profile];
  const first = outlineOf[profile](sizes.slice(0, count));
  return { first, last: sizes.length > count ? outlineOf[profile](sizes.slice(count)) : first };
}
