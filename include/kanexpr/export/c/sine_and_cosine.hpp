#pragma once

#include <kanexpr/export/text/fill_template.hpp>
#include <kanexpr/export/text/scalar.hpp>
#include <kanexpr/numeric/sine_and_cosine.hpp>

#include <string>

namespace kanexpr::exporting {

namespace detail {

/// A polynomial in `square` by Horner's rule, as in numeric/sine_and_cosine.hpp.
template <class Number, std::size_t count>
std::string polynomial(const Number (&coefficients)[count], const scalar& of) {
  std::string sum(count - 1, '(');
  sum += of.number(static_cast<double>(coefficients[count - 1]));
  for (std::size_t i = count - 1; i-- > 0;)
    sum.append(" * square + ").append(of.number(static_cast<double>(coefficients[i]))).append(")");
  return sum;
}

inline constexpr std::string_view reduction_of_double = R"(  {
    double q, first, subtracted;
    along.number = magnitude.number * @quadrants@ + @integers@;
    quadrant = along.bits;
    q = along.number - @integers@;
    first = magnitude.number - q * 0x1.921fb54440000p+0;
    subtracted = q * 0x1.68c234c4c0000p-39;
    offset = first - subtracted;
    rest = ((first - offset) - subtracted) - q * 0x1.98a2e03707344p-77;
  }
)";

// Without hardware for `double`, fused operations give exact remainders.
inline constexpr std::string_view reduction_of_float = R"(  {
#if defined(__ARM_FEATURE_FMA) && !(__ARM_FP & 8)
    const float q = (along.number = fmaf(magnitude.number, @quadrants@, @integers@)) - @integers@;
    quadrant = along.bits;
    offset = fmaf(q, -0x1.846988p-48F, fmaf(q, -0x1.4442d0p-24F, fmaf(q, -0x1.921fb4p+0F, magnitude.number)));
#else
    union { double number; unsigned long long bits; } shifted;
    double q, exact;
    shifted.number = (double)magnitude.number * @wide_quadrants@ + @wide_integers@;
    quadrant = (unsigned int)shifted.bits;
    q = shifted.number - @wide_integers@;
    exact = ((double)magnitude.number - q * 0x1.921fb54400000p+0) - q * 0x1.0b4611a626331p-34;
    offset = (float)exact;
    rest = (float)(exact - (double)offset);
#endif
  }
)";

inline constexpr std::string_view sum_with_rest = R"(  along.number = offset + (rest + cube * @S@);
  across.number = @one@ + (square * falling - offset * rest);
)";

inline constexpr std::string_view sum_of_float = R"(#if defined(__ARM_FEATURE_FMA) && !(__ARM_FP & 8)
  along.number = offset + cube * @S@;
  across.number = @one@ + square * falling;
  rest = 0;
  (void)rest;
#else
@sum_with_rest@#endif
)";

inline constexpr std::string_view sine_and_cosine = R"(
/* Reduction to a quadrant by Cody and Waite's method, then minimax polynomials: the error is below 1.5 ulp up to
   131072 rad; the results are NaN beyond. With @name@_ANGLES_WITHOUT_END the functions of math.h are used beyond,
   with @name@_SINES_OF_THE_LIBRARY everywhere. */
@name@_INLINE void @name@_sine_and_cosine(@number@ angle, @number@ *sine, @number@ *cosine) {
#if defined(@name@_SINES_OF_THE_LIBRARY)
  *sine = @sin@(angle);
  *cosine = @cos@(angle);
#else
  const @bits@ sign = (@bits@)1 << @last@;
  @name@_bits given, magnitude, along, across;
  @bits@ quadrant, exchanged;
  @number@ offset, rest, square, cube, falling;
#if defined(@name@_ANGLES_WITHOUT_END)
  if (!(angle <= @farthest@ && angle >= -@farthest@)) {
    *sine = @sin@(angle);
    *cosine = @cos@(angle);
    return;
  }
#endif
  given.number = angle;
  magnitude.number = @farthest@;
  magnitude.bits = (given.bits & ~sign) | (0 - ((magnitude.bits - (given.bits & ~sign)) >> @last@));
@reduction@  square = offset * offset;
  cube = offset * square;
  falling = square * @C@ - @half@;
@sum@  exchanged = (along.bits ^ across.bits) & (0 - (quadrant & 1));
  along.bits ^= exchanged ^ (((quadrant << (@last@ - 1)) ^ given.bits) & sign);
  across.bits ^= exchanged ^ (((quadrant + 1) << (@last@ - 1)) & sign);
  *sine = along.number;
  *cosine = across.number;
#endif
}
)";

} // namespace detail

/// The routine of numeric/sine_and_cosine.hpp in C, for one angle: the same operations in the same order.
/// Beyond its range it returns NaN, without a branch.
inline std::string sine_and_cosine_in_c(const std::string& name, const scalar& of) {
  using numeric::detail::circular;
  const scalar wide(precision::double_precision);
  const auto single = [&](float x) { return of.number(static_cast<double>(x)); };
  const auto in_both = [&](auto known) {
    return std::pair(detail::polynomial(known.of_sine, of), detail::polynomial(known.of_cosine, of));
  };
  const auto [of_sine, of_cosine] = of.is_single ? in_both(circular<float>()) : in_both(circular<double>());
  const std::string with_rest = fill_template(detail::sum_with_rest, {{"S", of_sine}, {"one", of.number(1)}});
  const std::string reduction =
      of.is_single ? fill_template(detail::reduction_of_float,
                                   {{"quadrants", single(circular<float>::quadrants)},
                                    {"integers", single(circular<float>::integers)},
                                    {"wide_quadrants", wide.number(circular<double>::quadrants)},
                                    {"wide_integers", wide.number(circular<double>::integers)}})
                   : fill_template(detail::reduction_of_double,
                                   {{"quadrants", wide.number(circular<double>::quadrants)},
                                    {"integers", wide.number(circular<double>::integers)}});
  const std::string sum =
      of.is_single ? fill_template(detail::sum_of_float,
                                   {{"S", of_sine}, {"one", of.number(1)}, {"sum_with_rest", with_rest}})
                   : with_rest;
  return fill_template(detail::sine_and_cosine, {{"name", name},
                                                 {"number", of.type()},
                                                 {"bits", of.bits()},
                                                 {"last", of.last_bit()},
                                                 {"sin", of.function("sin")},
                                                 {"cos", of.function("cos")},
                                                 {"farthest", of.number(numeric::farthest_angle)},
                                                 {"half", of.number(0.5)},
                                                 {"C", of_cosine},
                                                 {"reduction", reduction},
                                                 {"sum", sum}});
}

} // namespace kanexpr::exporting
