#pragma once

#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/symbolic/elementary.hpp>

#include <bit>
#include <complex>

namespace kanexpr::compiled {

/// Why an entry of a vector of values is no finite number. What was never set or wrongly named is a
/// not-a-number with the reason in its highest bits, which conversions to float keep.
enum class gap : unsigned char { none, not_a_number, infinite, never_set, set_twice, beside_unknown };

constexpr double number_for(gap why) {
  constexpr std::uint64_t quiet = std::uint64_t{0xfff} << 51;
  return std::bit_cast<double>(quiet | static_cast<std::uint64_t>(why) << 48);
}

constexpr gap gap_in(double value) {
  namespace of = symbolic::elementary::detail;
  if (of::is_finite(value)) return gap::none;
  if (!of::is_nan(value)) return gap::infinite;
  const std::uint64_t reason = of::bits(value) >> 48 & 7;
  if (reason < static_cast<unsigned>(gap::never_set) || reason > static_cast<unsigned>(gap::beside_unknown))
    return gap::not_a_number;
  return static_cast<gap>(reason);
}
/// Of scalars that are no plain numbers, as those that carry derivatives, nothing is known.
template <class Scalar>
constexpr gap gap_in(const Scalar& value) {
  if constexpr (std::is_floating_point_v<Scalar>)
    return gap_in(static_cast<double>(value));
  else
    return gap::none;
}
template <class Real>
constexpr gap gap_in(const std::complex<Real>& value) {
  const gap real = gap_in(value.real());
  return real != gap::none ? real : gap_in(value.imag());
}

/// What is wrong with the value of a symbol, as a sentence; empty: nothing.
constexpr mechanics::problem told_of(gap found, const derivation::survey& known, int place,
                                     std::string_view system) {
  const auto symbol = [&] { return symbol_called(known, place); };
  switch (found) {
  case gap::none: break;
  case gap::never_set: return mechanics::sentence({symbol().view(), " has no value"});
  case gap::set_twice: return mechanics::sentence({symbol().view(), " has two values"});
  case gap::beside_unknown:
    return mechanics::sentence(
        {symbol().view(), " stands in a list of values with a name that ", system, " does not have there"});
  case gap::infinite: return mechanics::sentence({"the value of ", symbol().view(), " is infinite"});
  case gap::not_a_number: return mechanics::sentence({"the value of ", symbol().view(), " is not a number"});
  }
  return {};
}

/// The first entry of a vector of values that is no finite number, as a sentence; empty: there is none.
template <class Vector>
mechanics::problem first_gap(const Vector& values, const derivation::survey& known, const symbol_range& range,
                             std::string_view system) {
  for (int i = 0; i < range.size && i < static_cast<int>(values.size()); ++i)
    if (const gap found = gap_in(values[i]); found != gap::none)
      return told_of(found, known, range.first + i, system);
  return {};
}

} // namespace kanexpr::compiled
