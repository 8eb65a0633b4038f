#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace kanexpr::symbolic::printing {

/// Splits `theta12` into theta and 12, `I_xx` into I and xx, `Link<3>` into Link and 3.
struct split_name {
  std::string head{};
  std::string subscript{};

  explicit split_name(std::string_view name) {
    const auto begin = std::ranges::find_if_not(name, is_letter);
    head.assign(name.begin(), begin);
    bool is_apart = false;
    for (auto c = begin; c != name.end(); ++c) {
      const bool shows = is_letter(*c) || is_digit(*c);
      if (shows && is_apart && !subscript.empty()) subscript += ',';
      if (shows) subscript += *c;
      is_apart = !shows;
    }
    if (head.empty()) head.swap(subscript);
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  /// Bytes beyond ASCII belong to letters in UTF-8.
  static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  }
};

inline bool is_greek(std::string_view word) {
  constexpr std::array<std::string_view, 36> letters{
      "alpha",   "beta",   "gamma", "delta", "epsilon", "zeta",   "eta",   "theta", "iota",
      "kappa",   "lambda", "mu",    "nu",    "xi",      "pi",     "rho",   "sigma", "tau",
      "upsilon", "phi",    "chi",   "psi",   "omega",   "varphi", "Gamma", "Delta", "Theta",
      "Lambda",  "Xi",     "Pi",    "Sigma", "Upsilon", "Phi",    "Psi",   "Omega", "varepsilon"};
  return std::ranges::find(letters, word) != letters.end();
}

/// Writes a single letter, a Greek letter given by its name, or an upright word.
inline std::string latex_word(const std::string& word) {
  if (word.size() == 1) return word;
  return is_greek(word) ? "\\" + word : "\\mathrm{" + word + "}";
}

/// Trailing primes, as in `theta''`, denote time derivatives and become dots.
inline std::string latex_name(std::string_view name, bool dotted = false) {
  std::size_t dots = dotted ? 1 : 0;
  for (; name.ends_with('\''); name.remove_suffix(1)) ++dots;
  const split_name parts(name);
  std::string text = latex_word(parts.head);
  if (dots > 0) text = "\\" + std::string(dots, 'd') + "ot{" + text + "}";
  if (parts.subscript.empty()) return text;
  const bool is_number = std::ranges::all_of(parts.subscript, split_name::is_digit);
  const std::string below = is_number ? parts.subscript : latex_word(parts.subscript);
  return text + "_" + (below.size() == 1 ? below : "{" + below + "}");
}

} // namespace kanexpr::symbolic::printing
