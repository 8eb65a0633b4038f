#pragma once

#include <kanexpr/control/balance.hpp>
#include <kanexpr/control/matrices.hpp>

#include <array>
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

/// Beyond this a step is doubled.
template <class T>
inline constexpr T longest = T(0.5);

/// The norm of A h by columns.
template <class T, int n>
constexpr T size_over(const fixed_matrix<T, n, n>& a, T h) {
  T most = 0;
  for (int j = 0; j < n; ++j) {
    T sum = 0;
    for (int i = 0; i < n; ++i) sum += numeric::constant_elimination_math::magnitude(h * a(i, j));
    if (sum > most) most = sum;
  }
  return most;
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
/// loses nothing, for its change is doubled, not its 1. Not numbers where they would overflow.
template <class T, int n>
constexpr exponential<T, n> exponential_of(const fixed_matrix<T, n, n>& a, T h) {
  using limits = std::numeric_limits<T>;
  constexpr T most = [] { // of which a product is finite
    T power = 1;
    for (int i = 0; i < limits::max_exponent / 2 - 8; ++i) power *= 2;
    return power;
  }();
  int doublings = 0;
  T length = h;
  for (T size = size_over(a, h); size > longest<T> && doublings < limits::max_exponent; size /= 2) {
    ++doublings;
    length /= 2;
  }
  exponential<T, n> e;
  e.integral = length * mean_motion(length * a);
  e.change = a * e.integral;
  for (int i = 0; i < doublings; ++i) {
    if (!(numeric::largest_entry(e.change) < most && numeric::largest_entry(e.integral) < most))
      return {no_numbers<T, n, n>(), no_numbers<T, n, n>()};
    e.integral = T(2) * e.integral + e.change * e.integral;
    e.change = T(2) * e.change + e.change * e.change;
  }
  return e;
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
  units<T, n> unit;
  if (size_over(a, h) > longest<T>)
    unit = balanced_units(a, fixed_matrix<T, n, n>{}, fixed_matrix<T, n, n>{});
  const exponential<T, n> e = exponential_of(unit.scaled(a), h);
  fixed_discrete_form<T, n, inputs> found = none;
  if (numeric::is_finite(e.change) && numeric::is_finite(e.integral))
    found = {unit.unscaled(numeric::identity<T, n>() + e.change),
             unit.multiplied(e.integral * unit.divided(b)),
             unit.multiplied(e.integral * unit.divided(c)),
             {}};
  if (numeric::is_finite(found.A) && numeric::is_finite(found.B) && numeric::is_finite(found.c)) return found;
  found = none;
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
  if constexpr (!are_sizes_fitting) {
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
