#pragma once

#include <array>
#include <cctype>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace kanexpr::figures {

/// A name or an expression as the contents of an SVG text element, and its approximate width.
struct text {
  std::string svg{};
  double width = 0; ///< in pixels
};

namespace detail {

inline std::string_view greek(std::string_view word) {
  constexpr auto letters = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"zeta", "ζ"},
       {"eta", "η"},   {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},      {"nu", "ν"},
       {"xi", "ξ"},    {"rho", "ρ"},   {"sigma", "σ"}, {"tau", "τ"},    {"phi", "φ"},     {"chi", "χ"},
       {"psi", "ψ"},   {"omega", "ω"}, {"Omega", "Ω"}, {"Delta", "Δ"},  {"Phi", "Φ"},     {"pi", "π"}});
  for (const auto& [name, letter] : letters)
    if (name == word) return letter;
  return word;
}

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

/// Writes digits after a letter as a subscript, names of Greek letters as the letters, and products without a
/// multiplication sign.
inline text typeset(std::string_view plain) {
  constexpr double letter = 7.4, subscript = 5.2;
  text out;
  const auto is = [](char c, int (*kind)(int)) { return kind(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = 0; at < plain.size();) {
    std::size_t end = at;
    if (is(plain[at], std::isalpha)) {
      while (end < plain.size() && is(plain[end], std::isalpha)) ++end;
      const std::string_view word = plain.substr(at, end - at), sign = detail::greek(word);
      out.svg += sign;
      out.width += letter * (sign == word ? static_cast<double>(word.size()) : 1.0);
      at = end + (end < plain.size() && plain[end] == '_' ? 1 : 0);
      for (end = at; end < plain.size() && is(plain[end], std::isalnum);) ++end;
      if (end == at) continue;
      out.svg += "<tspan class=\"sub\" dy=\"3\">" + std::string(plain.substr(at, end - at)) +
                 "</tspan><tspan dy=\"-3\">\u200b</tspan>";
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
