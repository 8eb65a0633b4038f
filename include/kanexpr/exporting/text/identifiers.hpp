#pragma once

#include <kanexpr/base/library_words.hpp>
#include <kanexpr/base/utf8.hpp>

#include <set>
#include <string>
#include <string_view>

namespace kanexpr::exporting {

/// The keywords of C and C++, and predefined macros.
inline constexpr std::string_view words_of_cpp = R"(
alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl concept const
continue decltype default delete do double else enum explicit export extern false float for friend goto if
inline int long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public
register requires restrict return short signed sizeof static struct switch template this throw true try
typedef typeid typename typeof union unsigned using virtual void volatile while xor xor_eq linux unix char8_t
char16_t char32_t wchar_t consteval constexpr constinit const_cast dynamic_cast reinterpret_cast static_cast
static_assert thread_local co_await co_return co_yield typeof_unqual
)";

/// The keywords of Python, and the names that a generated module uses.
inline constexpr std::string_view words_of_python = R"(
False None True and as assert async await break class continue def del elif else except finally for from
global if import in is lambda nonlocal not or pass raise return try while with yield ctypes dict enumerate
isinstance len list pathlib range str zip ArithmeticError KeyError Singular ValueError
)";

/// Makes a text suitable for comments and XML: valid UTF-8 without control characters. Each invalid byte
/// becomes an underscore.
inline std::string printable(std::string_view text) {
  std::string fit;
  while (!text.empty()) {
    const std::size_t length = base::bytes_of_first_character(text);
    const bool is_control = length == 1 && (static_cast<unsigned char>(text[0]) < ' ' || text[0] == '\x7f');
    const bool is_fit = length > 0 && !is_control;
    fit += is_fit ? text.substr(0, length) : "_";
    text.remove_prefix(is_fit ? length : 1);
  }
  return fit;
}

/// Maps names to unique identifiers in C and C++.
class identifiers {
public:
  /// Returns the name, altered if necessary: characters that identifiers cannot contain become `u` followed
  /// by their code point, and an underscore is appended if the name is already taken.
  std::string unique(std::string_view name) {
    std::string plain = spelled(name);
    while (!used_.insert(plain).second) plain += '_';
    return plain;
  }

  /// Reserves words separated by spaces, each with the suffix `end`.
  void reserve(std::string_view words, std::string_view end = {}) {
    for (std::string_view word = base::library_words::next_of(words); !word.empty();
         word = base::library_words::next_of(words))
      used_.insert(std::string(word).append(end));
  }

  /// Reserves the words that must not be used as names of variables in a function.
  void reserve_words() {
    reserve(words_of_cpp);
    reserve(base::library_words::macros_of_the_library);
  }

  /// Reserves the names in math.h.
  void reserve_words_of_mathematics() {
    for (const std::string_view end : base::library_words::ends_of_functions)
      reserve(base::library_words::functions_of_mathematics, end);
    reserve(base::library_words::other_words_of_mathematics);
  }

private:
  static bool is_letter(unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  }
  static bool is_digit(unsigned char c) { return c >= '0' && c <= '9'; }

  static std::string spelled(std::string_view name) {
    std::string plain;
    for (std::size_t i = 0; i < name.size();) {
      const auto c = static_cast<unsigned char>(name[i]);
      if (c < 0x80) {
        plain += is_letter(c) || is_digit(c) ? static_cast<char>(c) : '_';
        ++i;
      } else {
        plain += code_point(name, i);
      }
    }
    if (plain.empty() || is_digit(static_cast<unsigned char>(plain[0]))) plain.insert(0, "n");
    return plain;
  }

  /// Returns `u03b1` for α and advances `i` past the character.
  static std::string code_point(std::string_view name, std::size_t& i) {
    const auto lead = static_cast<unsigned char>(name[i++]);
    unsigned point = lead >= 0xf0 ? lead & 0x07u : lead >= 0xe0 ? lead & 0x0fu : lead & 0x1fu;
    for (; i < name.size() && (static_cast<unsigned char>(name[i]) & 0xc0u) == 0x80; ++i)
      point = point << 6 | (static_cast<unsigned char>(name[i]) & 0x3fu);
    std::string hex;
    for (int k = 4; k-- > 0;) hex += "0123456789abcdef"[point >> 4 * k & 0xfu];
    return "u" + hex;
  }

  std::set<std::string> used_{};
};

} // namespace kanexpr::exporting
