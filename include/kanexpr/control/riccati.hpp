#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/control/balance.hpp>
#include <kanexpr/control/doubling.hpp>

namespace kanexpr::control {

/// The reasons why a Riccati equation may have no solution.
inline constexpr status not_stabilizable("the system is not stabilizable to working precision: its inputs do "
                                         "not reach a motion that does not decay"),
    not_detectable_on_axis("the system is not detectable on the imaginary axis: the state weights do not "
                           "cover a motion that neither grows nor decays"),
    not_detectable_on_circle("the system is not detectable on the unit circle: the state weights do not "
                             "cover a motion that neither grows nor decays"),
    not_converged("the Riccati equation could not be solved to working precision"),
    too_large("the solution of the Riccati equation overflows");

/// Returns the equation of the correction Δ in a solution X + Δ: the same equation with the closed loop at X
/// in place of A and the residual of X in place of Q (Mehrmann & Tan, Defect correction methods for the
/// solution of algebraic Riccati equations, IEEE Trans. Autom. Control 33, 1988).
template <time_domain domain, class Number, int states>
constexpr riccati_equation<Number, states> defect(const riccati_equation<Number, states>& e,
                                                  const fixed_matrix<Number, states, states>& x) {
  const fixed_matrix<Number, states, states> xa = x * e.a, gx = e.g * x;
  if constexpr (domain == time_domain::continuous) {
    return {e.a - gx, e.g, numeric::symmetric(e.q + xa + numeric::transposed(xa) - x * gx)};
  } else {
    const numeric::eliminated<Number, states> w(numeric::identity<Number, states>() + gx);
    const fixed_matrix<Number, states, states> closed = w.solve(e.a);
    return {closed, numeric::symmetric(w.solve(e.g)),
            numeric::symmetric(e.q - x + numeric::transposed(xa) * closed)};
  }
}

/// Solves Aᵀ X + X A + W = 0 or X = Aᵀ X A + W for two matrices W, where A is the matrix of a decaying closed
/// loop, by squaring (Smith, Matrix equation XA + BX = C, SIAM J. Appl. Math. 16, 1968).
template <time_domain domain, class Number, int states>
constexpr bool solve_linear(fixed_matrix<Number, states, states> a,
                            fixed_matrix<Number, states, states>& first,
                            fixed_matrix<Number, states, states>& second) {
  using limits = std::numeric_limits<Number>;
  if constexpr (domain == time_domain::continuous) {
    const Number shift = mean_rate(numeric::eliminated<Number, states>(a));
    const numeric::eliminated<Number, states> shifted(a - shift * numeric::identity<Number, states>());
    if (!(shift > 0) || shifted.is_singular()) return false;
    const fixed_matrix<Number, states, states> inverse = shifted.solve(numeric::identity<Number, states>());
    if (!is_moderate(inverse) || !is_moderate(first) || !is_moderate(second)) return false;
    const fixed_matrix<Number, states, states> twice = 2 * shift * inverse;
    if (!(numeric::largest_entry(twice) < 1 / limits::epsilon())) return false;
    for (fixed_matrix<Number, states, states>* each : {&first, &second})
      *each = numeric::transposed(twice) * (*each * inverse);
    a = numeric::identity<Number, states>() + twice;
  }
  for (int k = 0; k < limits::digits; ++k) {
    const Number size = numeric::largest_entry(a);
    if (!(size < 1 / limits::epsilon())) return false;
    const fixed_matrix<Number, states, states> at = numeric::transposed(a);
    for (fixed_matrix<Number, states, states>* each : {&first, &second}) {
      if (!is_moderate(*each)) return false;
      *each = numeric::symmetric(*each + at * (*each * a));
    }
    if (size <= limits::epsilon()) return true;
    a = a * a;
  }
  return false;
}

template <class Number, int states>
constexpr fixed_matrix<Number, states, states> magnitudes(fixed_matrix<Number, states, states> m) {
  for (Number& entry : m.entries) entry = numeric::constant_elimination_math::magnitude(entry);
  return m;
}

/// Refines a solution by Newton's method (Kleinman, On an iterative technique for Riccati equation
/// computations, IEEE Trans. Autom. Control 13, 1968) until only rounding changes it. Returns false if that
/// change is large, or if rounding could keep the closed loop from decaying. In the second case, there is a
/// motion that grows, or decays so slowly that rounding hides the decay, and the inputs reach it only through
/// rounding.
template <time_domain domain, class Number, int states>
constexpr bool refine(const riccati_equation<Number, states>& e, fixed_matrix<Number, states, states>& x) {
  using limits = std::numeric_limits<Number>;
  constexpr Number accurate = power_of_two_near_root(limits::epsilon());
  constexpr Number tolerable = Number(1) / 1024; // bound on the repeated changes that rounding causes
  constexpr int most_steps = 4;
  Number before = most_of_solution<Number>;
  for (int i = 0; i < most_steps; ++i) {
    if (!is_moderate(x)) return false;
    const riccati_equation<Number, states> rest = defect<domain>(e, x);
    const Number size = numeric::largest_entry(x);
    fixed_matrix<Number, states, states> change = rest.q, weight, cost;
    for (int k = 0; k < states; ++k) weight(k, k) = size > 0 ? x(k, k) + limits::epsilon() * size : Number(1);
    cost = weight;
    if (!solve_linear<domain>(rest.a, change, cost)) return false;
    const fixed_matrix<Number, states, states> rounding =
        magnitudes(cost) * (limits::epsilon() * (magnitudes(e.g) * magnitudes(x)));
    for (int k = 0; k < states; ++k)
      for (int j = 0; j <= k; ++j) {
        const Number both = rounding(k, j) + rounding(j, k);
        if (both > weight(k, k) && both > weight(j, j)) return false; // its square might overflow
        if (!(both * both <= weight(k, k) * weight(j, j))) return false;
      }
    const Number moved = numeric::largest_entry(change);
    if (moved > before / 2) break;
    x = x + change;
    if (moved <= accurate * size) return true;
    before = moved;
  }
  return before <= tolerable * numeric::largest_entry(x);
}

/// Determines the states that the inputs reach, directly or through other states.
template <class Number, int states>
class reach {
public:
  constexpr explicit reach(const riccati_equation<Number, states>& e) {
    constexpr auto larger = balance::larger;
    const exponents<states, states> a = exponents_of(e.a);
    const int rate = larger(largest_exponent(a), 0); // all entries are divided by the largest rate
    for (int i = 0; i < states; ++i) unit.of[i] = numeric::exponent_of(e.g(i, i)) / 2;
    for (int further = 1; further < states; ++further)
      for (int i = 0; i < states; ++i)
        for (int j = 0; j < states; ++j) unit.of[i] = larger(unit.of[i], a(i, j) - rate + unit.of[j]);
    for (int i = 0; i < states; ++i) {
      is_reached[i] = unit.of[i] > numeric::exponent_of_zero / 4;
      if (!is_reached[i]) unit.of[i] = 0;
    }
    for (int i = 0; i < states; ++i)
      for (int j = 0; j < states; ++j)
        if (!is_reached[i] && is_reached[j]) unit.of[i] = -larger(-unit.of[i], a(j, i) - rate - unit.of[j]);
  }

  /// Whether there is a state that depends on no other state, does not decay, and is not reached by any
  /// input.
  template <time_domain domain>
  constexpr bool has_unreached_persistent_state(const fixed_matrix<Number, states, states>& a) const {
    for (int i = 0; i < states; ++i) {
      bool is_alone = !is_reached[i];
      for (int j = 0; j < states; ++j) is_alone = is_alone && (i == j || base::equal(a(i, j), Number(0)));
      if (is_alone && (a(i, i) >= (domain == time_domain::discrete ? 1 : 0) ||
                       (domain == time_domain::discrete && a(i, i) <= -1)))
        return true;
    }
    return false;
  }

  units<states> unit; ///< the units in which the inputs act on all states equally

private:
  bool is_reached[static_cast<std::size_t>(states > 0 ? states : 1)]{};
};

/// Whether the zero entries of a matrix are the same before and after scaling.
template <class Number, int rows, int columns>
constexpr bool has_same_zeros(const fixed_matrix<Number, rows, columns>& a,
                              const fixed_matrix<Number, rows, columns>& b) {
  for (int i = 0; i < rows * columns; ++i)
    if (base::equal(a.entries[i], Number(0)) != base::equal(b.entries[i], Number(0))) return false;
  return true;
}

/// Whether the entries of a matrix differ so much in magnitude, from each other or from 1, that rounding may
/// hide the small ones, or 1.
template <class Number, int states>
constexpr bool is_graded(const fixed_matrix<Number, states, states>& m) {
  constexpr int half = std::numeric_limits<Number>::digits / 2;
  const exponents<states, states> of = exponents_of(m);
  const int large = balance::larger(largest_exponent(of), 0), tiny = large - half;
  if (large > half / 2) return true;
  for (const int each : of.entries)
    if (!numeric::is_exponent_of_zero(each) && each < tiny) return true;
  return false;
}

/// Solves a balanced equation with Q positive semidefinite. It reports a property of the system as the cause
/// only if this finding cannot be due to rounding.
template <time_domain domain, class Number, int states>
constexpr status solve_balanced(const riccati_equation<Number, states>& e,
                                fixed_matrix<Number, states, states>& x) {
  const riccati_solution<Number, states> direct = stabilizing<domain>(e);
  x = direct.x;
  if (direct.found() && refine<domain>(e, x)) return {};
  // With a weight on every state, a solution exists if the system is stabilizable.
  const reach<Number, states> of_inputs(e);
  const units<states>& unit = of_inputs.unit;
  const riccati_equation<Number, states> weighted{unit.template scaled<-1, 1>(e.a, unit),
                                                  unit.template scaled<-1, -1>(e.g, unit),
                                                  numeric::identity<Number, states>()};
  if (of_inputs.template has_unreached_persistent_state<domain>(e.a)) return not_stabilizable;
  if (!is_moderate(weighted.a) || !is_moderate(weighted.g)) return not_converged;
  const riccati_solution<Number, states> nearby = stabilizing<domain>(weighted);
  x = nearby.x;
  if (!nearby.found() || !refine<domain>(weighted, x)) {
    if (is_graded(weighted.a) || !has_same_zeros(weighted.a, e.a)) return not_converged;
    if (nearby.result == doubling::does_not_decay || nearby.result == doubling::halves)
      return not_stabilizable;
    // If the inputs reach a motion only through rounding, its cost exceeds any cost that widely spread rates
    // could cause.
    const Number size = numeric::largest_entry(weighted.a),
                 large = (1 + size * size) / (1024 * std::numeric_limits<Number>::epsilon());
    const bool is_large = !numeric::is_finite(nearby.x) || numeric::largest_entry(nearby.x) > large;
    return is_large ? not_stabilizable : not_converged;
  }
  x = unit.template scaled<-1, -1>(x, unit);
  if (!is_moderate(x)) return not_converged;
  const riccati_solution<Number, states> rest = stabilizing<domain>(defect<domain>(e, x));
  const bool halves = direct.result == doubling::halves || rest.result == doubling::halves;
  if (!rest.found() && halves && !is_positive_definite(e.q))
    return domain == time_domain::continuous ? not_detectable_on_axis : not_detectable_on_circle;
  if (!rest.found()) return not_converged;
  x = x + rest.x;
  return refine<domain>(e, x) ? status() : not_converged;
}

/// A Riccati equation in units in which its matrices have similar magnitudes.
template <time_domain domain, class Number, int states, int others>
class scaled_equation {
public:
  constexpr scaled_equation(const fixed_matrix<Number, states, states>& a,
                            const fixed_matrix<Number, states, others>& b,
                            const fixed_matrix<Number, states, states>& q,
                            const fixed_matrix<Number, others, others>& r)
      : inputs_(diagonal_units(r)) {
    constexpr auto larger = balance::larger;
    const exponents<states, states> ea = exponents_of(a), eq = exponents_of(q);
    const exponents<states, others> eb = exponents_of(b);
    exponents<states, states> eg;
    int diagonal = numeric::exponent_of_zero;
    for (int i = 0; i < states; ++i) {
      diagonal = larger(diagonal, ea(i, i));
      for (int j = 0; j < states; ++j) {
        eg(i, j) = numeric::exponent_of_zero;
        for (int k = 0; k < others; ++k) eg(i, j) = larger(eg(i, j), eb(i, k) + eb(j, k) + 2 * inputs_.of[k]);
      }
    }
    const bool has_diagonal = !numeric::is_exponent_of_zero(diagonal);
    states_ = balanced_units(ea, eg, eq, has_diagonal ? diagonal : 0);
    int of_a = numeric::exponent_of_zero, of_g = of_a, of_q = of_a;
    for (int i = 0; i < states; ++i)
      for (int j = 0; j < states; ++j) {
        of_a = larger(of_a, ea(i, j) - states_.of[i] + states_.of[j]);
        of_g = larger(of_g, eg(i, j) - states_.of[i] - states_.of[j]);
        of_q = larger(of_q, eq(i, j) + states_.of[i] + states_.of[j]);
      }
    const int common = common_unit(domain == time_domain::discrete ? 0 : of_a, of_g, of_q);
    for (int& each : states_.of) each += common;
    if constexpr (domain == time_domain::continuous) {
      const int largest = larger(of_a, larger(of_g - 2 * common, of_q + 2 * common));
      if (!numeric::is_exponent_of_zero(largest)) half_rate_ = largest / 2;
    }
    matrix_ = states_.template scaled<-1, 1>(a, states_, -2 * half_rate_);
    by_inputs_ = states_.template scaled<-1, 1>(b, inputs_, -half_rate_);
    state_weights_ = states_.template scaled<1, 1>(q, states_, -2 * half_rate_);
    input_weights_ = inputs_.template scaled<1, 1>(r, inputs_);
    is_complete_ =
        has_same_zeros(matrix_, a) && has_same_zeros(by_inputs_, b) && has_same_zeros(state_weights_, q);
    for (const Number entry : by_inputs_.entries) // their squares must not underflow
      is_complete_ =
          is_complete_ && (base::equal(entry, Number(0)) ||
                           2 * numeric::exponent_of(entry) > std::numeric_limits<Number>::min_exponent + 4);
  }

  /// Computes the gain K and the cost matrix P if they exist.
  constexpr status solve(fixed_matrix<Number, others, states>& gain,
                         fixed_matrix<Number, states, states>& cost) const {
    constexpr auto is_small = [](const auto& each) {
      constexpr Number most = numeric::power_of_two<Number>(std::numeric_limits<Number>::max_exponent / 4);
      return numeric::is_finite(each) && numeric::largest_entry(each) < most;
    };
    if (!is_small(matrix_) || !is_small(by_inputs_) || !is_small(state_weights_)) return too_large;
    const numeric::positive_factors<Number, others> inputs(input_weights_);
    const fixed_matrix<Number, others, states> bt = numeric::transposed(by_inputs_);
    fixed_matrix<Number, states, states> x;
    if (const status s = solve_balanced<domain>(
            riccati_equation<Number, states>{matrix_, numeric::symmetric(by_inputs_ * inputs.solve(bt)),
                                             numeric::symmetric(state_weights_)},
            x);
        !s)
      return is_complete_ ? s : not_converged;
    if constexpr (domain == time_domain::continuous) {
      gain = inputs.solve(bt * x);
    } else {
      const numeric::positive_factors<Number, others> both(
          numeric::symmetric(input_weights_ + bt * x * by_inputs_));
      if (!both) return not_converged;
      gain = both.solve(bt * x * matrix_);
    }
    gain = inputs_.template scaled<1, -1>(gain, states_, half_rate_);
    cost = states_.template scaled<-1, -1>(x, states_);
    return numeric::is_finite(gain) && numeric::is_finite(cost) ? status() : too_large;
  }

private:
  /// Returns an additional unit common to all states. If Q or G is zero, the other one is scaled to the
  /// magnitude of A; if both are small compared with A, G is scaled down further, to keep the cost of a
  /// growing motion small.
  static constexpr int common_unit(int of_a, int of_g, int of_q) {
    using limits = std::numeric_limits<Number>;
    constexpr int medium = limits::digits, least = limits::min_exponent + 2 * limits::digits;
    const bool has_g = !numeric::is_exponent_of_zero(of_g), has_q = !numeric::is_exponent_of_zero(of_q);
    const int rate = numeric::is_exponent_of_zero(of_a) ? 0 : of_a;
    if (!has_g && !has_q) return 0;
    if (!has_q) return (of_g - rate) / 2;
    if (!has_g) return (rate - of_q) / 2;
    const int wanted = rate - medium - of_g, possible = of_q - rate - least;
    return -balance::larger(0, wanted < possible ? wanted : possible) / 2;
  }

  units<others> inputs_;
  units<states> states_;
  bool is_complete_ = true; ///< no entry underflows
  int half_rate_ = 0;       ///< the rates are divided by the square of this power of two
  fixed_matrix<Number, states, states> matrix_, state_weights_;
  fixed_matrix<Number, states, others> by_inputs_;
  fixed_matrix<Number, others, others> input_weights_;
};

} // namespace kanexpr::control
