#pragma once

#include <kanexpr/lower/scalar_math.hpp>

#include <Eigen/Core>

/// The compiler's own vectors as scalars, `typedef double pack __attribute__((vector_size(32)));`: a function
/// of a `state<System, pack>` evaluates as many states side by side as a pack has lanes. Include this header
/// for it.
namespace kanexpr::lower {

template <class T>
concept vector_extension = !std::is_class_v<T> && requires(const T v) {
  v[0];
  v* v;
};

/// Arithmetic is the compiler's, sines and cosines are taken of all lanes at once, other functions lane by
/// lane. Each lane has the bits of its own evaluation.
template <vector_extension T>
struct scalar_math<T> {
  using element = std::remove_cvref_t<decltype(std::declval<const T&>()[0])>;
  using of_element = scalar_math<element>;
  static constexpr int lanes = static_cast<int>(sizeof(T) / sizeof(element));

  [[gnu::always_inline]] static T from(const T& value) { return value; }
  template <class Value>
  [[gnu::always_inline]] static T from(const Value& value) {
    const element one = of_element::from(value);
    return each([&](int) { return one; });
  }

  [[gnu::always_inline]] static void sincos(const T& angle, T& sine, T& cosine) {
    if constexpr (has_own_sines<element>) return numeric::sine_and_cosine(angle, sine, cosine);
    for (int i = 0; i < lanes; ++i) {
      element s, c;
      of_element::sincos(angle[i], s, c);
      sine[i] = s;
      cosine[i] = c;
    }
  }
  template <std::size_t count>
  [[gnu::always_inline]] static void sincos(const T (&angle)[count], T (&sine)[count], T (&cosine)[count]) {
    for (std::size_t i = 0; i < count; ++i) sincos(angle[i], sine[i], cosine[i]);
  }

  template <symbolic::operation op>
  [[gnu::always_inline]] static T by_name(const T& x) {
    using symbolic::operation;
    if constexpr (has_own_sines<element> && (op == operation::sin || op == operation::cos)) {
      T sine, cosine;
      numeric::sine_and_cosine(x, sine, cosine);
      return op == operation::sin ? sine : cosine;
    }
    return each([&](int i) { return of_element::template by_name<op>(x[i]); });
  }
  [[gnu::always_inline]] static void exchange_if_positive(const T& d, T& a, T& b) {
    const auto exchanged = d > 0;
    const T upper = exchanged ? b : a, lower = exchanged ? a : b;
    a = upper;
    b = lower;
  }
  [[gnu::always_inline]] static T power(const T& x, const T& y) {
    return each([&](int i) { return of_element::power(x[i], y[i]); });
  }
  [[gnu::always_inline]] static T atan2(const T& y, const T& x) {
    return each([&](int i) { return of_element::atan2(y[i], x[i]); });
  }

  /// In all lanes.
  [[gnu::always_inline]] static bool exceeds(const T& x, const T& bound) {
    bool all = true;
    for (int i = 0; i < lanes; ++i) all = all && of_element::exceeds(x[i], bound[i]);
    return all;
  }

  [[gnu::always_inline]] static bool is_finite(const T& x) {
    bool all = true;
    for (int i = 0; i < lanes; ++i) all = all && of_element::is_finite(x[i]);
    return all;
  }

private:
  template <class Lane>
  [[gnu::always_inline]] static T each(const Lane& lane) {
    T all{};
    for (int i = 0; i < lanes; ++i) all[i] = lane(i);
    return all;
  }
};

} // namespace kanexpr::lower

namespace Eigen {

/// Enough for Eigen to store packs and to give them back.
template <kanexpr::lower::vector_extension T>
struct NumTraits<T> : GenericNumTraits<T> {
  enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};

/// A pack asks for its own alignment, which may be more than Eigen would.
template <kanexpr::lower::vector_extension T, int size>
struct internal::compute_default_alignment<T, size> {
  enum { value = 0 };
};

} // namespace Eigen
