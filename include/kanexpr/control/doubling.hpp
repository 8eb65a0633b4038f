#pragma once

#include <kanexpr/numeric/fixed_matrix.hpp>

namespace kanexpr::control {

using numeric::fixed_matrix;

/// Whether A and B are those of ẋ = A x + B r or of x⁺ = A x + B r.
enum class time_domain : unsigned char { continuous, discrete };

/// The Riccati equation Aᵀ X + X A − X G X + Q = 0, or X = Aᵀ X (1 + G X)⁻¹ A + Q, with G = B R⁻¹ Bᵀ.
template <class Number, int states>
struct riccati_equation {
  fixed_matrix<Number, states, states> a, g, q;
};

/// The outcome of the doubling iteration.
enum class doubling : unsigned char {
  solves, ///< the motion of the closed loop has decayed
  halves, ///< the motion halves with each doubling of the number of steps: an eigenvalue lies on the unit
          ///< circle
  does_not_decay, ///< the motion grows, or neither grows nor decays
  stops           ///< rounding or overflow ends the iteration
};

/// A symmetric matrix, and whether it solves the equation.
template <class Number, int states>
struct riccati_solution {
  fixed_matrix<Number, states, states> x{};
  doubling result = doubling::stops;

  constexpr bool found() const { return result == doubling::solves; }
};

/// Up to this bound, all required products are finite; a constant expression must not overflow.
template <class Number>
inline constexpr Number most_of_solution =
    numeric::power_of_two<Number>(std::numeric_limits<Number>::max_exponent * 3 / 8);

template <class Number, int states>
constexpr bool is_moderate(const fixed_matrix<Number, states, states>& m) {
  return numeric::is_finite(m) && numeric::largest_entry(m) < most_of_solution<Number>;
}

template <class Number>
constexpr Number power_of_two_near_root(Number x) {
  Number root = 1;
  while (root * root < x) root *= 2;
  while (root * root > x) root /= 2;
  return root;
}

/// Computes the stabilizing solution by structured doubling (Chu, Fan, Lin & Wang, Structure-preserving
/// algorithms for periodic discrete-time algebraic Riccati equations, Int. J. Control 77, 2004): A_k becomes
/// the motion of the closed loop over 2ᵏ steps. The iteration fails if this motion grows so much that the
/// inputs reach it only through rounding, if it does not vanish, or if it only halves with each doubling; the
/// last case occurs when the closed loop has an eigenvalue on the unit circle (Chiang et al., Convergence
/// analysis of the doubling algorithm, SIAM J. Matrix Anal. Appl. 31, 2009). A closed loop with an eigenvalue
/// closer to the unit circle than √ε cannot be distinguished from one with an eigenvalue on it; the
/// additional steps handle motions that are slow compared with others and less affected by rounding.
template <class Number, int states>
constexpr riccati_solution<Number, states> doubled(riccati_equation<Number, states> e) {
  using limits = std::numeric_limits<Number>;
  constexpr Number root = power_of_two_near_root(limits::epsilon()), most = 8 / root, little = 8 * root,
                   medium = power_of_two_near_root(little);
  constexpr int most_steps = limits::digits * 3 / 4, most_slow_steps = limits::digits / 9;
  constexpr Number most_of_any = numeric::power_of_two<Number>(limits::max_exponent / 4),
                   most_at_first = numeric::power_of_two<Number>(limits::max_exponent / 8);
  int slow_steps = 0;
  Number size = numeric::largest_entry(e.a);
  if (!(size < most_at_first)) return {e.q, doubling::stops};
  // Until the inputs take effect, each doubling at most squares the factor by which one large step multiplies
  // the state.
  const Number large = most * (1 + size * size), growth = large < most_of_any ? large : most_of_any;
  for (int k = 0; k < most_steps; ++k) {
    if (!(size < growth)) return {e.q, doubling::does_not_decay};
    if (slow_steps > most_slow_steps) return {e.q, doubling::halves};
    if (!is_moderate(e.g) || !is_moderate(e.q)) return {e.q, doubling::stops};
    const numeric::eliminated<Number, states> w(numeric::identity<Number, states>() + e.g * e.q);
    if (w.is_singular()) return {e.q, doubling::stops};
    const fixed_matrix<Number, states, states> v = w.solve(e.a), at = numeric::transposed(e.a),
                                               wg = w.solve(e.g);
    if (!is_moderate(v) || !is_moderate(wg)) return {e.q, doubling::stops};
    e.g = numeric::symmetric(e.g + e.a * wg * at);
    e.q = numeric::symmetric(e.q + at * (e.q * v));
    e.a = e.a * v;
    const Number before = size;
    size = numeric::largest_entry(e.a);
    if (size <= limits::epsilon() * limits::epsilon()) return {e.q, doubling::solves};
    if (size > little && size < medium && size > before / 4 && size < before * 3 / 4) ++slow_steps;
  }
  return {e.q, doubling::does_not_decay};
}

/// The Cayley transform of a continuous-time equation: the discrete-time equation with the same solution
/// (Chu, Fan & Lin, A structure-preserving doubling algorithm for continuous-time algebraic Riccati
/// equations, Linear Algebra Appl. 396, 2005). Its matrices are [A, G; −Q, Aᵀ] = 1 + 2γ S⁻¹ diag(1, −1) with
/// S = [A − γ, −G; −Q, γ − Aᵀ].
template <class Number, int states>
class cayley {
public:
  constexpr cayley(const riccati_equation<Number, states>& e, Number shift) {
    const numeric::eliminated<Number, 2 * states> s(hamiltonian(e, shift));
    if (s.is_singular()) return;
    fixed_matrix<Number, 2 * states, 2 * states> right;
    for (int i = 0; i < states; ++i) right(i, i) = 2 * shift, right(states + i, states + i) = -2 * shift;
    const fixed_matrix<Number, 2 * states, 2 * states> found = s.solve(right);
    if (!is_moderate(found)) return;
    size = 1 + numeric::largest_entry(found);
    for (int i = 0; i < states; ++i)
      for (int j = 0; j < states; ++j) {
        discrete.a(i, j) = found(i, j) + (i == j ? Number(1) : Number(0));
        discrete.g(i, j) = found(i, states + j);
        discrete.q(i, j) = -found(states + i, j);
      }
    discrete.g = numeric::symmetric(discrete.g);
    discrete.q = numeric::symmetric(discrete.q);
  }

  /// Returns [A − γ, −G; −Q, γ − Aᵀ], which is the Hamiltonian matrix for γ = 0.
  static constexpr fixed_matrix<Number, 2 * states, 2 * states>
  hamiltonian(const riccati_equation<Number, states>& e, Number shift) {
    fixed_matrix<Number, 2 * states, 2 * states> h;
    for (int i = 0; i < states; ++i)
      for (int j = 0; j < states; ++j) {
        const Number diagonal = i == j ? shift : Number(0);
        h(i, j) = e.a(i, j) - diagonal;
        h(i, states + j) = -e.g(i, j);
        h(states + i, j) = -e.q(i, j);
        h(states + i, states + j) = diagonal - e.a(j, i);
      }
    return h;
  }

  riccati_equation<Number, states> discrete{};
  Number size = 0; ///< its largest entry; zero if S is singular
};

/// Returns a power of two near the geometric mean of the eigenvalues of a matrix, computed from its pivots;
/// zero if a pivot vanishes or nearly vanishes.
template <class Number, int states>
constexpr Number mean_rate(const numeric::eliminated<Number, states>& m) {
  if (m.is_singular()) return 0;
  constexpr int most = 2 * std::numeric_limits<Number>::max_exponent;
  int exponent = 0;
  Number product = 1; // the product of the reciprocals of the pivots
  for (int k = 0; k < states; ++k) {
    product *= numeric::constant_elimination_math::magnitude(m.reciprocal(k));
    for (int i = 0; i < most && product >= 2; ++i) product /= 2, --exponent;
    for (int i = 0; i < most && product < 1; ++i) product *= 2, ++exponent;
    if (!(product >= 1 && product < 2)) return 0; // the product overflowed or underflowed
  }
  Number mean = 1;
  for (int i = 0; i < exponent / states; ++i) mean *= 2;
  for (int i = 0; i < -exponent / states; ++i) mean /= 2;
  return mean;
}

/// Returns a stabilizing solution. It fails if there is none, and sometimes if Q does not weight a growing
/// motion.
template <time_domain domain, class Number, int states>
constexpr riccati_solution<Number, states> stabilizing(const riccati_equation<Number, states>& e) {
  if constexpr (domain == time_domain::discrete) {
    return doubled(e);
  } else {
    // If the shift is an eigenvalue of A, S may be nearly singular, but this cannot happen for all three
    // shifts.
    const Number mean =
        mean_rate(numeric::eliminated<Number, 2 * states>(cayley<Number, states>::hamiltonian(e, 0)));
    if (!(mean > 0)) return {{}, doubling::halves}; // an eigenvalue is zero
    cayley<Number, states> best(e, mean);
    for (const Number shift : {mean / 2, 2 * mean}) {
      const cayley<Number, states> other(e, shift);
      if (other.size > 0 && (!(best.size > 0) || other.size < best.size)) best = other;
    }
    return best.size > 0 ? doubled(best.discrete) : riccati_solution<Number, states>{};
  }
}

} // namespace kanexpr::control
