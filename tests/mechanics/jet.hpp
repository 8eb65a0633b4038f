// Taylor coefficients up to the second order: value, rate and half the acceleration of a quantity along a motion.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace taylor {

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
    const double c0 = a.c0 / b.c0, c1 = (a.c1 - c0 * b.c1) / b.c0;
    return {c0, c1, (a.c2 - c0 * b.c2 - c1 * b.c1) / b.c0};
  }
};

inline jet chain(const jet& x, double f, double slope, double curvature) {
  return {f, slope * x.c1, slope * x.c2 + curvature * x.c1 * x.c1 / 2};
}
inline jet sin(const jet& x) { return chain(x, std::sin(x.c0), std::cos(x.c0), -std::sin(x.c0)); }
inline jet cos(const jet& x) { return chain(x, std::cos(x.c0), -std::sin(x.c0), -std::cos(x.c0)); }

} // namespace taylor

template <>
struct Eigen::NumTraits<taylor::jet> : Eigen::NumTraits<double> {
  using Real = taylor::jet;
  using NonInteger = taylor::jet;
  using Nested = taylor::jet;
  using Literal = double;
};
