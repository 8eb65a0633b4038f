#pragma once

#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/numeric/vectors.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

/// Sine and cosine of one or several angles in straight-line code, for `double`, `float` and the compiler's
/// vectors of these, also in constant expressions.
///
/// |x| is reduced to an offset of at most π/4 from a multiple of π/2 by Cody and Waite's method (Software
/// Manual for the Elementary Functions, 1980, chapter 8): π/2 is split into parts so short that their
/// products with the number of quadrants are exact. Minimax polynomials follow. Up to `farthest_angle` the
/// error is less than 1 ulp. Zeros keep their sign, and infinity gives NaN.
///
/// A single branch passes larger angles to the C library, which reduces them exactly. With the macro
/// KANEXPR_ANGLES_WITHIN_REACH there is no branch, and such angles give NaN.

// Callers may be compiled with -ffast-math; the terms that cancel here must not be reassociated. Fused
// operations are permitted.
#if defined(__clang__)
#pragma float_control(push)
#pragma float_control(precise, on)
#if !defined(KANEXPR_NO_FUSING)
#pragma clang fp contract(fast)
#endif
#endif

namespace kanexpr::numeric {

/// The largest angle, in radians (20 860 turns), whose sine and cosine are computed without the C library.
inline constexpr double farthest_angle = 131072;

namespace detail {

/// sin r = r + r³ S(r²) and cos r = 1 − r²/2 + r⁴ C(r²) for |r| ≤ π/4, with minimal maximum relative error.
template <class Number>
struct circular;
template <>
struct circular<double> { // errors 2^-57.9 and 2^-63.9
  static constexpr double of_sine[]{-0x1.5555555555548p-3, 0x1.111111110f7d0p-7,   -0x1.a01a019bfdee3p-13,
                                    0x1.71de3567d2be4p-19, -0x1.ae5e5a911c1a5p-26, 0x1.5d8fd18cf9527p-33};
  static constexpr double of_cosine[]{0x1.555555555554bp-5,   -0x1.6c16c16c14f91p-10, 0x1.a01a019c844d5p-16,
                                      -0x1.27e4f7eac3446p-22, 0x1.1ee9d7b3dfb8dp-29,  -0x1.8fa4997f3dab6p-37};
  static constexpr double quadrants = 0x1.45f306dc9c883p-1; // quadrants per radian
  static constexpr double integers = 0x1.8p52;              // all numbers of this magnitude are integers
};
template <>
struct circular<float> { // errors 2^-37.4 and 2^-33
  static constexpr float of_sine[]{-0x1.555556p-3F, 0x1.111108p-7F, -0x1.a00f80p-13F, 0x1.6cd1f2p-19F};
  static constexpr float of_cosine[]{0x1.55554ap-5F, -0x1.6c0c34p-10F, 0x1.99eb9cp-16F};
  static constexpr float quadrants = 0x1.45f306p-1F;
  static constexpr float integers = 0x1.8p23F;
};

/// Prevents g++ from fusing v with the operation that follows.
template <class Value>
[[gnu::always_inline]] constexpr Value rounded(const Value& v) {
#if defined(__clang__)
  return v;
#else
  return __builtin_assoc_barrier(v);
#endif
}

/// An angle of `quadrant` quarter turns (only the lowest two bits matter) plus `offset + rest`.
template <class Value>
struct reduced_angle {
  Value offset, rest;
  bits_of<Value> quadrant;
};

/// The products of q < 2^17 and the first two parts of π/2, which have 36 bits each, are exact, and so is the
/// first difference. No angle comes closer to a multiple of π/2 than 2^-60 (reached at 29 π/2).
template <class Value>
[[gnu::always_inline]] constexpr reduced_angle<Value> reduced(const Value& magnitude) {
  using known = circular<double>;
  const Value shifted = rounded<Value>(magnitude * known::quadrants + known::integers);
  const Value q = rounded<Value>(shifted - known::integers);
  const Value first = rounded<Value>(magnitude - q * 0x1.921fb54440000p+0);
  const Value subtracted = rounded<Value>(q * 0x1.68c234c4c0000p-39);
  const Value offset = rounded<Value>(first - subtracted);
  const Value rest = rounded<Value>(rounded<Value>(first - offset) - subtracted) - q * 0x1.98a2e03707344p-77;
  return {offset, rest, __builtin_bit_cast(bits_of<Value>, shifted)};
}

#if defined(__ARM_FEATURE_FMA) && !(__ARM_FP & 8)
template <class Value>
inline constexpr bool has_rest = !std::is_same_v<Value, float>;
#else
template <class Value>
inline constexpr bool has_rest = true;
#endif

template <class Value>
  requires std::is_same_v<number_of<Value>, float>
constexpr reduced_angle<Value> reduced(const Value& magnitude);

/// Reduces many lanes, half of them at a time.
template <class Value, std::size_t... index>
[[gnu::always_inline]] constexpr reduced_angle<Value> reduced_by_halves(const Value& magnitude,
                                                                        std::index_sequence<index...>) {
  constexpr std::size_t half = sizeof...(index);
  const auto first = reduced(__builtin_shufflevector(magnitude, magnitude, index...));
  const auto second = reduced(__builtin_shufflevector(magnitude, magnitude, (half + index)...));
  return {__builtin_shufflevector(first.offset, second.offset, index..., (half + index)...),
          __builtin_shufflevector(first.rest, second.rest, index..., (half + index)...),
          __builtin_shufflevector(first.quadrant, second.quadrant, index..., (half + index)...)};
}

/// Reduces the angle in `double`; on targets without double arithmetic, fused operations give exact
/// remainders.
template <class Value>
  requires std::is_same_v<number_of<Value>, float>
[[gnu::always_inline]] constexpr reduced_angle<Value> reduced(const Value& magnitude) {
#if defined(__ARM_FEATURE_FMA) && !(__ARM_FP & 8)
  if (!std::is_constant_evaluated()) {
    using known = circular<float>;
    const float shifted = rounded(__builtin_fmaf(magnitude, known::quadrants, known::integers));
    const float q = rounded(shifted - known::integers);
    const float first = __builtin_fmaf(q, -0x1.921fb4p+0F, magnitude);
    const float second = __builtin_fmaf(q, -0x1.4442d0p-24F, first);
    return {__builtin_fmaf(q, -0x1.846988p-48F, second), {}, __builtin_bit_cast(std::uint32_t, shifted)};
  }
#endif
  using wide = lanes_as<Value, double>;
  if constexpr (constexpr std::size_t count = lanes<Value>::count;
                sizeof(wide) > (std::max)(widest_vector, sizeof(double)) && widest_vector > 0) {
    return reduced_by_halves(magnitude, std::make_index_sequence<count / 2>{});
  } else if constexpr (count > 1 && widest_vector == 0) {
    reduced_angle<Value> all;
    for (std::size_t i = 0; i < count; ++i) {
      const reduced_angle<float> one = reduced<float>(magnitude[i]);
      all.offset[i] = one.offset, all.rest[i] = one.rest, all.quadrant[i] = one.quadrant;
    }
    return all;
  } else {
    using known = circular<double>;
    const wide all = converted<wide>(magnitude);
    const wide shifted = rounded<wide>(all * known::quadrants + known::integers);
    const wide q = rounded<wide>(shifted - known::integers);
    const wide exact = rounded<wide>(all - q * 0x1.921fb54400000p+0) - q * 0x1.0b4611a626331p-34;
    const Value offset = converted<Value>(exact);
    return {offset, converted<Value>(exact - converted<wide>(offset)),
            lower_halves(__builtin_bit_cast(bits_of<wide>, shifted))};
  }
}

/// Evaluates a polynomial by Horner's rule, from the coefficient `index` on.
template <std::size_t index, std::size_t count, class Number, class Value>
[[gnu::always_inline]] constexpr Value polynomial(const Number (&coefficients)[count], const Value& x) {
  if constexpr (index + 1 == count)
    return Value{} + coefficients[index];
  else
    return polynomial<index + 1>(coefficients, x) * x + coefficients[index];
}

/// The sine and the cosine of the offset from a multiple of π/2.
template <class Value>
[[gnu::always_inline]] constexpr void sum_series(const reduced_angle<Value>& r, Value& along, Value& across) {
  using number = number_of<Value>;
  using known = circular<number>;
  const Value square = r.offset * r.offset;
  const Value cube = r.offset * square;
  const Value falling = square * polynomial<0>(known::of_cosine, square) - number(0.5);
  if constexpr (has_rest<Value>) {
    along = r.offset + (r.rest + cube * polynomial<0>(known::of_sine, square));
    across = number(1) + (square * falling - r.offset * r.rest);
  } else {
    along = r.offset + cube * polynomial<0>(known::of_sine, square);
    across = number(1) + square * falling;
  }
}

#if defined(__ARM_FEATURE_FMA) && !(__ARM_FP & 8) && defined(__thumb2__)
/// The same bits for processors that can make any instruction depend on a condition, but select no numbers:
/// the numbers stay in floating-point registers. The sign of the angle needs no care, because every operation
/// is odd or even in it.
[[gnu::always_inline]] inline void sine_and_cosine_in_thumb(float angle, float& sine, float& cosine) {
#if defined(KANEXPR_ANGLES_WITHIN_REACH)
  float nothing = 0;
  asm("" : "+t"(nothing)); // hides it from -ffast-math
  angle =
      __builtin_fmaf(angle * 0x1.fffffep110F, nothing, angle); // beyond the farthest angle, infinity times 0
#endif
  const reduced_angle<float> r = reduced(angle);
  float along, across;
  sum_series(r, along, across);
  auto quadrant = r.quadrant;
  // The lowest two bits become the flags N and C.
  asm("lsls %[quadrant], %[quadrant], #31\n\t"
      "itt cs\n\t"
      "vnegcs.f32 %[along], %[along]\n\t"
      "vnegcs.f32 %[across], %[across]\n\t"
      "vmov.f32 %[sine], %[along]\n\t"
      "itt mi\n\t"
      "vmovmi.f32 %[sine], %[across]\n\t"
      "vnegmi.f32 %[across], %[along]"
      : [along] "+t"(along), [across] "+t"(across), [sine] "=&t"(sine), [quadrant] "+r"(quadrant)
      :
      : "cc");
  cosine = across;
}
#endif

template <class Value>
[[gnu::always_inline]] constexpr void sine_and_cosine_in_range(const Value& angle, Value& sine,
                                                               Value& cosine) {
#if defined(__ARM_FEATURE_FMA) && !(__ARM_FP & 8) && defined(__thumb2__)
  if constexpr (std::is_same_v<Value, float>)
    if (!std::is_constant_evaluated()) return sine_and_cosine_in_thumb(angle, sine, cosine);
#endif
  using number = number_of<Value>;
  using bits = bits_of<Value>;
  constexpr int last = 8 * sizeof(number) - 1;
  constexpr auto sign = number_bits<Value>{1} << last;
  const bits given = __builtin_bit_cast(bits, angle);
  bits magnitude = given & ~sign;
#if defined(KANEXPR_ANGLES_WITHIN_REACH)
  magnitude |=
      0 - ((__builtin_bit_cast(number_bits<Value>, number(farthest_angle)) - magnitude) >> last); // NaN
#endif
  const reduced_angle<Value> r = reduced(__builtin_bit_cast(Value, magnitude));
  Value along, across;
  sum_series(r, along, across);
  // Odd quadrants exchange sine and cosine.
  const bits s = __builtin_bit_cast(bits, along), c = __builtin_bit_cast(bits, across);
  const bits exchanged = (s ^ c) & (0 - (r.quadrant & 1));
  sine = __builtin_bit_cast(Value, s ^ exchanged ^ ((r.quadrant << (last - 1) ^ given) & sign));
  cosine = __builtin_bit_cast(Value, c ^ exchanged ^ ((r.quadrant + 1) << (last - 1) & sign));
}

/// Whether a lane is beyond the farthest angle, or NaN.
template <class Value>
[[gnu::always_inline]] constexpr bool is_out_of_range(const Value& angle) {
  using bits = number_bits<Value>;
  const bits_of<Value> given = __builtin_bit_cast(bits_of<Value>, angle);
  const bits_of<Value> left = __builtin_bit_cast(bits, number_of<Value>(farthest_angle)) - (given << 1 >> 1);
  return is_set_in_a_lane(left);
}

/// Replaces the results of the angles that are out of range.
template <class Number>
[[gnu::noinline, gnu::cold]] void by_c_library(std::size_t count, const Number* angle, Number* sine,
                                               Number* cosine) noexcept {
  for (std::size_t i = 0; i < count; ++i)
    if (is_out_of_range(angle[i])) {
      sine[i] = std::sin(angle[i]);
      cosine[i] = std::cos(angle[i]);
    }
}

} // namespace detail

/// Computes the sine and the cosine of an angle in radians, or of one angle per lane of T. Each lane holds
/// the same bits as a separate evaluation.
template <class Value>
[[gnu::always_inline]] constexpr void sine_and_cosine(const Value& angle, Value& sine,
                                                      Value& cosine) noexcept {
  detail::sine_and_cosine_in_range(angle, sine, cosine);
#if !defined(KANEXPR_ANGLES_WITHIN_REACH)
  if (detail::is_out_of_range(angle)) [[unlikely]] {
    if (std::is_constant_evaluated()) {
      if constexpr (detail::lanes<Value>::count == 1) {
        sine = static_cast<Value>(numeric::elementary::sin(static_cast<double>(angle)));
        cosine = static_cast<Value>(numeric::elementary::cos(static_cast<double>(angle)));
      }
    } else {
      // The arguments of the library function must be in memory; the values computed here should stay in
      // registers.
      detail::number_of<Value> angles[detail::lanes<Value>::count], sines[detail::lanes<Value>::count],
          cosines[detail::lanes<Value>::count];
      std::memcpy(angles, &angle, sizeof angle);
      std::memcpy(sines, &sine, sizeof angle);
      std::memcpy(cosines, &cosine, sizeof angle);
      detail::by_c_library(detail::lanes<Value>::count, angles, sines, cosines);
      std::memcpy(&sine, sines, sizeof angle);
      std::memcpy(&cosine, cosines, sizeof angle);
    }
  }
#endif
}

} // namespace kanexpr::numeric

#if defined(__clang__)
#pragma float_control(pop)
#endif
