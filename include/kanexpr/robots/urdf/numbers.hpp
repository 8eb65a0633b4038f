#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

/// Reads numbers in the text of a file, independently of the locale.
namespace kanexpr::robots::urdf {

inline constexpr std::string_view spaces = " \t\r\n\f\v";

/// Removes the next word from a text and returns it; empty at the end of the text.
inline std::string_view next_word(std::string_view& text) {
  const std::size_t from = text.find_first_not_of(spaces);
  if (from == std::string_view::npos) return text = {};
  text.remove_prefix(from);
  const std::string_view word = text.substr(0, text.find_first_of(spaces));
  text.remove_prefix(word.size());
  return word;
}

/// The value of a word if the whole word is a finite number. Numbers that underflow are 0.
inline std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  if (word.empty() || word.starts_with('+')) return {};
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return {};
  if (error == std::errc::result_out_of_range)
    return word.find("e-") == word.npos && word.find("E-") == word.npos ? std::nullopt : std::optional(0.0);
  if (error != std::errc() || !numeric::is_finite(value)) return {};
  return value;
}

} // namespace kanexpr::robots::urdf
