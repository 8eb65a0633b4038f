#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/control/balance.hpp>

namespace kanexpr::control {

/// How time goes on: A and B of ẋ = A x + B r, or of x⁺ = A x + B r.
enum class time_is : unsigned char { continuous, discrete };

/// What a Riccati equation may lack.
inline constexpr status
    not_stabilizable("the system is not stabilizable: its inputs do not reach a motion that does not decay"),
    not_detectable_on_axis(
        "the system is not detectable on the imaginary axis: the weights of the states leave "
        "out a motion that neither grows nor decays"),
    not_detectable_on_circle(
        "the system is not detectable on the unit circle: the weights of the states leave "
        "out a motion that neither grows nor decays"),
    not_converged("the Riccati equation could not be solved to the accuracy of the numbers");

/// A Riccati equation with G = B R⁻¹ Bᵀ: Aᵀ X + X A − X G X + Q = 0, or X = Aᵀ X (1 + G X)⁻¹ A + Q.
template <class T, int n>
struct riccati_equation {
  fixed_matrix<T, n, n> a, g, q;
};

/// A symmetric matrix, and whether it solves the equation.
template <class T, int n>
struct riccati_solution {
  fixed_matrix<T, n, n> x{};
  bool found = false;
};

template <class T>
constexpr T power_of_two_near_root(T x) {
  T root = 1;
  while (root * root < x) root *= 2;
  while (root * root > x) root /= 2;
  return root;
}

/// The stabilizing solution by structured doubling (Chu, Fan, Lin & Wang, Structure-preserving algorithms for
/// periodic discrete-time algebraic Riccati equations, Int. J. Control 77, 2004): A_k becomes the motion of
/// the closed loop over 2ᵏ steps. Nothing is found where it grows so far that only rounding reaches it, does
/// not vanish, or halves from step to step, as it does for a closed loop on the unit circle (Chiang et al.,
/// Convergence analysis of the doubling algorithm, SIAM J. Matrix Anal. Appl. 31, 2009).
template <class T, int n>
constexpr riccati_solution<T, n> doubled(riccati_equation<T, n> e) {
  using limits = std::numeric_limits<T>;
  constexpr T root = power_of_two_near_root(limits::epsilon()), most = 8 / root, little = 8 * root,
              medium = power_of_two_near_root(little);
  constexpr int most_steps = limits::digits * 7 / 8, most_slow_steps = limits::digits / 9;
  int slow_steps = 0;
  T size = numeric::largest_entry(e.a);
  for (int k = 0; k < most_steps && size < most && slow_steps <= most_slow_steps; ++k) {
    const numeric::eliminated<T, n> w(numeric::identity<T, n>() + e.g * e.q);
    if (w.is_singular()) break;
    const fixed_matrix<T, n, n> v = w.solve(e.a), at = numeric::transposed(e.a);
    e.g = numeric::symmetric(e.g + e.a * w.solve(e.g) * at);
    e.q = numeric::symmetric(e.q + at * (e.q * v));
    e.a = e.a * v;
    size = numeric::largest_entry(e.a);
    if (size <= limits::epsilon() * limits::epsilon()) return {e.q, true};
    if (size > little && size < medium) ++slow_steps;
  }
  return {e.q, false};
}

/// Cayley's transform of a continuous equation: the discrete one with the same solution (Chu, Fan & Lin, A
/// structure-preserving doubling algorithm for continuous-time algebraic Riccati equations, Linear Algebra
/// Appl. 396, 2005). Its matrices are [A, G; −Q, Aᵀ] = 1 + 2γ S⁻¹ diag(1, −1) with S = [A − γ, −G; −Q, γ −
/// Aᵀ].
template <class T, int n>
class cayley {
public:
  constexpr cayley(const riccati_equation<T, n>& e, T shift) {
    const numeric::eliminated<T, 2 * n> s(hamiltonian(e, shift));
    if (s.is_singular()) return;
    fixed_matrix<T, 2 * n, 2 * n> right;
    for (int i = 0; i < n; ++i) right(i, i) = 2 * shift, right(n + i, n + i) = -2 * shift;
    const fixed_matrix<T, 2 * n, 2 * n> found = s.solve(right);
    size = 1 + numeric::largest_entry(found);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        discrete.a(i, j) = found(i, j) + (i == j ? T(1) : T(0));
        discrete.g(i, j) = found(i, n + j);
        discrete.q(i, j) = -found(n + i, j);
      }
    discrete.g = numeric::symmetric(discrete.g);
    discrete.q = numeric::symmetric(discrete.q);
  }

  /// [A − γ, −G; −Q, γ − Aᵀ], the Hamiltonian matrix at γ = 0.
  static constexpr fixed_matrix<T, 2 * n, 2 * n> hamiltonian(const riccati_equation<T, n>& e, T shift) {
    fixed_matrix<T, 2 * n, 2 * n> h;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const T diagonal = i == j ? shift : T(0);
        h(i, j) = e.a(i, j) - diagonal;
        h(i, n + j) = -e.g(i, j);
        h(n + i, j) = -e.q(i, j);
        h(n + i, n + j) = diagonal - e.a(j, i);
      }
    return h;
  }

  riccati_equation<T, n> discrete{};
  T size = 0; ///< of its largest entry; zero: S is singular
};

/// A power of two near the geometric mean of the eigenvalues of a matrix, by its pivots; zero where one of
/// them vanishes.
template <class T, int n>
constexpr T mean_rate(const numeric::eliminated<T, n>& m) {
  if (m.is_singular()) return 0;
  int exponent = 0;
  T product = 1; // of the reciprocals of the pivots
  for (int k = 0; k < n; ++k) {
    product *= numeric::constant_elimination_math::magnitude(m.reciprocal(k));
    for (; product >= 2; product /= 2) --exponent;
    for (; product < 1; product *= 2) ++exponent;
  }
  T mean = 1;
  for (int i = 0; i < exponent / n; ++i) mean *= 2;
  for (int i = 0; i < -exponent / n; ++i) mean /= 2;
  return mean;
}

/// One stabilizing solution; nothing is found where there is none, and not always where Q leaves out what
/// grows.
template <time_is passing, class T, int n>
constexpr riccati_solution<T, n> stabilizing(const riccati_equation<T, n>& e) {
  if constexpr (passing == time_is::discrete) {
    return doubled(e);
  } else {
    // A shift at an eigenvalue of A may leave S nearly singular: one of three does not.
    const T mean = mean_rate(numeric::eliminated<T, 2 * n>(cayley<T, n>::hamiltonian(e, 0)));
    if (!(mean > 0)) return {};
    cayley<T, n> best(e, mean);
    for (const T shift : {mean / 2, 2 * mean}) {
      const cayley<T, n> other(e, shift);
      if (other.size > 0 && (!(best.size > 0) || other.size < best.size)) best = other;
    }
    return best.size > 0 ? doubled(best.discrete) : riccati_solution<T, n>{};
  }
}

/// The equation of Δ in a solution X + Δ: the same with the motion of the closed loop at X, and what X leaves
/// in place of Q (Mehrmann & Tan, Defect correction methods for the solution of algebraic
/// Riccati equations, IEEE Trans. Autom. Control 33, 1988).
template <time_is passing, class T, int n>
constexpr riccati_equation<T, n> defect(const riccati_equation<T, n>& e, const fixed_matrix<T, n, n>& x) {
  const fixed_matrix<T, n, n> xa = x * e.a, gx = e.g * x;
  if constexpr (passing == time_is::continuous) {
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
template <time_is passing, class T, int n>
constexpr bool solve_linear(fixed_matrix<T, n, n> a, fixed_matrix<T, n, n>& first,
                            fixed_matrix<T, n, n>& second) {
  using limits = std::numeric_limits<T>;
  if constexpr (passing == time_is::continuous) {
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
/// computations, IEEE Trans. Autom. Control 13, 1968). False where it does not converge, or where the closed
/// loop does not decay whatever rounding does to it: then only that reaches a motion that grows.
template <time_is passing, class T, int n>
constexpr bool refine(const riccati_equation<T, n>& e, fixed_matrix<T, n, n>& x) {
  using limits = std::numeric_limits<T>;
  constexpr T accurate = power_of_two_near_root(limits::epsilon());
  constexpr int most_steps = 4;
  for (int i = 0; i < most_steps; ++i) {
    const riccati_equation<T, n> rest = defect<passing>(e, x);
    const T size = numeric::largest_entry(x);
    fixed_matrix<T, n, n> change = rest.q, weight, cost;
    for (int k = 0; k < n; ++k) weight(k, k) = size > 0 ? x(k, k) + limits::epsilon() * size : T(1);
    cost = weight;
    if (!solve_linear<passing>(rest.a, change, cost)) return false;
    const fixed_matrix<T, n, n> rounding =
        magnitudes(cost) * (limits::epsilon() * (magnitudes(e.g) * magnitudes(x)));
    for (int k = 0; k < n; ++k)
      for (int j = 0; j <= k; ++j) {
        const T both = rounding(k, j) + rounding(j, k);
        if (!(both * both <= weight(k, k) * weight(j, j))) return false;
      }
    x = x + change;
    if (numeric::largest_entry(change) <= accurate * numeric::largest_entry(x)) return true;
  }
  return false;
}

/// The solution of a balanced equation, with Q positive semidefinite.
template <time_is passing, class T, int n>
constexpr status solve_balanced(const riccati_equation<T, n>& e, fixed_matrix<T, n, n>& x) {
  const riccati_solution<T, n> direct = stabilizing<passing>(e);
  x = direct.x;
  if (direct.found && refine<passing>(e, x)) return {};
  // With a weight on every state there is a solution if the system can be stabilized at all.
  const T size = numeric::largest_entry(e.a), inputs = numeric::largest_entry(e.g);
  const T rate = passing == time_is::continuous && size > 0 ? size * size : T(1);
  riccati_equation<T, n> weighted = e;
  for (int i = 0; i < n; ++i) weighted.q(i, i) += inputs > 0 ? rate / inputs : T(1);
  const riccati_solution<T, n> nearby = stabilizing<passing>(weighted);
  x = nearby.x;
  if (!nearby.found || !refine<passing>(weighted, x)) return not_stabilizable;
  const riccati_solution<T, n> rest = stabilizing<passing>(defect<passing>(e, x));
  if (!rest.found) return passing == time_is::continuous ? not_detectable_on_axis : not_detectable_on_circle;
  x = x + rest.x;
  return refine<passing>(e, x) ? status() : not_converged;
}

/// The stabilizing solution of a Riccati equation whose Q is positive semidefinite.
template <time_is passing, class T, int n>
constexpr status solve(const riccati_equation<T, n>& e, fixed_matrix<T, n, n>& x) {
  const units<T, n> unit = balanced_units(e.a, e.g, e.q);
  const status solved = solve_balanced<passing>(
      riccati_equation<T, n>{unit.scaled(e.a), unit.divided_twice(e.g), unit.multiplied_twice(e.q)}, x);
  if (solved) x = unit.divided_twice(x);
  return solved;
}

} // namespace kanexpr::control
