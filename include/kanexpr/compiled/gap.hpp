#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/numeric/elementary.hpp>

#include <bit>
#include <complex>
#include <string_view>
#include <type_traits>

namespace kanexpr::compiled {

/// The reason why an entry of a vector of values is not finite. An entry that was never set, or was set by a
/// name that does not exist, is a NaN that stores the reason in its highest bits; conversions to float
/// preserve them.
enum class gap : unsigned char { none, not_a_number, infinite, never_set, set_twice, unknown_name_in_list };

constexpr double number_for(gap why) {
  constexpr std::uint64_t quiet = std::uint64_t{0xfff} << 51;
  return std::bit_cast<double>(quiet | static_cast<std::uint64_t>(why) << 48);
}

/// A vector holds only numbers, so if a list contains a name that the system does not define, the name is
/// stored in the lower bits of a NaN: six letters, or the first five and a mark that indicates further
/// letters.
inline constexpr std::size_t stored_letters = 6;
inline constexpr char truncation_mark = 1;

constexpr double number_for_unknown(std::string_view name) {
  std::uint64_t letters = 0;
  for (std::size_t i = 0; i < stored_letters; ++i) {
    const bool is_mark = i + 1 == stored_letters && name.size() > stored_letters;
    const char letter = is_mark ? truncation_mark : i < name.size() ? name[i] : '\0';
    letters = letters << 8 | static_cast<unsigned char>(letter);
  }
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number_for(gap::unknown_name_in_list)) | letters);
}

constexpr gap gap_in(double value) {
  namespace of = numeric::elementary::detail;
  if (of::is_finite(value)) return gap::none;
  if (!of::is_nan(value)) return gap::infinite;
  const std::uint64_t reason = of::bits(value) >> 48 & 7;
  if (reason < static_cast<unsigned>(gap::never_set) ||
      reason > static_cast<unsigned>(gap::unknown_name_in_list))
    return gap::not_a_number;
  return static_cast<gap>(reason);
}
/// Returns no gap for scalars that are not plain numbers, such as those that carry derivatives.
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

/// Returns, for example, "System has no parameter ll", from the stored part of the name.
constexpr base::sentence describe_unknown(double value, const symbol_range& range, std::string_view system) {
  std::uint64_t letters = std::bit_cast<std::uint64_t>(value) << 16;
  base::name kept;
  for (; letters >> 56 > static_cast<unsigned char>(truncation_mark); letters <<= 8) {
    const char letter = static_cast<char>(letters >> 56);
    kept.append(std::string_view(&letter, 1));
  }
  return base::sentence({system, " has no ", range.symbol, " ", kept.view(), letters == 0 ? "" : "..."});
}

/// Describes the gap in the value of a symbol as a sentence; empty if there is none.
constexpr base::sentence describe_gap(gap found, const derivation::survey& known, int place,
                                      std::string_view system) {
  const auto symbol = [&] { return symbol_called(known, place); };
  switch (found) {
  case gap::none: break;
  case gap::never_set: return base::sentence({symbol().view(), " has no value"});
  case gap::set_twice: return base::sentence({symbol().view(), " has two values"});
  case gap::unknown_name_in_list:
    return base::sentence(
        {"a name in the list that set the value of ", symbol().view(), " does not belong to ", system});
  case gap::infinite: return base::sentence({"the value of ", symbol().view(), " is infinite"});
  case gap::not_a_number: return base::sentence({"the value of ", symbol().view(), " is not a number"});
  }
  return {};
}

/// Returns a message that names the first entry of a vector of values that is not finite; empty if all are
/// finite.
template <class Vector>
base::sentence first_gap(const Vector& values, const derivation::survey& known, const symbol_range& range,
                         std::string_view system) {
  for (int i = 0; i < range.size && i < static_cast<int>(values.size()); ++i)
    if (const gap found = gap_in(values[i]); found != gap::none) {
      if constexpr (std::is_same_v<typename Vector::Scalar, double>)
        if (found == gap::unknown_name_in_list) return describe_unknown(values[i], range, system);
      return describe_gap(found, known, range.first + i, system);
    }
  return {};
}

} // namespace kanexpr::compiled
