#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/elementary.hpp>

namespace kanexpr::numeric::beams {

/// Nodes and weights of an integral over [0, 1].
struct quadrature {
  base::sequence<double> nodes{}, weights{};
  constexpr int size() const { return nodes.size(); }
};

/// The Gauss-Legendre rule with n points, exact for polynomials of degree 2n − 1. The nodes are the roots of
/// the Legendre polynomial P_n, found by Newton's method from the asymptotic formula of Abramowitz & Stegun
/// (1964), 22.16.6.
constexpr quadrature gauss_legendre(int points) {
  constexpr double pi = 3.141592653589793;
  quadrature rule;
  rule.nodes.resize(points, 0.5);
  rule.weights.resize(points);
  for (int i = 0; i < (points + 1) / 2; ++i) {
    long double x =
        static_cast<long double>(elementary::cos(pi * (i + 0.75) / (static_cast<double>(points) + 0.5)));
    if (2 * i + 1 == points) x = 0;
    long double slope = 1;
    for (int step = 0; step < 8; ++step) {
      long double before = 1, value = x; // P_0 and P_1
      for (int k = 1; k < points; ++k) {
        const long double next =
            (static_cast<long double>(2 * k + 1) * x * value - static_cast<long double>(k) * before) /
            static_cast<long double>(k + 1);
        before = value, value = next;
      }
      slope = static_cast<long double>(points) * (x * value - before) / (x * x - 1);
      const long double change = value / slope;
      x -= change;
      if (change * change < 1e-40L) break;
    }
    const double weight = static_cast<double>(1 / ((1 - x * x) * slope * slope));
    rule.nodes[i] = static_cast<double>((1 - x) / 2);
    rule.nodes[points - 1 - i] = static_cast<double>((1 + x) / 2);
    rule.weights[i] = rule.weights[points - 1 - i] = weight;
  }
  return rule;
}

} // namespace kanexpr::numeric::beams
