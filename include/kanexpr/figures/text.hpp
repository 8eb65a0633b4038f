#pragma once

#include <kanexpr/symbolic/printing/greek.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace kanexpr::figures {

/// A name or an expression as the contents of an SVG text element, and its approximate width.
struct text {
  std::string svg{};
  double width = 0; ///< in pixels
};

namespace detail {

/// A decimal number, rounded to five significant digits if it is long.
inline std::string shortened(std::string_view number) {
  constexpr std::size_t longest = 6;
  double value = 0;
  if (number.size() <= longest ||
      std::from_chars(number.data(), number.data() + number.size(), value).ec != std::errc())
    return std::string(number);
  std::array<char, 32> text{};
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, longest - 1);
  return {text.data(), written.ptr};
}

} // namespace detail

/// Writes digits after a letter, and words after an underscore, as a subscript, names of Greek letters as the
/// letters, and products without a multiplication sign.
inline text typeset(std::string_view plain) {
  constexpr double letter = 7.4, subscript = 5.2;
  text out;
  const auto is = [](char c, int (*kind)(int)) { return kind(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = 0; at < plain.size();) {
    std::size_t end = at;
    if (is(plain[at], std::isalpha)) {
      while (end < plain.size() && is(plain[end], std::isalpha)) ++end;
      const std::string_view word = plain.substr(at, end - at),
                             letter_called = symbolic::printing::greek_letter_called(word),
                             sign = letter_called.empty() ? word : letter_called;
      out.svg += sign;
      out.width += letter * (sign == word ? static_cast<double>(word.size()) : 1.0);
      at = end + (end < plain.size() && plain[end] == '_' ? 1 : 0);
      for (end = at; end < plain.size() && (is(plain[end], std::isalnum) || plain[end] == '_');) ++end;
      if (end == at) continue;
      std::string below(plain.substr(at, end - at)); // q_joint_1 has the subscript joint,1
      std::ranges::replace(below, '_', ',');
      out.svg += "<tspan class=\"sub\" dy=\"3\">" + below + "</tspan><tspan dy=\"-3\">\u200b</tspan>";
      out.width += subscript * static_cast<double>(end - at);
    } else if (is(plain[at], std::isdigit)) {
      const auto continues = [&] { // an exponent may have a sign
        return is(plain[end], std::isdigit) || plain[end] == '.' || plain[end] == 'e' ||
               (end > at && plain[end - 1] == 'e' && (plain[end] == '-' || plain[end] == '+'));
      };
      while (end < plain.size() && continues()) ++end;
      const std::string number = detail::shortened(plain.substr(at, end - at));
      out.svg += number;
      out.width += letter * static_cast<double>(number.size());
    } else {
      const char c = plain[at];
      end = at + 1;
      out.svg += c == '*'   ? "\u2009"
                 : c == '<' ? "&lt;"
                 : c == '>' ? "&gt;"
                 : c == '&' ? "&amp;"
                 : c == '-' ? "−"
                            : std::string(1, c);
      out.width += c == '*' || c == '.' ? letter / 2 : letter;
    }
    at = end;
  }
  return out;
}

} // namespace kanexpr::figures
