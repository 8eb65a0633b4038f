#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/control/balance.hpp>
#include <kanexpr/control/matrices.hpp>

#include <array>
#include <bit>
#include <tuple>
#include <type_traits>

#include <kanexpr/base/letters_aside.hpp>

namespace kanexpr {

/// The discrete-time form x⁺ = A x + B r + c of ẋ = A x + B r + c over a step in which r and c are constant.
template <class StateMatrix, class InputMatrix, class Offset>
struct discrete_form {
  StateMatrix A;
  InputMatrix B;
  Offset c;
  kanexpr::status status;

  /// Whether the matrices are valid.
  constexpr explicit operator bool() const { return static_cast<bool>(status); }
};

namespace control {

/// An upper bound on the increase of the exponent when n products are summed.
template <int states>
inline constexpr int of_sum = 2 + std::bit_width(static_cast<unsigned>(states));

/// Returns the number of times a step of length h must be halved for the column-sum norm of A h to be below
/// 1/2.
template <class Number, int states>
constexpr int halvings(const fixed_matrix<Number, states, states>& a, Number h) {
  const int most = numeric::exponent_of(numeric::largest_entry(a)) + numeric::exponent_of(h) + of_sum<states>;
  if (most >= std::numeric_limits<Number>::max_exponent) return most + 1; // the norm might overflow
  Number norm = 0;
  for (int j = 0; j < states; ++j) {
    Number sum = 0;
    for (int i = 0; i < states; ++i) sum += numeric::constant_elimination_math::magnitude(h * a(i, j));
    if (sum > norm) norm = sum;
  }
  return balance::larger(0, numeric::exponent_of(norm) + 2);
}

/// Whether all terms of a product and their sums are finite.
template <class Number, int states, int inputs, int columns>
constexpr bool is_product_finite(const fixed_matrix<Number, states, inputs>& a,
                                 const fixed_matrix<Number, inputs, columns>& b) {
  constexpr int most = std::numeric_limits<Number>::max_exponent - of_sum<inputs>;
  const int of_b = numeric::exponent_of(numeric::largest_entry(b));
  if (numeric::is_exponent_of_zero(of_b)) return true;
  if (numeric::exponent_of(numeric::largest_entry(a)) + of_b < most) return true;
  for (int i = 0; i < states; ++i)
    for (int j = 0; j < columns; ++j)
      for (int k = 0; k < inputs; ++k)
        if (numeric::exponent_of(a(i, k)) + numeric::exponent_of(b(k, j)) >= most) return false;
  return true;
}

template <class Number, int states>
struct exponential {
  fixed_matrix<Number, states, states> change{};   ///< exp(A h) − 1
  fixed_matrix<Number, states, states> integral{}; ///< ∫ exp(A s) ds from 0 to h
};

/// Evaluates (exp(X) − 1)/X by its Taylor series with few matrix products (Paterson & Stockmeyer, On the
/// number of nonscalar multiplications necessary to evaluate polynomials, SIAM J. Comput. 2, 1973): each
/// group of four (or three) consecutive powers of X is multiplied by a common higher power.
template <class Number, int states>
constexpr fixed_matrix<Number, states, states> mean_motion(const fixed_matrix<Number, states, states>& x) {
  constexpr bool is_short = std::numeric_limits<Number>::digits <= 24;
  constexpr int terms = is_short ? 9 : 15; // the next term, (1/2)ᵏ/(k + 1)!, is below rounding
  constexpr int block = is_short ? 3 : 4;
  fixed_matrix<Number, states, states> powers[std::size_t{block + 1}]{numeric::identity<Number, states>(), x};
  for (int k = 2; k <= block; ++k) powers[k] = powers[k - 1] * x;
  constexpr auto weights = [] {
    std::array<Number, std::size_t{terms}> found{1};
    for (std::size_t k = 1; k < found.size(); ++k) found[k] = found[k - 1] / Number(k + 1);
    return found;
  }();
  fixed_matrix<Number, states, states> sum;
  for (int first = (terms - 1) / block * block; first >= 0; first -= block) {
    if (first + block < terms) sum = sum * powers[block];
    for (int k = first; k < first + block && k < terms; ++k)
      for (int i = 0; i < states * states; ++i)
        sum.entries[i] += weights[static_cast<std::size_t>(k)] * powers[k - first].entries[i];
  }
  return sum;
}

/// Evaluates exp(A h) − 1 and the integral by the Taylor series for a short step, which is doubled until it
/// reaches the requested length (Van Loan, Computing integrals involving the matrix exponential, IEEE Trans.
/// Autom. Control 23, 1978): the integral over two steps is the integral over one plus its image under the
/// motion of one step. Because exp(A h) − 1 is doubled, not exp(A h), slow motions next to fast ones do not
/// lose accuracy. Returns false on overflow.
template <class Number, int states>
constexpr bool find_exponential(const fixed_matrix<Number, states, states>& a, Number h, int doublings,
                                exponential<Number, states>& e) {
  constexpr Number most = numeric::power_of_two<Number>(std::numeric_limits<Number>::max_exponent / 2 - 8);
  const Number length = numeric::times_power_of_two(h, -doublings);
  e.integral = length * mean_motion(length * a);
  e.change = a * e.integral;
  for (int i = 0; i < doublings; ++i) {
    if (!(numeric::largest_entry(e.change) < most && is_product_finite(e.change, e.integral))) return false;
    e.integral = Number(2) * e.integral + e.change * e.integral;
    e.change = Number(2) * e.change + e.change * e.change;
  }
  return true;
}

/// Checks the arguments of a discretization.
template <class Number, int states, int inputs>
constexpr status mistake_in(const fixed_matrix<Number, states, states>& a,
                            const fixed_matrix<Number, states, inputs>& b,
                            const fixed_matrix<Number, states, 1>& c, Number h) {
  if (!numeric::is_finite(h)) return status("the step length is not finite");
  if (!numeric::is_finite(a)) return status("the state matrix A is not finite");
  if (!numeric::is_finite(b)) return status("the input matrix B is not finite");
  if (!numeric::is_finite(c)) return status("the offset c is not finite");
  return {};
}

template <class Number, int states, int inputs>
using fixed_discrete_form =
    discrete_form<fixed_matrix<Number, states, states>, fixed_matrix<Number, states, inputs>,
                  fixed_matrix<Number, states, 1>>;

template <class Number, int states, int inputs>
constexpr fixed_discrete_form<Number, states, inputs>
discretized(const fixed_matrix<Number, states, states>& a, const fixed_matrix<Number, states, inputs>& b,
            const fixed_matrix<Number, states, 1>& c, Number h, const status& given) {
  const fixed_discrete_form<Number, states, inputs> none{
      no_numbers<Number, states, states>(), no_numbers<Number, states, inputs>(),
      no_numbers<Number, states, 1>(), given ? mistake_in(a, b, c, h) : given};
  if (!none) return none;
  fixed_discrete_form<Number, states, inputs> found = none;
  exponential<Number, states> e;
  bool is_found = false;
  if (const int doublings = halvings(a, h); doublings == 0) {
    is_found = find_exponential(a, h, 0, e);
  } else {
    constexpr exponents<states, states> nothing = exponents_of(fixed_matrix<Number, states, states>{});
    const units<states> unit = balanced_units(exponents_of(a), nothing, nothing, -numeric::exponent_of(h));
    const fixed_matrix<Number, states, states> balanced = unit.template scaled<-1, 1>(a, unit);
    is_found = numeric::is_finite(balanced) && find_exponential(balanced, h, halvings(balanced, h), e);
    if (is_found) {
      e.change = unit.template scaled<1, -1>(e.change, unit);
      e.integral = unit.template scaled<1, -1>(e.integral, unit);
      is_found = numeric::is_finite(e.change) && numeric::is_finite(e.integral);
    }
  }
  if (is_found && is_product_finite(e.integral, b) && is_product_finite(e.integral, c))
    return {numeric::identity<Number, states>() + e.change, e.integral * b, e.integral * c, {}};
  found.status = status("the motion of the linear system over the step overflows");
  return found;
}

/// Discretizes matrices of any supported type, each of which may carry a status.
template <class StateMatrix, class InputMatrix, class Offset>
constexpr auto discretized_as_given(const StateMatrix& a, const InputMatrix& b, const Offset& c,
                                    typename shape<StateMatrix>::scalar h) {
  using Number = typename shape<StateMatrix>::scalar;
  constexpr int n = shape<StateMatrix>::rows, inputs = shape<InputMatrix>::columns;
  constexpr bool are_sizes_fitting = are_fitting<StateMatrix, InputMatrix>();
  static_assert(!are_sizes_fitting || (shape<Offset>::rows == n && shape<Offset>::columns == 1),
                "the offset c must have one entry for each row of A");
  constexpr bool is_offset_alike = std::is_same_v<typename shape<Offset>::scalar, Number>;
  static_assert(!are_sizes_fitting || is_offset_alike, "A and the offset c have different scalar types");
  if constexpr (!are_sizes_fitting || !is_offset_alike) {
    return fixed_discrete_form<Number, 1, 1>{};
  } else {
    const auto found =
        discretized<Number, n, inputs>(fixed(a), fixed(b), fixed(c), h, first_failure(a, b, c));
    const auto like = [](const auto& m) { return shape<StateMatrix>::like(m); };
    return discrete_form<decltype(like(found.A)), decltype(like(found.B)), decltype(like(found.c))>{
        like(found.A), like(found.B), like(found.c), found.status};
  }
}

} // namespace control

/// Returns the matrices of ẋ = A x + B r over a step of length h with constant inputs (zero-order hold):
/// `const auto [Ad, Bd, cd, status] = discretize(A, B, h);`. A and B are fixed-size Eigen matrices, such as
/// those of a linearization, or `numeric::fixed_matrix` in a constant expression. The result is exact up to
/// rounding. If the status reports a failure, the entries are NaN.
template <control::matrix StateMatrix, control::matrix InputMatrix>
constexpr auto discretize(const StateMatrix& a, const InputMatrix& b,
                          typename control::shape<StateMatrix>::scalar h) {
  using offset = numeric::fixed_matrix<typename control::shape<StateMatrix>::scalar,
                                       control::shape<StateMatrix>::rows, 1>;
  return control::discretized_as_given(a, b, offset{}, h);
}

/// Discretizes ẋ = A x + B r + c, for example a linearization about a state that is not an equilibrium, where
/// c is the rate of that state.
template <control::matrix StateMatrix, control::matrix InputMatrix, control::matrix Offset>
constexpr auto discretize(const StateMatrix& a, const InputMatrix& b, const Offset& c,
                          typename control::shape<StateMatrix>::scalar h) {
  return control::discretized_as_given(a, b, c, h);
}

/// Discretizes both matrices of a linearization: `discretize(linearization<System>::explicit_form(x, p, r),
/// h)`.
template <class StateMatrix, class InputMatrix>
constexpr auto discretize(const std::tuple<StateMatrix, InputMatrix>& both,
                          typename control::shape<StateMatrix>::scalar h) {
  return discretize(std::get<0>(both), std::get<1>(both), h);
}
template <class StateMatrix, class InputMatrix, control::matrix Offset>
constexpr auto discretize(const std::tuple<StateMatrix, InputMatrix>& both, const Offset& c,
                          typename control::shape<StateMatrix>::scalar h) {
  return discretize(std::get<0>(both), std::get<1>(both), c, h);
}

} // namespace kanexpr

#include <kanexpr/base/letters_back.hpp>
