#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

/// Positions and orientations as numbers.
namespace kanexpr::robots {

/// The entry at an index of type int, the type of the indices of links, joints and bodies.
template <class Entries>
auto& entry(Entries& all, int index) {
  return all[static_cast<std::size_t>(index)];
}

using vector3 = std::array<double, 3>;

/// The rows of a rotation matrix: v in the outer axes = rotation · v in the rotated axes.
using rotation = std::array<vector3, 3>;

inline constexpr rotation no_rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// The rotation of a set of axes, and the position of their origin in the outer axes.
struct pose {
  rotation orientation = no_rotation;
  vector3 position{};

  bool operator==(const pose&) const = default;
};

inline vector3 operator+(const vector3& a, const vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline vector3 operator-(const vector3& a, const vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const vector3& a, const vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline vector3 cross(const vector3& a, const vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const vector3& v) { return v == vector3{}; }
inline bool is_finite(const vector3& v) { return numeric::is_finite(v[0] + v[1] + v[2]); }

inline vector3 rotated(const rotation& by, const vector3& v) {
  return {dot(by[0], v) + 0.0, dot(by[1], v) + 0.0, dot(by[2], v) + 0.0}; // no negative zero
}
inline rotation transposed(const rotation& r) {
  return {{{r[0][0], r[1][0], r[2][0]}, {r[0][1], r[1][1], r[2][1]}, {r[0][2], r[1][2], r[2][2]}}};
}
inline rotation product(const rotation& a, const rotation& b) {
  const rotation columns = transposed(b);
  return transposed({rotated(a, columns[0]), rotated(a, columns[1]), rotated(a, columns[2])});
}
inline pose product(const pose& a, const pose& b) {
  return {product(a.orientation, b.orientation), a.position + rotated(a.orientation, b.position)};
}

struct sine_and_cosine {
  double sine = 0, cosine = 1;
};

/// The sine and cosine of an angle. An angle within `tolerance` of a multiple of π/4 is rounded to that
/// multiple.
inline sine_and_cosine sine_and_cosine_of(double angle, double tolerance) {
  constexpr double eighth = std::numbers::pi / 4, half = std::numbers::sqrt2 / 2;
  const double turns = (std::round)(angle / eighth);
  if (std::abs(angle - turns * eighth) > tolerance) return {std::sin(angle), std::cos(angle)};
  constexpr sine_and_cosine exact[]{{0, 1},  {half, half},   {1, 0},  {half, -half},
                                    {0, -1}, {-half, -half}, {-1, 0}, {-half, half}};
  return exact[(static_cast<int>(std::fmod(turns, 8)) + 8) % 8];
}

/// The rotation by roll, pitch and yaw about the fixed axes x, y and z, in this order.
inline rotation rotation_by_rpy(const vector3& angles, double tolerance) {
  const sine_and_cosine r = sine_and_cosine_of(angles[0], tolerance),
                        p = sine_and_cosine_of(angles[1], tolerance),
                        y = sine_and_cosine_of(angles[2], tolerance);
  const rotation about_x{{{1, 0, 0}, {0, r.cosine, -r.sine}, {0, r.sine, r.cosine}}};
  const rotation about_y{{{p.cosine, 0, p.sine}, {0, 1, 0}, {-p.sine, 0, p.cosine}}};
  const rotation about_z{{{y.cosine, -y.sine, 0}, {y.sine, y.cosine, 0}, {0, 0, 1}}};
  return product(about_z, product(about_y, about_x));
}

/// The rotation by a unit quaternion with vector part x, y, z and scalar part w.
inline rotation rotation_by_quaternion(double x, double y, double z, double w) {
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// Returns the rotation with its right angles made exact, computed from roll, pitch and yaw. Near a pitch of
/// 90°, where these angles are inaccurate, the rotation is returned unchanged.
inline rotation round_right_angles(const rotation& r, double tolerance) {
  constexpr double right = std::numbers::pi / 2;
  const double pitch = std::asin(std::clamp(-r[2][0], -1.0, 1.0)), to_pole = right - std::abs(pitch);
  if (!(tolerance > 0) || (to_pole > tolerance && to_pole < 0.01)) return r;
  if (to_pole <= tolerance) return rotation_by_rpy({0, pitch, std::atan2(-r[0][1], r[1][1])}, tolerance);
  return rotation_by_rpy({std::atan2(r[2][1], r[2][2]), pitch, std::atan2(r[1][0], r[0][0])}, tolerance);
}

/// The rotation about a unit vector, by Rodrigues' formula.
inline rotation rotation_about(const vector3& a, double angle, double tolerance) {
  const auto [s, c] = sine_and_cosine_of(angle, tolerance);
  const double v = 1 - c;
  return {{{c + v * a[0] * a[0], v * a[0] * a[1] - s * a[2], v * a[0] * a[2] + s * a[1]},
           {v * a[0] * a[1] + s * a[2], c + v * a[1] * a[1], v * a[1] * a[2] - s * a[0]},
           {v * a[0] * a[2] - s * a[1], v * a[1] * a[2] + s * a[0], c + v * a[2] * a[2]}}};
}

/// The unit vector along v, which is exactly v if v has length 1. A direction within `tolerance` radians of a
/// basis vector becomes that vector; a zero vector stays zero.
inline vector3 direction_of(vector3 v, double tolerance) {
  const double largest = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (!(largest > 0)) return {};
  if (largest > 1e100 || largest < 1e-100) // the square would overflow or underflow
    for (double& e : v) e /= largest;
  const double least = tolerance * std::sqrt(dot(v, v));
  for (double& e : v) e = std::abs(e) <= least ? 0 : e;
  const double square = dot(v, v), length = std::abs(square - 1) < 1e-15 ? 1 : std::sqrt(square);
  for (double& e : v) e = e / length + 0.0;
  return v;
}

/// Returns two directions normal to an axis that form a right-handed triad with it; for the axis z, they are
/// x and y.
inline std::pair<vector3, vector3> normal_directions(const vector3& axis) {
  std::size_t most = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(axis[i]) > std::abs(axis[most])) most = i;
  const std::size_t next = (most + 1) % 3;
  vector3 first{};
  first[next] = 1;
  for (std::size_t i = 0; i < 3; ++i) first[i] -= axis[next] * axis[i];
  first = direction_of(first, 0);
  return {first, cross(axis, first)};
}

} // namespace kanexpr::robots
