#pragma once

#include <kanexpr/numeric/selection.hpp>
#include <kanexpr/numeric/sines_and_cosines.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace kanexpr::lower {

template <class Number>
struct scalar_math;

/// Whether sines and cosines are computed by this library, in straight-line code for several angles together.
/// With the macro KANEXPR_SINES_OF_THE_LIBRARY they come from the C library.
template <class Number>
inline constexpr bool has_own_sines =
#if defined(KANEXPR_SINES_OF_THE_LIBRARY)
    false;
#else
    std::is_same_v<Number, double> || std::is_same_v<Number, float>;
#endif

/// The functions that evaluation requires of a scalar type. Functions such as `sin(x)` are found by
/// argument-dependent lookup.
template <class Number>
struct default_scalar_math {
  /// Converts a constant, or an argument of a different type.
  template <class Value>
  static Number from(const Value& value) {
    return Number(value);
  }

  [[gnu::always_inline]] static void sincos(const Number& angle, Number& sine, Number& cosine) {
    if constexpr (has_own_sines<Number>) return numeric::sine_and_cosine(angle, sine, cosine);
#if defined(__GLIBC__)
    if constexpr (std::is_same_v<Number, double>) return ::sincos(angle, &sine, &cosine);
    if constexpr (std::is_same_v<Number, float>) return ::sincosf(angle, &sine, &cosine);
    if constexpr (std::is_same_v<Number, long double>) return ::sincosl(angle, &sine, &cosine);
#endif
    using std::cos;
    using std::sin;
    sine = sin(angle);
    cosine = cos(angle);
  }

  /// Evaluates several angles together.
  template <std::size_t count>
  [[gnu::always_inline]] static void sincos(const Number (&angle)[count], Number (&sine)[count],
                                            Number (&cosine)[count]) {
    if constexpr (has_own_sines<Number>)
      numeric::sines_and_cosines(angle, sine, cosine);
    else
      one_by_one(angle, sine, cosine, std::make_index_sequence<count>{});
  }
  template <std::size_t... index>
  [[gnu::always_inline]] static void one_by_one(const Number* angle, Number* sine, Number* cosine,
                                                std::index_sequence<index...>) {
    (sincos(angle[index], sine[index], cosine[index]), ...);
  }

  template <symbolic::operation op>
  static Number by_name(const Number& x) {
    using symbolic::operation;
    if constexpr (has_own_sines<Number> && (op == operation::sin || op == operation::cos)) {
      Number sine, cosine;
      numeric::sine_and_cosine(x, sine, cosine);
      return op == operation::sin ? sine : cosine;
    } else {
      return symbolic::function_value<op>(x);
    }
  }

  /// Returns whether x > bound; false if x is NaN.
  static bool exceeds(const Number& x, const Number& bound) { return x > bound; }

  /// Tests the bits if the format is known, and therefore works with -ffast-math.
  static bool is_finite(const Number& x) {
    if constexpr (std::is_same_v<Number, double>)
      return is_finite(std::bit_cast<std::uint64_t>(x), std::uint64_t{0x7ff} << 52);
    else if constexpr (std::is_same_v<Number, float>)
      return is_finite(std::bit_cast<std::uint32_t>(x), std::uint32_t{0xff} << 23);
    else
      return scalar_math<Number>::exceeds(Number(x - x),
                                          scalar_math<Number>::from(-1)); // otherwise the difference is NaN
  }
  template <class Bits>
  [[gnu::always_inline]] static bool is_finite(Bits bits, Bits exponent) {
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
    asm("" : "+r"(bits)); // hides the origin of the bits from clang++
#endif
    return (bits & exponent) != exponent;
  }

  static Number sign(const Number& x) { return symbolic::sign_of(x); }
  /// Exchanges a and b if d is positive; uses selection because a branch would depend on the data.
  [[gnu::always_inline]] static void exchange_if_positive(const Number& d, Number& a, Number& b) {
    const bool exchanged = Number(0) < d;
    const Number upper = exchanged ? b : a, lower = exchanged ? a : b;
    a = upper;
    b = lower;
  }
  /// Returns x if the condition is positive (or, for the other operation, not positive), otherwise zero.
  template <symbolic::operation op>
  [[gnu::always_inline]] static Number selected(const Number& condition, const Number& x) {
    constexpr bool wants_positive = op == symbolic::operation::if_positive;
    if constexpr (numeric::selected_by_masks<Number>)
      return wants_positive ? numeric::where_positive(condition, x)
                            : numeric::where_not_positive(condition, x);
    else if (Number(0) < condition)
      return wants_positive ? x : Number(0);
    else if (condition <= Number(0))
      return wants_positive ? Number(0) : x;
    else
      return condition; // NaN
  }
  /// A user-supplied function.
  template <class Function>
  static constexpr bool calls = Function::template accepts<Number>();
  template <class Function>
  static constexpr bool interprets = true;
  template <class Function>
  [[gnu::always_inline]] static Number called(const auto&... x) {
    return Function::template value<Number>(x...);
  }
  /// The overload for an interpreter, whose user-supplied functions are evaluated in double.
  static Number called(const symbolic::external_function& f, const Number* x) {
    if constexpr (std::is_same_v<Number, double>) {
      return f.value(x);
    } else {
      static_assert(
          requires { static_cast<double>(*x); },
          "the interpreter calls user-supplied functions only with scalar types that convert to double");
      double operands[symbolic::max_operands]{};
      for (int i = 0; i < f.operands; ++i) operands[i] = static_cast<double>(x[i]);
      return Number(f.value(operands));
    }
  }
  static Number power(const Number& x, const Number& y) {
    using std::pow;
    return pow(x, y);
  }
  template <symbolic::operation op>
  static Number by_name(const Number& a, const Number& b) {
    return symbolic::binary_function<op>::of(a, b);
  }
};

/// Specialize this class to replace functions, for example to compute sine and cosine with a vector routine:
/// `template <> struct scalar_math<double> : default_scalar_math<double> { … };`
template <class Number>
struct scalar_math : default_scalar_math<Number> {};

/// Applies one operation of a tape to values of one type. Only here does a step become arithmetic, in
/// compiled and in interpreted evaluation. If the processor supports it, products and the sums that use them
/// are contracted into fused multiply-adds; clang++ would otherwise contract only within one statement.
/// KANEXPR_NO_FUSING prevents the contraction.
template <symbolic::operation op, class Number>
[[gnu::always_inline]] inline Number apply(const Number& a, const Number& b) {
#if defined(__clang__) && !defined(KANEXPR_NO_FUSING)
#pragma clang fp contract(fast)
#endif
  using symbolic::operation;
  if constexpr (symbolic::is_function(op))
    return scalar_math<Number>::template by_name<op>(a);
  else if constexpr (op == operation::negate)
    return Number(-a);
  else if constexpr (op == operation::add)
    return Number(a + b);
  else if constexpr (op == operation::subtract)
    return Number(a - b);
  else if constexpr (op == operation::multiply)
    return Number(a * b);
  else if constexpr (op == operation::divide)
    return Number(a / b);
  else if constexpr (op == operation::power)
    return scalar_math<Number>::power(a, b);
  else if constexpr (symbolic::is_selection(op))
    return scalar_math<Number>::template selected<op>(a, b);
  else {
    static_assert(symbolic::is_binary_function(op));
    return scalar_math<Number>::template by_name<op>(a, b);
  }
}

/// Converts a constant to the scalar type; exact fractions are divided in that type, so that a long double
/// keeps all its digits.
template <class Number>
[[gnu::always_inline]] inline Number number_as(const symbolic::number& n) {
  if (n.denominator == 0) return scalar_math<Number>::from(n.real);
  const Number numerator = scalar_math<Number>::from(static_cast<double>(n.numerator));
  if (n.denominator == 1) return numerator;
  return Number(numerator / scalar_math<Number>::from(static_cast<double>(n.denominator)));
}

/// Whether the magnitude of a measure exceeds `least` times that of its scale. An infinite or NaN measure is
/// not reported as singular, because the results that depend on it are not finite, and finiteness is checked
/// last.
template <class Number>
[[gnu::always_inline]] inline bool is_regular(const Number& measure, const Number& scale, double least) {
  using math = scalar_math<Number>;
  const Number size = math::template by_name<symbolic::operation::abs>(measure);
  const Number bound = Number(math::from(least) * math::template by_name<symbolic::operation::abs>(scale));
  if constexpr (std::is_arithmetic_v<Number>)
    return !(size - bound <= 0); // infinity minus infinity is NaN
  else if constexpr (requires { math::is_in_no_lane(size <= bound); })
    return math::is_in_no_lane(size - bound <= Number{}); // lanes are independent of each other
  else
    return math::exceeds(size, bound) || !math::is_finite(measure);
}

/// Whether a measure meets the condition of a status: it is finite, or it is regular relative to its scale.
template <bool finiteness, class Number>
[[gnu::always_inline]] inline bool passes(const Number& measure, [[maybe_unused]] const Number& scale,
                                          [[maybe_unused]] double least) {
  if constexpr (finiteness)
    return scalar_math<Number>::is_finite(measure);
  else
    return is_regular<Number>(measure, scale, least);
}

} // namespace kanexpr::lower
