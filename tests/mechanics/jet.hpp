// Taylor coefficients up to the second order: value, rate and half the acceleration of a quantity along a
// motion.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace limits {

struct jet {
  double c0 = 0, c1 = 0, c2 = 0;

  constexpr jet() = default;
  constexpr jet(double value) : c0(value) {}
  constexpr jet(double value, double first, double second) : c0(value), c1(first), c2(second) {}

  jet rate() const { return {c1, 2 * c2, 0}; }

  jet& operator+=(const jet& o) { return *this = *this + o; }
  jet& operator-=(const jet& o) { return *this = *this - o; }
  jet& operator*=(const jet& o) { return *this = *this * o; }

  friend jet operator+(const jet& a, const jet& b) { return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2}; }
  friend jet operator-(const jet& a, const jet& b) { return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2}; }
  friend jet operator-(const jet& a) { return {-a.c0, -a.c1, -a.c2}; }
  friend jet operator*(const jet& a, const jet& b) {
    return {a.c0 * b.c0, a.c0 * b.c1 + a.c1 * b.c0, a.c0 * b.c2 + a.c1 * b.c1 + a.c2 * b.c0};
  }
  friend jet operator/(const jet& a, const jet& b) {
    const double value = a.c0 / b.c0, first = (a.c1 - value * b.c1) / b.c0;
    return {value, first, (a.c2 - value * b.c2 - first * b.c1) / b.c0};
  }
};

inline jet chain(const jet& x, double f, double slope, double curvature) {
  return {f, slope * x.c1, slope * x.c2 + curvature * x.c1 * x.c1 / 2};
}
inline jet sin(const jet& x) { return chain(x, std::sin(x.c0), std::cos(x.c0), -std::sin(x.c0)); }
inline jet cos(const jet& x) { return chain(x, std::cos(x.c0), -std::sin(x.c0), -std::cos(x.c0)); }

// Vectors and matrices of jets, written out because few operations are needed.
struct jet3 {
  std::array<jet, 3> at;

  jet3() = default;
  explicit jet3(const Eigen::Vector3d& v) : at{v(0), v(1), v(2)} {}
  jet3(const jet& x, const jet& y, const jet& z) : at{x, y, z} {}

  jet& operator[](int i) { return at[static_cast<std::size_t>(i)]; }
  const jet& operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
  jet3 rate() const { return {at[0].rate(), at[1].rate(), at[2].rate()}; }
  Eigen::Vector3d value() const { return {at[0].c0, at[1].c0, at[2].c0}; }

  friend jet3 operator+(const jet3& a, const jet3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
  friend jet3 operator*(const jet& s, const jet3& a) { return {s * a[0], s * a[1], s * a[2]}; }
};

inline jet dot(const jet3& a, const jet3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline jet3 cross(const jet3& a, const jet3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct jet3x3 {
  std::array<jet3, 3> column{jet3(1, 0, 0), jet3(0, 1, 0), jet3(0, 0, 1)};

  friend jet3 operator*(const jet3x3& m, const jet3& v) {
    return v[0] * m.column[0] + v[1] * m.column[1] + v[2] * m.column[2];
  }
  friend jet3x3 operator*(const jet3x3& a, const jet3x3& b) {
    return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
  }
  jet3x3 rate() const { return {{column[0].rate(), column[1].rate(), column[2].rate()}}; }
  Eigen::Matrix3d value() const {
    Eigen::Matrix3d m;
    m << column[0].value(), column[1].value(), column[2].value();
    return m;
  }
};

// About an axis of unit length: each basis vector e becomes c e + s a×e + (1 - c) (a·e) a.
inline jet3x3 rotation(const jet3& axis, const jet& angle) {
  jet3x3 r;
  const jet s = sin(angle), c = cos(angle);
  for (jet3& e : r.column) e = c * e + s * cross(axis, e) + ((1 - c) * dot(axis, e)) * axis;
  return r;
}

// By the unit quaternion w + v: e becomes e + 2 v×(v×e + w e).
inline jet3x3 rotation_by_quaternion(const jet& w, const jet3& v) {
  jet3x3 r;
  for (jet3& e : r.column) e = e + jet(2) * cross(v, cross(v, e) + w * e);
  return r;
}

} // namespace limits
