#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// Functions that add frames, oriented relative to a parent, to a mechanism.
namespace kanexpr::mechanics {

constexpr int add_inertial_frame(mechanism& m, const name& called) {
  return m.frames.push({.called = called});
}

/// Adds a frame given by the matrix `to_parent`, which transforms components from the frame's axes to the
/// parent's.
constexpr int add_frame_by_matrix(mechanism& m, const name& called, int parent, const matrix3& to_parent) {
  return m.frames.push(
      {.called = called, .parent = parent, .kind = orientation::matrix, .to_parent = to_parent});
}

/// Adds a frame rotated by `angle` about an axis given in the parent's axes; the axis need not have unit
/// length.
constexpr int add_rotated_frame(mechanism& m, const name& called, int parent, expression angle,
                                const components& axis) {
  frame f{.called = called, .parent = parent, .angle = angle};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (!axis[j].is_zero() || !axis[k].is_zero() || !axis[i].is_constant()) continue;
    f.kind = orientation::about_basis;
    f.axis = i;
    if (m.g->number_at(axis[i].node()).negative()) f.angle = -angle;
    return m.frames.push(f);
  }
  // R = E + sin [a]× + (1 − cos) (a aᵀ − E), Rodrigues
  const expression length = sqrt(dot(axis, axis));
  const components a{axis.x / length, axis.y / length, axis.z / length};
  const expression s = sin(angle), c = cos(angle), v = 1 - c;
  f.kind = orientation::about_axis;
  f.direction = a;
  f.to_parent.row[0] = {c + v * (a.x * a.x), difference_of_products(v, a.x * a.y, s, a.z),
                        sum_of_products(v, a.z * a.x, s, a.y)};
  f.to_parent.row[1] = {sum_of_products(v, a.x * a.y, s, a.z), c + v * (a.y * a.y),
                        difference_of_products(v, a.y * a.z, s, a.x)};
  f.to_parent.row[2] = {difference_of_products(v, a.z * a.x, s, a.y), sum_of_products(v, a.y * a.z, s, a.x),
                        c + v * (a.z * a.z)};
  return m.frames.push(f);
}

/// Returns 0, 1, 2 for the letter or digit of an axis, and `none` for any other character.
constexpr int axis_of(char letter) {
  switch (letter) {
  case 'x':
  case 'X':
  case '1': return 0;
  case 'y':
  case 'Y':
  case '2': return 1;
  case 'z':
  case 'Z':
  case '3': return 2;
  default: return none;
  }
}

constexpr bool is_sequence(std::string_view letters) {
  if (letters.size() != 3) return false;
  const int a = axis_of(letters[0]), b = axis_of(letters[1]), c = axis_of(letters[2]);
  return a != none && b != none && c != none && a != b && b != c;
}

/// Adds a frame rotated by three successive rotations. The first two create intermediate frames, named after
/// the last one: B', B''.
constexpr int add_frame_by_sequence(mechanism& m, const name& called, int parent, std::string_view letters,
                                    const sequence<expression>& angles, bool space_fixed) {
  int last = parent;
  for (int turn = 0; turn < 3; ++turn) {
    const int i = space_fixed ? 2 - turn : turn; // space-fixed rotations are body-fixed ones in reverse order
    name own = called;
    if (turn < 2) own.append(turn == 0 ? "'" : "''");
    components axis(*m.g);
    axis[axis_of(letters[static_cast<std::size_t>(i)])] = m.one();
    last = add_rotated_frame(m, own, last, angles[i], axis);
  }
  return last;
}

namespace detail {

/// The matrix of a unit quaternion e0 + e1 i + e2 j + e3 k. Kane, Likins & Levinson (1983), eq. 1.3.10.
constexpr matrix3 matrix_of_quaternion(expression e0, expression e1, expression e2, expression e3) {
  const expression xx = e1 * e1, yy = e2 * e2, zz = e3 * e3;
  const expression xy = e1 * e2, yz = e2 * e3, zx = e3 * e1, wx = e0 * e1, wy = e0 * e2, wz = e0 * e3;
  matrix3 r;
  r.row[0] = {1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (zx + wy)};
  r.row[1] = {2 * (xy + wz), 1 - 2 * (zz + xx), 2 * (yz - wx)};
  r.row[2] = {2 * (zx - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)};
  return r;
}

} // namespace detail

/// Adds a frame given by the unit quaternion e0 + e1 i + e2 j + e3 k. For its rates see Kane, Likins &
/// Levinson (1983), section 1.13.
constexpr int add_frame_by_quaternion(mechanism& m, const name& called, int parent, expression e0,
                                      expression e1, expression e2, expression e3) {
  const int place = add_frame_by_matrix(m, called, parent, detail::matrix_of_quaternion(e0, e1, e2, e3));
  frame& f = m.frames[place];
  f.quaternion = {e0, e1, e2, e3};
  f.rates = {{e0, {-e1, -e2, -e3}}, {e1, {e0, -e3, e2}}, {e2, {e3, e0, -e1}}, {e3, {-e2, e1, e0}}};
  return place;
}

/// Adds a frame given by the modified Rodrigues parameters σ = a tan(φ/4) of a rotation by φ about a. They
/// correspond to the quaternion (1 − σ²)/(1 + σ²), 2σ/(1 + σ²), and dσ/dt = ¼ ((1 − σ²) ω + 2 σ × ω + 2 σ
/// σ·ω). Schaub & Junkins, Analytical Mechanics of Space Systems (2018), section 3.6.
constexpr int add_frame_by_modified_rodrigues(mechanism& m, const name& called, int parent,
                                              const components& s) {
  const expression square = dot(s, s), twice = 2 / (square + 1), half = (1 - square) / 2;
  const expression e[]{twice - 1, twice * s.x, twice * s.y, twice * s.z};
  const int place =
      add_frame_by_matrix(m, called, parent, detail::matrix_of_quaternion(e[0], e[1], e[2], e[3]));
  const expression xy = s.x * s.y, yz = s.y * s.z, zx = s.z * s.x;
  m.frames[place].rates = {{s.x, {half + s.x * s.x, xy - s.z, zx + s.y}},
                           {s.y, {xy + s.z, half + s.y * s.y, yz - s.x}},
                           {s.z, {zx - s.y, yz + s.x, half + s.z * s.z}}};
  return place;
}

} // namespace kanexpr::mechanics
