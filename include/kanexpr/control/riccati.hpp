#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/control/balance.hpp>
#include <kanexpr/control/doubling.hpp>

namespace kanexpr::control {

/// What a Riccati equation may lack.
inline constexpr status not_stabilizable("the system is not stabilizable, as far as numbers can tell: its "
                                         "inputs do not reach a motion that does not decay"),
    not_detectable_on_axis(
        "the system is not detectable on the imaginary axis: the weights of the states leave "
        "out a motion that neither grows nor decays"),
    not_detectable_on_circle(
        "the system is not detectable on the unit circle: the weights of the states leave "
        "out a motion that neither grows nor decays"),
    not_converged("the Riccati equation could not be solved to the accuracy of the numbers");

/// The equation of Δ in a solution X + Δ: the same with the motion of the closed loop at X, and what X leaves
/// in place of Q (Mehrmann & Tan, Defect correction methods for the solution of algebraic
/// Riccati equations, IEEE Trans. Autom. Control 33, 1988).
template <time_domain domain, class T, int n>
constexpr riccati_equation<T, n> defect(const riccati_equation<T, n>& e, const fixed_matrix<T, n, n>& x) {
  const fixed_matrix<T, n, n> xa = x * e.a, gx = e.g * x;
  if constexpr (domain == time_domain::continuous) {
    return {e.a - gx, e.g, numeric::symmetric(e.q + xa + numeric::transposed(xa) - x * gx)};
  } else {
    const numeric::eliminated<T, n> w(numeric::identity<T, n>() + gx);
    const fixed_matrix<T, n, n> closed = w.solve(e.a);
    return {closed, numeric::symmetric(w.solve(e.g)),
            numeric::symmetric(e.q - x + numeric::transposed(xa) * closed)};
  }
}

/// The solutions of two linear equations of a closed loop, Aᵀ X + X A + W = 0 or X = Aᵀ X A + W, if it
/// decays: by squaring (Smith, Matrix equation XA + BX = C, SIAM J. Appl. Math. 16, 1968).
template <time_domain domain, class T, int n>
constexpr bool solve_linear(fixed_matrix<T, n, n> a, fixed_matrix<T, n, n>& first,
                            fixed_matrix<T, n, n>& second) {
  using limits = std::numeric_limits<T>;
  if constexpr (domain == time_domain::continuous) {
    const T shift = mean_rate(numeric::eliminated<T, n>(a));
    const numeric::eliminated<T, n> shifted(a - shift * numeric::identity<T, n>());
    if (!(shift > 0) || shifted.is_singular()) return false;
    const fixed_matrix<T, n, n> inverse = shifted.solve(numeric::identity<T, n>());
    for (fixed_matrix<T, n, n>* each : {&first, &second})
      *each = 2 * shift * (numeric::transposed(inverse) * *each * inverse);
    a = numeric::identity<T, n>() + 2 * shift * inverse;
  }
  for (int k = 0; k < limits::digits; ++k) {
    const T size = numeric::largest_entry(a);
    if (!(size < 1 / limits::epsilon())) return false;
    const fixed_matrix<T, n, n> at = numeric::transposed(a);
    for (fixed_matrix<T, n, n>* each : {&first, &second})
      *each = numeric::symmetric(*each + at * (*each * a));
    if (size <= limits::epsilon()) return true;
    a = a * a;
  }
  return false;
}

template <class T, int n>
constexpr fixed_matrix<T, n, n> magnitudes(fixed_matrix<T, n, n> m) {
  for (T& entry : m.entries) entry = numeric::constant_elimination_math::magnitude(entry);
  return m;
}

/// Refines a solution by Newton's method (Kleinman, On an iterative technique for Riccati equation
/// computations, IEEE Trans. Autom. Control 13, 1968), until rounding is all that moves it. False where that
/// is much, or where the closed loop does not decay whatever rounding does to it: then only that reaches a
/// motion that grows.
template <time_domain domain, class T, int n>
constexpr bool refine(const riccati_equation<T, n>& e, fixed_matrix<T, n, n>& x) {
  using limits = std::numeric_limits<T>;
  constexpr T accurate = power_of_two_near_root(limits::epsilon());
  constexpr T tolerable = T(1) / 1024; // of what rounding leaves to do, again and again
  constexpr int most_steps = 4;
  T before = (limits::max)();
  for (int i = 0; i < most_steps; ++i) {
    const riccati_equation<T, n> rest = defect<domain>(e, x);
    const T size = numeric::largest_entry(x);
    fixed_matrix<T, n, n> change = rest.q, weight, cost;
    for (int k = 0; k < n; ++k) weight(k, k) = size > 0 ? x(k, k) + limits::epsilon() * size : T(1);
    cost = weight;
    if (!solve_linear<domain>(rest.a, change, cost)) return false;
    const fixed_matrix<T, n, n> rounding =
        magnitudes(cost) * (limits::epsilon() * (magnitudes(e.g) * magnitudes(x)));
    for (int k = 0; k < n; ++k)
      for (int j = 0; j <= k; ++j) {
        const T both = rounding(k, j) + rounding(j, k);
        if (!(both * both <= weight(k, k) * weight(j, j))) return false;
      }
    const T moved = numeric::largest_entry(change);
    if (moved > before / 2) break;
    x = x + change;
    if (moved <= accurate * size) return true;
    before = moved;
  }
  return before <= tolerable * numeric::largest_entry(x);
}

/// The solution of a balanced equation, with Q positive semidefinite.
template <time_domain domain, class T, int n>
constexpr status solve_balanced(const riccati_equation<T, n>& e, fixed_matrix<T, n, n>& x) {
  const riccati_solution<T, n> direct = stabilizing<domain>(e);
  x = direct.x;
  if (direct.found && refine<domain>(e, x)) return {};
  // With a weight on every state there is a solution if the system can be stabilized at all.
  const T size = numeric::largest_entry(e.a), inputs = numeric::largest_entry(e.g);
  const T rate = domain == time_domain::continuous && size > 0 ? size * size : T(1);
  riccati_equation<T, n> weighted = e;
  for (int i = 0; i < n; ++i) weighted.q(i, i) += inputs > 0 ? rate / inputs : T(1);
  const riccati_solution<T, n> nearby = stabilizing<domain>(weighted);
  x = nearby.x;
  if (!nearby.found || !refine<domain>(weighted, x)) return not_stabilizable;
  const riccati_solution<T, n> rest = stabilizing<domain>(defect<domain>(e, x));
  if (!rest.found)
    return domain == time_domain::continuous ? not_detectable_on_axis : not_detectable_on_circle;
  x = x + rest.x;
  return refine<domain>(e, x) ? status() : not_converged;
}

/// The stabilizing solution of a Riccati equation whose Q is positive semidefinite.
template <time_domain domain, class T, int n>
constexpr status solve(const riccati_equation<T, n>& e, fixed_matrix<T, n, n>& x) {
  const units<T, n> unit = balanced_units(e.a, e.g, e.q);
  const status solved = solve_balanced<domain>(
      riccati_equation<T, n>{unit.scaled(e.a), unit.divided_twice(e.g), unit.multiplied_twice(e.q)}, x);
  if (solved) x = unit.divided_twice(x);
  return solved;
}

} // namespace kanexpr::control
