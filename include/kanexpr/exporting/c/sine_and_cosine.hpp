#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/scalar.hpp>
#include <kanexpr/numeric/sine_and_cosine.hpp>

#include <string>
#include <string_view>
#include <utility>

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

inline constexpr std::string_view sine_and_cosine = template_text(
#include <kanexpr/exporting/c/sine_and_cosine.c.in>
);

} // namespace detail

/// Returns the routine of numeric/sine_and_cosine.hpp in C, for one angle, with the same operations in the
/// same order. Beyond its range it returns NaN, without a branch.
inline std::string sine_and_cosine_in_c(const std::string& name, const scalar& of) {
  using numeric::detail::circular;
  const scalar wide(precision::double_precision);
  const auto single = [&](float x) { return of.number(static_cast<double>(x)); };
  const auto in_both = [&](auto known) {
    return std::pair(detail::polynomial(known.of_sine, of), detail::polynomial(known.of_cosine, of));
  };
  const auto part = [](const char* called) { return template_part(detail::sine_and_cosine, called); };
  const auto [of_sine, of_cosine] = of.is_single ? in_both(circular<float>()) : in_both(circular<double>());
  const std::string with_rest = fill_template(part("sum_with_rest"), {{"S", of_sine}, {"one", of.number(1)}});
  const std::string reduction =
      of.is_single ? fill_template(part("reduction_of_float"),
                                   {{"quadrants", single(circular<float>::quadrants)},
                                    {"integers", single(circular<float>::integers)},
                                    {"wide_quadrants", wide.number(circular<double>::quadrants)},
                                    {"wide_integers", wide.number(circular<double>::integers)}})
                   : fill_template(part("reduction_of_double"),
                                   {{"quadrants", wide.number(circular<double>::quadrants)},
                                    {"integers", wide.number(circular<double>::integers)}});
  const std::string in_thumb =
      of.is_single ? fill_template(part("in_thumb"), {{"name", name},
                                                      {"quadrants", single(circular<float>::quadrants)},
                                                      {"integers", single(circular<float>::integers)},
                                                      {"half", of.number(0.5)},
                                                      {"one", of.number(1)},
                                                      {"C", of_cosine},
                                                      {"S", of_sine}})
                   : "";
  const std::string sum =
      of.is_single ? fill_template(part("sum_of_float"),
                                   {{"S", of_sine}, {"one", of.number(1)}, {"sum_with_rest", with_rest}})
                   : with_rest;
  return fill_template(part("function"),
                       {{"name", name},
                        {"number", of.type()},
                        {"bits", of.bits()},
                        {"last", of.last_bit()},
                        {"sin", of.function("sin")},
                        {"cos", of.function("cos")},
                        {"farthest", of.number(numeric::farthest_angle)},
                        {"half", of.number(0.5)},
                        {"C", of_cosine},
                        {"in_thumb", in_thumb},
                        {"end_in_thumb", std::string(of.is_single ? part("end_in_thumb") : "")},
                        {"reduction", reduction},
                        {"sum", sum}});
}

} // namespace kanexpr::exporting
