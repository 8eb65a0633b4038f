#pragma once

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace playground {

/// A name, a number or a sign of a line.
struct token {
  enum class kind : unsigned char { name, number, sign, end };
  kind is = kind::end;
  std::string text{};
};

/// The tokens of one line up to a comment, which begins with #, and the first mistake found in it.
class scanner {
public:
  explicit scanner(std::string_view line) {
    for (std::size_t at = 0; at < line.size() && line[at] != '#';) {
      if (std::isspace(static_cast<unsigned char>(line[at])) != 0) {
        ++at;
        continue;
      }
      const std::size_t end = end_of_token(line, at);
      tokens_.push_back({kind_of(line[at], end - at), std::string(line.substr(at, end - at))});
      at = end;
    }
    tokens_.push_back({});
  }

  const token& next() const { return tokens_[place_]; }
  bool is_at_end() const { return next().is == token::kind::end; }
  token take() { return is_at_end() ? next() : tokens_[place_++]; }
  bool take_if(std::string_view text) {
    const bool is_there = !is_at_end() && next().text == text;
    if (is_there) ++place_;
    return is_there;
  }

  void fail(std::string sentence) {
    if (mistake_.empty()) mistake_ = std::move(sentence);
  }
  /// Reports that the next token is not what the line needs there.
  void fail_expecting(const std::string& what, const std::string& remedy = "") {
    fail("expected " + what + (is_at_end() ? " at the end of the line" : ", got " + next().text) + remedy);
  }
  const std::string& mistake() const { return mistake_; }

private:
  static bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  static token::kind kind_of(char first, std::size_t length) {
    if (begins_name(first)) return token::kind::name;
    return is_digit(first) || (first == '.' && length > 1) ? token::kind::number : token::kind::sign;
  }

  static std::size_t end_of_token(std::string_view line, std::size_t at) {
    const auto letter = [&](std::size_t i) { return i < line.size() ? line[i] : '\0'; };
    std::size_t end = at + 1;
    if (begins_name(line[at])) {
      while (begins_name(letter(end)) || is_digit(letter(end))) ++end;
    } else if (is_digit(line[at]) || (line[at] == '.' && is_digit(letter(end)))) {
      while (is_digit(letter(end)) || letter(end) == '.') ++end;
      const std::size_t digits = letter(end + 1) == '-' || letter(end + 1) == '+' ? end + 2 : end + 1;
      if ((letter(end) == 'e' || letter(end) == 'E') && is_digit(letter(digits)))
        for (end = digits; is_digit(letter(end));) ++end;
    } else {
      while (is_continuation_of_utf8(letter(end))) ++end;
    }
    return end;
  }
  static bool is_continuation_of_utf8(char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; }

  std::vector<token> tokens_{};
  std::size_t place_ = 0;
  std::string mistake_{};
};

} // namespace playground
