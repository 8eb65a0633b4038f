#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/numeric/sines_and_cosines_of_vectors.hpp>
#include <kanexpr/numeric/square_roots.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <Eigen/Core>

#include <limits>
#include <type_traits>

/// Compiler vectors as scalar types, `typedef double pack __attribute__((vector_size(32)));`: a function of a
/// `state<System, pack>` evaluates as many states side by side as a pack has lanes. Include this header to
/// use them.
namespace kanexpr::lower {

template <class Vector>
concept vector_extension = !std::is_class_v<Vector> && requires(const Vector v) {
  v[0];
  v* v;
};

/// The compiler provides the arithmetic; sines, cosines and square roots are computed for all lanes together,
/// other functions lane by lane. Each lane holds the same bits as a separate evaluation.
template <vector_extension Vector>
struct scalar_math<Vector> {
  using element = std::remove_cvref_t<decltype(std::declval<const Vector&>()[0])>;
  using of_element = scalar_math<element>;
  static constexpr int lanes = static_cast<int>(sizeof(Vector) / sizeof(element));

  [[gnu::always_inline]] static Vector from(const Vector& value) { return value; }
  template <class Value>
  [[gnu::always_inline]] static Vector from(const Value& value) {
    return of_element::from(value) - Vector{}; // minus zero, so that zeros keep their sign
  }

  [[gnu::always_inline]] static void sincos(const Vector& angle, Vector& sine, Vector& cosine) {
    const Vector angles[]{angle};
    Vector sines[1], cosines[1];
    sincos(angles, sines, cosines);
    sine = sines[0];
    cosine = cosines[0];
  }
  template <std::size_t count>
  [[gnu::always_inline]] static void sincos(const Vector (&angle)[count], Vector (&sine)[count],
                                            Vector (&cosine)[count]) {
    if constexpr (has_own_sines<element>) return numeric::sines_and_cosines(angle, sine, cosine);
    for (std::size_t i = 0; i < count; ++i)
      for (int lane = 0; lane < lanes; ++lane) {
        element s, c;
        of_element::sincos(angle[i][lane], s, c);
        sine[i][lane] = s;
        cosine[i][lane] = c;
      }
  }

  template <symbolic::operation op>
  [[gnu::always_inline]] static Vector by_name(const Vector& x) {
    using symbolic::operation;
    if constexpr (has_own_sines<element> && (op == operation::sin || op == operation::cos)) {
      Vector sine, cosine;
      sincos(x, sine, cosine);
      return op == operation::sin ? sine : cosine;
    } else if constexpr (op == operation::sqrt) {
      return numeric::square_roots(x);
    } else if constexpr (op == operation::abs && are_known) {
      return __builtin_bit_cast(Vector, __builtin_bit_cast(bits, x) << 1 >> 1);
    } else {
      return each([&](int i) { return of_element::template by_name<op>(x[i]); });
    }
  }
  [[gnu::always_inline]] static void exchange_if_positive(const Vector& d, Vector& a, Vector& b) {
    const auto exchanged = d > 0;
    const Vector upper = exchanged ? b : a, lower = exchanged ? a : b;
    a = upper;
    b = lower;
  }
  template <symbolic::operation op>
  [[gnu::always_inline]] static Vector selected(const Vector& condition, const Vector& x) {
    const auto is_positive = condition > 0;
    if constexpr (op == symbolic::operation::if_positive) {
      const Vector rest = condition < 0 ? Vector{} : condition;
      return is_positive ? x : rest;
    } else {
      const Vector rest = condition <= 0 ? x : condition;
      return is_positive ? Vector{} : rest;
    }
  }
  template <class Function>
  static constexpr bool calls = of_element::template calls<Function>;
  template <class Function>
  [[gnu::always_inline]] static Vector called(const std::same_as<Vector> auto&... x) {
    return each([&](int i) { return of_element::template called<Function>(element(x[i])...); });
  }
  [[gnu::always_inline]] static Vector power(const Vector& x, const Vector& y) {
    return each([&](int i) { return of_element::power(x[i], y[i]); });
  }
  template <symbolic::operation op>
  [[gnu::always_inline]] static Vector by_name(const Vector& a, const Vector& b) {
    return each([&](int i) { return of_element::template by_name<op>(a[i], b[i]); });
  }

  /// Returns true only if x exceeds the bound in all lanes.
  [[gnu::always_inline]] static bool exceeds(const Vector& x, const Vector& bound) {
    return is_in_no_lane(~(x > bound));
  }
  [[gnu::always_inline]] static bool is_in_no_lane(const decltype(Vector{} <= Vector{})& comparison) {
    return !numeric::detail::is_set_in_a_lane(comparison);
  }

  [[gnu::always_inline]] static bool is_finite(const Vector& x) {
#if !defined(__FINITE_MATH_ONLY__) || !__FINITE_MATH_ONLY__
    if constexpr (are_known) {
      constexpr auto infinity =
          __builtin_bit_cast(numeric::detail::number_bits<Vector>, std::numeric_limits<element>::infinity());
      return is_in_no_lane((__builtin_bit_cast(bits, x) & infinity) == infinity);
    }
#endif
    bool all = true;
    for (int i = 0; i < lanes; ++i) all = all && of_element::is_finite(x[i]);
    return all;
  }

private:
  static constexpr bool are_known = std::is_same_v<element, double> || std::is_same_v<element, float>;
  using bits = numeric::detail::bits_of<Vector>;

  template <class Lane>
  [[gnu::always_inline]] static Vector each(const Lane& lane) {
    Vector all{};
    for (int i = 0; i < lanes; ++i) all[i] = lane(i);
    return all;
  }
};

} // namespace kanexpr::lower

namespace Eigen {

/// The minimum that Eigen requires to store and return packs.
template <kanexpr::lower::vector_extension Vector>
struct NumTraits<Vector> : GenericNumTraits<Vector> {
  enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};

/// A pack requires its own alignment, which may exceed Eigen's.
template <kanexpr::lower::vector_extension Vector, int size>
struct internal::compute_default_alignment<Vector, size> {
  enum { value = 0 };
};

} // namespace Eigen
