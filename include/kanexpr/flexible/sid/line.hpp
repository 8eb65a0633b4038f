#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Splits a text into lines of the forms `word`, `end word` and `key = value`.
namespace kanexpr::flexible::sid {

inline constexpr std::string_view spaces = " \t\r\f\v";

inline std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(spaces);
  if (from == text.npos) return {};
  return text.substr(from, text.find_last_not_of(spaces) - from + 1);
}

/// Whether two words are equal except for the case of their letters.
inline bool is_same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (lower(a[i]) != lower(b[i])) return false;
  return true;
}

struct line {
  int number = 0;           ///< counted from 1; 0 at the end of the file
  std::string_view text{};  ///< without surrounding spaces
  std::string_view key{};   ///< the text before the equals sign, or all of it
  std::string_view value{}; ///< the text after the equals sign

  bool is(std::string_view word) const { return is_same_word(key, word); }
  /// The word that the line closes: "frame" for "end frame"; empty if the line does not close anything.
  std::string_view closed() const {
    return key.size() > 4 && is_same_word(key.substr(0, 4), "end ") ? trimmed(key.substr(4))
                                                                    : std::string_view{};
  }
};

/// Iterates over the lines of a text that are not empty.
class lines {
public:
  explicit lines(std::string_view text) : rest_(text) {}

  /// The next line; its number is 0 at the end of the text.
  line next() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      const std::string_view text = trimmed(rest_.substr(0, end));
      rest_ = end == rest_.npos ? std::string_view{} : rest_.substr(end + 1);
      ++number_;
      if (text.empty()) continue;
      const std::size_t equals = text.find('=');
      return {number_, text, trimmed(text.substr(0, equals)),
              equals == text.npos ? std::string_view{} : trimmed(text.substr(equals + 1))};
    }
    return {};
  }
  int last() const { return number_; }

private:
  std::string_view rest_;
  int number_ = 0;
};

} // namespace kanexpr::flexible::sid
