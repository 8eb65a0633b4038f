#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

/// Reads numbers as Fortran and other languages write them, independently of the locale.
namespace kanexpr::flexible::sid {

/// Rewrites a number of Fortran, whose exponent has the letter D or, with three digits, no letter.
inline std::string with_common_exponent(std::string_view word) {
  std::string common;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = word[i];
    const bool is_sign = c == '+' || c == '-';
    if (is_sign && i > 0 && common.back() != 'e') common += 'e';
    common += c == 'd' || c == 'D' || c == 'E' ? 'e' : c;
    if (c == '+' && common.size() > 1) common.pop_back(); // from_chars accepts no plus sign
  }
  return common.starts_with('+') ? common.substr(1) : common;
}

/// The value of a word if the whole word is a finite number. Numbers that underflow are 0.
inline std::optional<double> number_in(std::string_view word) {
  if (word.empty() || word.size() > 200) return {};
  const std::string common = with_common_exponent(word);
  double value = 0;
  const char* const end = common.data() + common.size();
  const auto [rest, error] = std::from_chars(common.data(), end, value);
  if (rest != end) return {};
  if (error == std::errc::result_out_of_range)
    return common.find("e-") == common.npos ? std::nullopt : std::optional(0.0);
  if (error != std::errc() || !numeric::is_finite(value)) return {};
  return value;
}

/// The value of a word if the whole word is a count, that is, an integer from 0 to 10⁹.
inline std::optional<int> count_in(std::string_view word) {
  int value = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || rest != word.data() + word.size() || error != std::errc() || value < 0 ||
      value > 1'000'000'000)
    return {};
  return value;
}

} // namespace kanexpr::flexible::sid
