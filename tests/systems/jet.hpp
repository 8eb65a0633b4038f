// The common part of hand_written.cpp and newton_euler.cpp: arithmetic, vectors and bodies.
#pragma once

#include "systems/hand_written.hpp"

#include <cmath>
#include <limits>

namespace hand_written {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline jet operator+(const jet& a, const jet& b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}
inline jet operator-(const jet& a, const jet& b) {
  return {a.value - b.value, a.rate - b.rate, a.second - b.second};
}
inline jet operator-(const jet& a) { return {-a.value, -a.rate, -a.second}; }
inline jet operator*(const jet& a, const jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.second * b.value + 2 * a.rate * b.rate + a.value * b.second};
}
inline jet& operator+=(jet& a, const jet& b) { return a = a + b; }
inline jet& operator-=(jet& a, const jet& b) { return a = a - b; }
inline jet& operator*=(jet& a, const jet& b) { return a = a * b; }

// f(a), from f and its first two derivatives there.
inline jet chain(const jet& a, double f, double df, double ddf) {
  return {f, df * a.rate, df * a.second + ddf * a.rate * a.rate};
}
inline jet sin(const jet& a) {
  const double s = std::sin(a.value), c = std::cos(a.value);
  return chain(a, s, c, -s);
}
inline jet cos(const jet& a) {
  const double s = std::sin(a.value), c = std::cos(a.value);
  return chain(a, c, -s, -c);
}
inline jet sqrt(const jet& a) {
  const double root = std::sqrt(a.value);
  return chain(a, root, 0.5 / root, -0.25 / (root * a.value));
}
inline jet operator/(const jet& a, const jet& b) {
  const double one = 1 / b.value;
  return a * chain(b, one, -one * one, 2 * one * one * one);
}

} // namespace hand_written

template <>
struct Eigen::NumTraits<hand_written::jet> : Eigen::NumTraits<double> {
  using Real = hand_written::jet;
  using NonInteger = hand_written::jet;
  using Nested = hand_written::jet;
  enum { IsComplex = 0, RequireInitialization = 1, ReadCost = 3, AddCost = 3, MulCost = 8 };
};

template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, hand_written::jet, Operation> {
  using ReturnType = hand_written::jet;
};

namespace hand_written {

using vector = Eigen::Matrix<jet, 3, 1>;
using matrix = Eigen::Matrix<jet, 3, 3>;

// d/dt; the second derivative of the result is not known.
inline jet rate_of(const jet& a) { return {a.rate, a.second, std::numeric_limits<double>::quiet_NaN()}; }
inline vector rate_of(const vector& a) { return {rate_of(a(0)), rate_of(a(1)), rate_of(a(2))}; }

inline Vector3d value(const vector& a) { return {a(0).value, a(1).value, a(2).value}; }
inline Vector3d rate(const vector& a) { return {a(0).rate, a(1).rate, a(2).rate}; }
inline Matrix3d value(const matrix& a) {
  Matrix3d values;
  for (int i = 0; i < 9; ++i) values(i) = a(i).value;
  return values;
}

inline vector fixed(double x, double y, double z) { return {jet(x), jet(y), jet(z)}; }
inline jet dot(const vector& a, const vector& b) { return a(0) * b(0) + a(1) * b(1) + a(2) * b(2); }
inline vector cross(const vector& a, const vector& b) {
  return {a(1) * b(2) - a(2) * b(1), a(2) * b(0) - a(0) * b(2), a(0) * b(1) - a(1) * b(0)};
}

// Elementary rotations; the columns are the rotated axes in the original axes.
inline matrix turn_x(const jet& q) {
  matrix m;
  m << 1, 0, 0, 0, cos(q), -sin(q), 0, sin(q), cos(q);
  return m;
}
inline matrix turn_y(const jet& q) {
  matrix m;
  m << cos(q), 0, sin(q), 0, 1, 0, -sin(q), 0, cos(q);
  return m;
}
inline matrix turn_z(const jet& q) {
  matrix m;
  m << cos(q), -sin(q), 0, sin(q), cos(q), 0, 0, 0, 1;
  return m;
}

// The angular velocity of axes whose columns are `turn`: R' R^T is its cross-product matrix.
inline vector angular_velocity(const matrix& turn) {
  matrix turning;
  for (int i = 0; i < 9; ++i) turning(i) = rate_of(turn(i));
  const auto element = [&](int i, int j) {
    return turning(i, 0) * turn(j, 0) + turning(i, 1) * turn(j, 1) + turning(i, 2) * turn(j, 2);
  };
  return {element(2, 1), element(0, 2), element(1, 0)};
}

struct body {
  double mass;
  Matrix3d inertia; // about the mass center, in the body's axes
  vector center;
  matrix turn;
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero(); // on the mass center and the body
};

// The equations of a model for its coordinates and their time derivatives.
struct motion {
  std::vector<body> bodies;
  jets closed;    // zero in configurations that satisfy the constraints
  jets no_motion; // linear in the rates of the coordinates, and zero
  jets speeds;    // the generalized speeds
};

} // namespace hand_written
