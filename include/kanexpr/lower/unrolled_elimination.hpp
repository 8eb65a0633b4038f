#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/numeric/elimination.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <utility>

namespace kanexpr::lower {

/// The operations that elimination requires of a scalar type.
template <class Number>
struct elimination_math {
  [[gnu::always_inline]] static Number magnitude(const Number& x) {
    return scalar_math<Number>::template by_name<symbolic::operation::abs>(x);
  }
  [[gnu::always_inline]] static Number root(const Number& x) {
    return scalar_math<Number>::template by_name<symbolic::operation::sqrt>(x);
  }
  [[gnu::always_inline]] static Number reciprocal(const Number& x) {
    return Number(scalar_math<Number>::from(1) / x);
  }
  [[gnu::always_inline]] static void exchange_if_positive(const Number& d, Number& a, Number& b) {
    scalar_math<Number>::exchange_if_positive(d, a, b);
  }
};

/// The steps of numeric/elimination.hpp, unrolled with constant indices.
template <int order, class Number>
class unrolled_elimination {
  using math = elimination_math<Number>;
  static constexpr numeric::factors place{order};
  template <int count>
  using numbers = std::make_integer_sequence<int, count>;

public:
  [[gnu::always_inline]] static void factorize(Number* f) noexcept { factorize(f, numbers<order>{}); }
  [[gnu::always_inline]] static void solve(const Number* f, Number* x) noexcept {
    solve(f, x, numbers<order>{});
  }
  [[gnu::always_inline]] static void solve_transposed(const Number* f, Number* x) noexcept {
    solve_transposed(f, x, numbers<order>{});
  }
  [[gnu::always_inline]] static Number singularity_measure(const Number* f, Number* squares) noexcept {
    return singularity_measure(f, squares, numbers<order>{});
  }

private:
  template <int... step>
  [[gnu::always_inline]] static void factorize(Number* f, std::integer_sequence<int, step...>) noexcept {
    Number least = math::magnitude(f[0]); // overwritten by the first pivot
    (pivot<step>(f, least, numbers<order - 1 - step>{}), ...);
    f[place.least_pivot()] = least;
  }

  template <int step, int... below>
  [[gnu::always_inline]] static void pivot(Number* f, Number& least,
                                           std::integer_sequence<int, below...>) noexcept {
    (compare<step, step + 1 + below>(f, numbers<order - step>{}), ...);
    Number& pivot = f[place.at(step, step)];
    Number size = math::magnitude(pivot);
    if constexpr (step == 0)
      least = size;
    else
      math::exchange_if_positive(Number(least - size), least, size);
    pivot = math::reciprocal(pivot);
    (update<step, step + 1 + below>(f, numbers<order - 1 - step>{}), ...);
  }

  template <int pivot, int row, int... right>
  [[gnu::always_inline]] static void compare(Number* f, std::integer_sequence<int, right...>) noexcept {
    Number& excess = f[place.excess(pivot, row)];
    excess = Number(math::magnitude(f[place.at(row, pivot)]) - math::magnitude(f[place.at(pivot, pivot)]));
    (math::exchange_if_positive(excess, f[place.at(pivot, pivot + right)], f[place.at(row, pivot + right)]),
     ...);
  }

  template <int pivot, int row, int... right>
  [[gnu::always_inline]] static void update(Number* f, std::integer_sequence<int, right...>) noexcept {
    Number& multiplier = f[place.at(row, pivot)];
    multiplier = Number(multiplier * f[place.at(pivot, pivot)]);
    (subtract(f[place.at(row, pivot + 1 + right)], multiplier, f[place.at(pivot, pivot + 1 + right)]), ...);
  }

  /// Evaluates a -= b c.
  [[gnu::always_inline]] static void subtract(Number& a, const Number& b, const Number& c) noexcept {
    a = Number(a - Number(b * c));
  }

  template <int... pivot>
  [[gnu::always_inline]] static Number singularity_measure(const Number* f, Number* squares,
                                                           std::integer_sequence<int, pivot...>) noexcept {
    Number largest = f[0]; // overwritten by the first pivot
    (inverse<pivot>(f, squares, largest, numbers<order - 1 - pivot>{}), ...);
    Number least = f[place.least_pivot()], beside = math::root(math::reciprocal(largest));
    math::exchange_if_positive(f[place.least_pivot()], least, beside);
    return least; // if a pivot is zero, the entries that follow it are NaN
  }
  template <int pivot, int... below>
  [[gnu::always_inline]] static void inverse(const Number* f, Number* squares, Number& largest,
                                             std::integer_sequence<int, below...>) noexcept {
    (exchange<pivot, pivot + 1 + below>(f, squares, numbers<order - pivot>{}), ...);
    const Number& inverse = f[place.at(pivot, pivot)];
    Number own = Number(inverse * Number(inverse * squares[place.at(pivot, pivot)]));
    if constexpr (pivot > 0) math::exchange_if_positive(Number(largest - own), own, largest);
    largest = own;
    (grow<pivot, pivot + 1 + below>(f, squares, numbers<order - 1 - pivot>{}), ...);
  }
  template <int pivot, int row, int... right>
  [[gnu::always_inline]] static void exchange(const Number* f, Number* squares,
                                              std::integer_sequence<int, right...>) noexcept {
    (math::exchange_if_positive(f[place.excess(pivot, row)], squares[place.at(pivot, pivot + right)],
                                squares[place.at(row, pivot + right)]),
     ...);
  }
  template <int pivot, int row, int... right>
  [[gnu::always_inline]] static void grow(const Number* f, Number* squares,
                                          std::integer_sequence<int, right...>) noexcept {
    const Number square = Number(f[place.at(row, pivot)] * f[place.at(row, pivot)]);
    (add(squares[place.at(row, pivot + 1 + right)], square, squares[place.at(pivot, pivot + 1 + right)]),
     ...);
  }

  /// Evaluates a += b c.
  [[gnu::always_inline]] static void add(Number& a, const Number& b, const Number& c) noexcept {
    a = Number(a + Number(b * c));
  }

  template <int... pivot>
  [[gnu::always_inline]] static void solve(const Number* f, Number* x,
                                           std::integer_sequence<int, pivot...>) noexcept {
    (forward<pivot>(f, x, numbers<order - 1 - pivot>{}), ...);
    (backward<order - 1 - pivot>(f, x, numbers<pivot>{}), ...);
  }
  template <int pivot, int... below>
  [[gnu::always_inline]] static void forward([[maybe_unused]] const Number* f, [[maybe_unused]] Number* x,
                                             std::integer_sequence<int, below...>) noexcept {
    (math::exchange_if_positive(f[place.excess(pivot, pivot + 1 + below)], x[pivot], x[pivot + 1 + below]),
     ...);
    (subtract(x[pivot + 1 + below], f[place.at(pivot + 1 + below, pivot)], x[pivot]), ...);
  }
  template <int pivot, int... right>
  [[gnu::always_inline]] static void backward(const Number* f, Number* x,
                                              std::integer_sequence<int, right...>) noexcept {
    (subtract(x[pivot], f[place.at(pivot, pivot + 1 + right)], x[pivot + 1 + right]), ...);
    x[pivot] = Number(x[pivot] * f[place.at(pivot, pivot)]);
  }

  template <int... pivot>
  [[gnu::always_inline]] static void solve_transposed(const Number* f, Number* x,
                                                      std::integer_sequence<int, pivot...>) noexcept {
    (forward_transposed<pivot>(f, x, numbers<order - 1 - pivot>{}), ...);
    (backward_transposed<order - 1 - pivot>(f, x, numbers<pivot>{}), ...);
  }
  template <int pivot, int... right>
  [[gnu::always_inline]] static void forward_transposed(const Number* f, Number* x,
                                                        std::integer_sequence<int, right...>) noexcept {
    x[pivot] = Number(x[pivot] * f[place.at(pivot, pivot)]);
    (subtract(x[pivot + 1 + right], f[place.at(pivot, pivot + 1 + right)], x[pivot]), ...);
  }
  template <int pivot, int... below>
  [[gnu::always_inline]] static void backward_transposed([[maybe_unused]] const Number* f,
                                                         [[maybe_unused]] Number* x,
                                                         std::integer_sequence<int, below...>) noexcept {
    (subtract(x[pivot], f[place.at(pivot + 1 + below, pivot)], x[pivot + 1 + below]), ...);
    (math::exchange_if_positive(f[place.excess(pivot, order - 1 - below)], x[pivot], x[order - 1 - below]),
     ...);
  }
};

} // namespace kanexpr::lower
