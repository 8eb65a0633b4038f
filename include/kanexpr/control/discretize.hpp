#pragma once

#include <kanexpr/control/balance.hpp>
#include <kanexpr/control/matrices.hpp>

#include <array>
#include <bit>
#include <tuple>

namespace kanexpr {

/// x⁺ = A x + B r + c, what ẋ = A x + B r + c becomes over a step in which r and c stay as they are.
template <class StateMatrix, class InputMatrix, class Offset>
struct discrete_form {
  StateMatrix A;
  InputMatrix B;
  Offset c;
  kanexpr::status status;

  /// Whether the matrices can be used.
  constexpr explicit operator bool() const { return static_cast<bool>(status); }
};

namespace control {

/// What a sum of n products may add to their exponents.
template <int n>
inline constexpr int of_sum = 2 + std::bit_width(static_cast<unsigned>(n));

/// How often a step of length h is halved, so that the norm of A h, by columns, is below 1/2.
template <class T, int n>
constexpr int halvings(const fixed_matrix<T, n, n>& a, T h) {
  const int most = numeric::exponent_of(numeric::largest_entry(a)) + numeric::exponent_of(h) + of_sum<n>;
  if (most >= std::numeric_limits<T>::max_exponent) return most + 1; // the norm might be too large
  T norm = 0;
  for (int j = 0; j < n; ++j) {
    T sum = 0;
    for (int i = 0; i < n; ++i) sum += numeric::constant_elimination_math::magnitude(h * a(i, j));
    if (sum > norm) norm = sum;
  }
  return balance::larger(0, numeric::exponent_of(norm) + 2);
}

/// Whether no term of a product is too large, nor their sums.
template <class T, int n, int m, int l>
constexpr bool is_product_finite(const fixed_matrix<T, n, m>& a, const fixed_matrix<T, m, l>& b) {
  constexpr int most = std::numeric_limits<T>::max_exponent - of_sum<m>;
  const int of_b = numeric::exponent_of(numeric::largest_entry(b));
  if (numeric::is_exponent_of_zero(of_b)) return true;
  if (numeric::exponent_of(numeric::largest_entry(a)) + of_b < most) return true;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < l; ++j)
      for (int k = 0; k < m; ++k)
        if (numeric::exponent_of(a(i, k)) + numeric::exponent_of(b(k, j)) >= most) return false;
  return true;
}

template <class T, int n>
struct exponential {
  fixed_matrix<T, n, n> change{};   ///< exp(A h) − 1
  fixed_matrix<T, n, n> integral{}; ///< ∫ exp(A s) ds from 0 to h
};

/// (exp(X) − 1)/X by Taylor's series, in few products of matrices (Paterson & Stockmeyer, On the number of
/// nonscalar multiplications necessary to evaluate polynomials, SIAM J. Comput. 2, 1973): those of four, or
/// three, powers of X that follow each other are one factor of a higher power.
template <class T, int n>
constexpr fixed_matrix<T, n, n> mean_motion(const fixed_matrix<T, n, n>& x) {
  constexpr bool is_short = std::numeric_limits<T>::digits <= 24;
  constexpr int terms = is_short ? 9 : 15; // the next is below rounding, (1/2)ᵏ/(k + 1)!
  constexpr int block = is_short ? 3 : 4;
  fixed_matrix<T, n, n> powers[std::size_t{block + 1}]{numeric::identity<T, n>(), x};
  for (int k = 2; k <= block; ++k) powers[k] = powers[k - 1] * x;
  constexpr auto weights = [] {
    std::array<T, std::size_t{terms}> found{1};
    for (std::size_t k = 1; k < found.size(); ++k) found[k] = found[k - 1] / T(k + 1);
    return found;
  }();
  fixed_matrix<T, n, n> sum;
  for (int first = (terms - 1) / block * block; first >= 0; first -= block) {
    if (first + block < terms) sum = sum * powers[block];
    for (int k = first; k < first + block && k < terms; ++k)
      for (int i = 0; i < n * n; ++i)
        sum.entries[i] += weights[static_cast<std::size_t>(k)] * powers[k - first].entries[i];
  }
  return sum;
}

/// Both by Taylor's series of a short step, which is doubled until it is as long as asked (Van Loan,
/// Computing integrals involving the matrix exponential, IEEE Trans. Autom. Control 23, 1978): the integral
/// over two steps is that over one, and what the motion of one makes of it. What is slow beside the rest
/// loses nothing, for its change is doubled, not its 1. False where they would overflow.
template <class T, int n>
constexpr bool find_exponential(const fixed_matrix<T, n, n>& a, T h, int doublings, exponential<T, n>& e) {
  constexpr T most = numeric::power_of_two<T>(std::numeric_limits<T>::max_exponent / 2 - 8);
  const T length = numeric::times_power_of_two(h, -doublings);
  e.integral = length * mean_motion(length * a);
  e.change = a * e.integral;
  for (int i = 0; i < doublings; ++i) {
    if (!(numeric::largest_entry(e.change) < most && is_product_finite(e.change, e.integral))) return false;
    e.integral = T(2) * e.integral + e.change * e.integral;
    e.change = T(2) * e.change + e.change * e.change;
  }
  return true;
}

/// What is wrong with what a discrete form is asked of.
template <class T, int n, int inputs>
constexpr status mistake_in(const fixed_matrix<T, n, n>& a, const fixed_matrix<T, n, inputs>& b,
                            const fixed_matrix<T, n, 1>& c, T h) {
  if (!numeric::is_finite(fixed_matrix<T, 1, 1>{{h}})) return status("the length of the step is not finite");
  if (!numeric::is_finite(a)) return status("the state matrix A is not finite");
  if (!numeric::is_finite(b)) return status("the input matrix B is not finite");
  if (!numeric::is_finite(c)) return status("the offset c is not finite");
  return {};
}

template <class T, int n, int inputs>
using fixed_discrete_form =
    discrete_form<fixed_matrix<T, n, n>, fixed_matrix<T, n, inputs>, fixed_matrix<T, n, 1>>;

template <class T, int n, int inputs>
constexpr fixed_discrete_form<T, n, inputs>
discretized(const fixed_matrix<T, n, n>& a, const fixed_matrix<T, n, inputs>& b,
            const fixed_matrix<T, n, 1>& c, T h, const status& given) {
  const fixed_discrete_form<T, n, inputs> none{no_numbers<T, n, n>(), no_numbers<T, n, inputs>(),
                                               no_numbers<T, n, 1>(), given ? mistake_in(a, b, c, h) : given};
  if (!none) return none;
  fixed_discrete_form<T, n, inputs> found = none;
  exponential<T, n> e;
  bool is_found = false;
  if (const int doublings = halvings(a, h); doublings == 0) {
    is_found = find_exponential(a, h, 0, e);
  } else {
    constexpr exponents<n, n> nothing = exponents_of(fixed_matrix<T, n, n>{});
    const units<n> unit = balanced_units(exponents_of(a), nothing, nothing, -numeric::exponent_of(h));
    const fixed_matrix<T, n, n> balanced = unit.template scaled<-1, 1>(a, unit);
    is_found = numeric::is_finite(balanced) && find_exponential(balanced, h, halvings(balanced, h), e);
    if (is_found) {
      e.change = unit.template scaled<1, -1>(e.change, unit);
      e.integral = unit.template scaled<1, -1>(e.integral, unit);
      is_found = numeric::is_finite(e.change) && numeric::is_finite(e.integral);
    }
  }
  if (is_found && is_product_finite(e.integral, b) && is_product_finite(e.integral, c))
    return {numeric::identity<T, n>() + e.change, e.integral * b, e.integral * c, {}};
  found.status = status("the motion of the linear system over the step is too large for numbers");
  return found;
}

/// The same of any matrices, of which a status may come with each.
template <class A, class B, class C>
constexpr auto discretized_as_given(const A& a, const B& b, const C& c, typename shape<A>::scalar h) {
  using T = typename shape<A>::scalar;
  constexpr int n = shape<A>::rows, inputs = shape<B>::columns;
  constexpr bool are_sizes_fitting = are_fitting<A, B>();
  static_assert(!are_sizes_fitting || (shape<C>::rows == n && shape<C>::columns == 1),
                "the offset c has a number for each row of A");
  constexpr bool is_offset_alike = std::is_same_v<typename shape<C>::scalar, T>;
  static_assert(!are_sizes_fitting || is_offset_alike,
                "the numbers of A and of the offset c are of different types");
  if constexpr (!are_sizes_fitting || !is_offset_alike) {
    return fixed_discrete_form<T, 1, 1>{};
  } else {
    const auto found = discretized<T, n, inputs>(fixed(a), fixed(b), fixed(c), h, first_failure(a, b, c));
    const auto like = [](const auto& m) { return shape<A>::like(m); };
    return discrete_form<decltype(like(found.A)), decltype(like(found.B)), decltype(like(found.c))>{
        like(found.A), like(found.B), like(found.c), found.status};
  }
}

} // namespace control

/// The matrices of ẋ = A x + B r over a step of length h in which the inputs hold (zero-order hold): `const
/// auto [Ad, Bd, cd, status] = discretize(A, B, h);`. A and B are matrices of Eigen whose size the compiler
/// knows, as those of a linearization, or of `numeric::fixed_matrix` in a constant expression. Exact but for
/// rounding. Where a status says that there are none they are not numbers.
template <control::matrix A, control::matrix B>
constexpr auto discretize(const A& a, const B& b, typename control::shape<A>::scalar h) {
  using offset = numeric::fixed_matrix<typename control::shape<A>::scalar, control::shape<A>::rows, 1>;
  return control::discretized_as_given(a, b, offset{}, h);
}

/// The same of ẋ = A x + B r + c, as of a linearization about a state that does not rest, where c is its
/// rate.
template <control::matrix A, control::matrix B, control::matrix C>
constexpr auto discretize(const A& a, const B& b, const C& c, typename control::shape<A>::scalar h) {
  return control::discretized_as_given(a, b, c, h);
}

/// The same of both matrices of a linearization: `discretize(linearization<System>::explicit_form(x, p, r),
/// h)`.
template <class A, class B>
constexpr auto discretize(const std::tuple<A, B>& both, typename control::shape<A>::scalar h) {
  return discretize(std::get<0>(both), std::get<1>(both), h);
}
template <class A, class B, control::matrix C>
constexpr auto discretize(const std::tuple<A, B>& both, const C& c, typename control::shape<A>::scalar h) {
  return discretize(std::get<0>(both), std::get<1>(both), c, h);
}

} // namespace kanexpr
