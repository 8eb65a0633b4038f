#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/beams/shape.hpp>

/// Shapes and distributions given by their values at stations, from ξ = 0 to ξ = 1.
namespace kanexpr::numeric::beams {

/// Straight lines between the stations.
constexpr shape linear_table(const base::sequence<double>& xi, const base::sequence<double>& values) {
  base::sequence<double> coefficients;
  for (int i = 0; i + 1 < xi.size(); ++i) {
    coefficients.push(values[i]);
    coefficients.push((values[i + 1] - values[i]) / (xi[i + 1] - xi[i]));
  }
  return shape::piecewise(xi, 1, coefficients);
}

/// Cubic polynomials with the given values and slopes d/dξ at the stations (Hermite), as in the elements of a
/// finite-element model of a beam.
constexpr shape cubic_table(const base::sequence<double>& xi, const base::sequence<double>& values,
                            const base::sequence<double>& slopes) {
  base::sequence<double> coefficients;
  for (int i = 0; i + 1 < xi.size(); ++i) {
    const double h = xi[i + 1] - xi[i], chord = (values[i + 1] - values[i]) / h;
    coefficients.push(values[i]);
    coefficients.push(slopes[i]);
    coefficients.push((3 * chord - 2 * slopes[i] - slopes[i + 1]) / h);
    coefficients.push((slopes[i] + slopes[i + 1] - 2 * chord) / (h * h));
  }
  return shape::piecewise(xi, 3, coefficients);
}

/// The cubic spline through the values, without curvature at the tip. At the root its slope is zero if
/// `clamped`; otherwise its curvature is zero there too. The slopes m solve the equations of continuous
/// curvature (de Boor, A Practical Guide to Splines, chapter IV), a tridiagonal system.
constexpr shape spline(const base::sequence<double>& xi, const base::sequence<double>& values, bool clamped) {
  const int last = xi.size() - 1;
  const auto step = [&](int i) { return xi[i + 1] - xi[i]; };
  const auto chord = [&](int i) { return (values[i + 1] - values[i]) / step(i); };
  base::sequence<double> above(last + 1), right(last + 1); // after elimination of what is below the diagonal
  if (!clamped) above[0] = 0.5, right[0] = 1.5 * chord(0);
  for (int i = 1; i <= last; ++i) {
    const bool is_end = i == last;
    const double below = is_end ? 1 : 1 / step(i - 1), upper = is_end ? 0 : 1 / step(i);
    const double diagonal = 2 * (below + upper);
    double wanted = 3 * below * chord(i - 1);
    if (!is_end) wanted += 3 * upper * chord(i);
    const double pivot = diagonal - below * above[i - 1];
    above[i] = upper / pivot;
    right[i] = (wanted - below * right[i - 1]) / pivot;
  }
  base::sequence<double> slopes = right;
  for (int i = last - 1; i >= 0; --i) slopes[i] -= above[i] * slopes[i + 1];
  return cubic_table(xi, values, slopes);
}

} // namespace kanexpr::numeric::beams
