#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/numeric/elimination.hpp>

namespace kanexpr::lower {

/// What elimination needs of a scalar type.
template <class T>
struct elimination_math {
  [[gnu::always_inline]] static T magnitude(const T& x) {
    return scalar_math<T>::template by_name<symbolic::operation::abs>(x);
  }
  [[gnu::always_inline]] static T root(const T& x) {
    return scalar_math<T>::template by_name<symbolic::operation::sqrt>(x);
  }
  [[gnu::always_inline]] static T reciprocal(const T& x) { return T(scalar_math<T>::from(1) / x); }
  [[gnu::always_inline]] static void exchange_if_positive(const T& d, T& a, T& b) {
    scalar_math<T>::exchange_if_positive(d, a, b);
  }
};

/// The steps of numeric/elimination.hpp one by one, with constant places only.
template <int order, class T>
class unrolled_elimination {
  using math = elimination_math<T>;
  static constexpr numeric::factors place{order};
  template <int count>
  using numbers = std::make_integer_sequence<int, count>;

public:
  [[gnu::always_inline]] static void factorize(T* f) noexcept { factorize(f, numbers<order>{}); }
  [[gnu::always_inline]] static void solve(const T* f, T* x) noexcept { solve(f, x, numbers<order>{}); }
  [[gnu::always_inline]] static void solve_transposed(const T* f, T* x) noexcept {
    solve_transposed(f, x, numbers<order>{});
  }
  [[gnu::always_inline]] static T singularity_measure(const T* f, T* squares) noexcept {
    return singularity_measure(f, squares, numbers<order>{});
  }

private:
  template <int... k>
  [[gnu::always_inline]] static void factorize(T* f, std::integer_sequence<int, k...>) noexcept {
    T least = math::magnitude(f[0]); // overwritten by the first pivot
    const int in_order[]{(pivot<k>(f, least, numbers<order - 1 - k>{}), 0)...};
    static_cast<void>(in_order);
    f[place.least_pivot()] = least;
  }

  template <int k, int... below>
  [[gnu::always_inline]] static void pivot(T* f, T& least, std::integer_sequence<int, below...>) noexcept {
    const int exchanged[]{0, (compare<k, k + 1 + below>(f, numbers<order - k>{}), 0)...};
    T& pivot = f[place.at(k, k)];
    T size = math::magnitude(pivot);
    if constexpr (k == 0)
      least = size;
    else
      math::exchange_if_positive(T(least - size), least, size);
    pivot = math::reciprocal(pivot);
    const int eliminated[]{0, (update<k, k + 1 + below>(f, numbers<order - 1 - k>{}), 0)...};
    static_cast<void>(exchanged), static_cast<void>(eliminated);
  }

  template <int k, int i, int... right>
  [[gnu::always_inline]] static void compare(T* f, std::integer_sequence<int, right...>) noexcept {
    T& excess = f[place.excess(k, i)];
    excess = T(math::magnitude(f[place.at(i, k)]) - math::magnitude(f[place.at(k, k)]));
    const int exchanged[]{
        (math::exchange_if_positive(excess, f[place.at(k, k + right)], f[place.at(i, k + right)]), 0)...};
    static_cast<void>(exchanged);
  }

  template <int k, int i, int... right>
  [[gnu::always_inline]] static void update(T* f, std::integer_sequence<int, right...>) noexcept {
    T& multiplier = f[place.at(i, k)];
    multiplier = T(multiplier * f[place.at(k, k)]);
    const int updated[]{
        (subtract(f[place.at(i, k + 1 + right)], multiplier, f[place.at(k, k + 1 + right)]), 0)...};
    static_cast<void>(updated);
  }

  /// a -= b c
  [[gnu::always_inline]] static void subtract(T& a, const T& b, const T& c) noexcept { a = T(a - T(b * c)); }

  template <int... k>
  [[gnu::always_inline]] static T singularity_measure(const T* f, T* squares,
                                                      std::integer_sequence<int, k...>) noexcept {
    T largest = f[0]; // overwritten by the first
    const int in_order[]{(inverse<k>(f, squares, largest, numbers<order - 1 - k>{}), 0)...};
    static_cast<void>(in_order);
    T least = f[place.least_pivot()], beside = math::root(math::reciprocal(largest));
    math::exchange_if_positive(f[place.least_pivot()], least, beside);
    return least; // where a pivot is zero, what comes behind it is not a number
  }
  template <int k, int... below>
  [[gnu::always_inline]] static void inverse(const T* f, T* squares, T& largest,
                                             std::integer_sequence<int, below...>) noexcept {
    const int exchanged[]{0, (exchange<k, k + 1 + below>(f, squares, numbers<order - k>{}), 0)...};
    const T& inverse = f[place.at(k, k)];
    T own = T(inverse * T(inverse * squares[place.at(k, k)]));
    if constexpr (k > 0) math::exchange_if_positive(T(largest - own), own, largest);
    largest = own;
    const int grown[]{0, (grow<k, k + 1 + below>(f, squares, numbers<order - 1 - k>{}), 0)...};
    static_cast<void>(exchanged), static_cast<void>(grown);
  }
  template <int k, int i, int... right>
  [[gnu::always_inline]] static void exchange(const T* f, T* squares,
                                              std::integer_sequence<int, right...>) noexcept {
    const int exchanged[]{(math::exchange_if_positive(f[place.excess(k, i)], squares[place.at(k, k + right)],
                                                      squares[place.at(i, k + right)]),
                           0)...};
    static_cast<void>(exchanged);
  }
  template <int k, int i, int... right>
  [[gnu::always_inline]] static void grow(const T* f, T* squares,
                                          std::integer_sequence<int, right...>) noexcept {
    const T square = T(f[place.at(i, k)] * f[place.at(i, k)]);
    const int grown[]{
        (add(squares[place.at(i, k + 1 + right)], square, squares[place.at(k, k + 1 + right)]), 0)...};
    static_cast<void>(grown);
  }

  /// a += b c
  [[gnu::always_inline]] static void add(T& a, const T& b, const T& c) noexcept { a = T(a + T(b * c)); }

  template <int... k>
  [[gnu::always_inline]] static void solve(const T* f, T* x, std::integer_sequence<int, k...>) noexcept {
    const int down[]{(forward<k>(f, x, numbers<order - 1 - k>{}), 0)...};
    const int up[]{(backward<order - 1 - k>(f, x, numbers<k>{}), 0)...};
    static_cast<void>(down), static_cast<void>(up);
  }
  template <int k, int... below>
  [[gnu::always_inline]] static void forward([[maybe_unused]] const T* f, [[maybe_unused]] T* x,
                                             std::integer_sequence<int, below...>) noexcept {
    const int done[]{
        0, (math::exchange_if_positive(f[place.excess(k, k + 1 + below)], x[k], x[k + 1 + below]), 0)...,
        (subtract(x[k + 1 + below], f[place.at(k + 1 + below, k)], x[k]), 0)...};
    static_cast<void>(done);
  }
  template <int k, int... right>
  [[gnu::always_inline]] static void backward(const T* f, T* x,
                                              std::integer_sequence<int, right...>) noexcept {
    const int done[]{0, (subtract(x[k], f[place.at(k, k + 1 + right)], x[k + 1 + right]), 0)...};
    static_cast<void>(done);
    x[k] = T(x[k] * f[place.at(k, k)]);
  }

  template <int... k>
  [[gnu::always_inline]] static void solve_transposed(const T* f, T* x,
                                                      std::integer_sequence<int, k...>) noexcept {
    const int down[]{(forward_transposed<k>(f, x, numbers<order - 1 - k>{}), 0)...};
    const int up[]{(backward_transposed<order - 1 - k>(f, x, numbers<k>{}), 0)...};
    static_cast<void>(down), static_cast<void>(up);
  }
  template <int k, int... right>
  [[gnu::always_inline]] static void forward_transposed(const T* f, T* x,
                                                        std::integer_sequence<int, right...>) noexcept {
    x[k] = T(x[k] * f[place.at(k, k)]);
    const int done[]{0, (subtract(x[k + 1 + right], f[place.at(k, k + 1 + right)], x[k]), 0)...};
    static_cast<void>(done);
  }
  template <int k, int... below>
  [[gnu::always_inline]] static void backward_transposed([[maybe_unused]] const T* f, [[maybe_unused]] T* x,
                                                         std::integer_sequence<int, below...>) noexcept {
    const int done[]{
        0, (subtract(x[k], f[place.at(k + 1 + below, k)], x[k + 1 + below]), 0)...,
        (math::exchange_if_positive(f[place.excess(k, order - 1 - below)], x[k], x[order - 1 - below]),
         0)...};
    static_cast<void>(done);
  }
};

} // namespace kanexpr::lower
