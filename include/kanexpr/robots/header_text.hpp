#pragma once

#include <kanexpr/robots/pose.hpp>

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// Formats the text of a header.
namespace kanexpr::robots {

namespace header_text {

/// The shortest text that reads back as the same number.
inline std::string digits(double x) {
  char letters[32];
  const auto end = std::to_chars(letters, letters + sizeof letters, x + 0.0, std::chars_format::general).ptr;
  std::string shortest(letters, end);
  if (shortest.find_first_of(".e") == shortest.npos && shortest.size() > 9) shortest += ".0"; // not an int
  return shortest;
}

/// Formats a limit, which may be infinite.
inline std::string limit(double x) {
  if (std::abs(x) <= (std::numeric_limits<double>::max)()) return digits(x);
  return x < 0 ? "-no_limit" : "no_limit";
}

/// Writes c0 A::x + c1 A::y + c2 A::z.
inline std::string along(const std::string& axes, const vector3& v) {
  std::string sum;
  for (std::size_t i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    const double size = std::abs(v[i]);
    sum += v[i] < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
    sum += (size == 1 ? "" : digits(size) + " * ") + axes + "::" + "xyz"[i];
  }
  return sum.empty() ? "0.0 * " + axes + "::x" : sum;
}

/// Returns an expression, in parentheses if it is a sum.
inline std::string factor(const std::string& e) {
  return e.find(' ') == e.npos && !e.starts_with('-') ? e : "(" + e + ")";
}

inline std::string list(const std::vector<std::string>& all) {
  std::string joined;
  for (const std::string& each : all) joined += (joined.empty() ? "" : ", ") + each;
  return joined;
}

inline constexpr std::size_t columns = 110;

/// Breaks a line that starts at `column` after commas and signs if it is too long; continuation lines are
/// indented by `indent`.
inline std::string folded(const std::string& line, std::size_t column, std::size_t indent) {
  std::string text;
  std::size_t begun = 0, last = 0; // start of the unwritten text; last position where it may break
  for (std::size_t i = 1; i < line.size(); ++i) {
    const char before = line[i - 1];
    if (line[i] == ' ' && (before == ',' || before == '+' || before == '-')) last = i;
    if (i - begun + column < columns || last <= begun) continue;
    text += line.substr(begun, last - begun) + "\n" + std::string(indent, ' ');
    begun = last + 1;
    column = indent;
  }
  return text + line.substr(begun);
}

/// Writes a list that starts after `before` and continues on as many lines as it needs, indented by the
/// length of `before`.
inline std::string wrapped(const std::string& before, const std::vector<std::string>& all) {
  const std::size_t indent = before.size();
  std::string text = before;
  std::size_t used = indent;
  for (const std::string& each : all) {
    const bool is_first = &each == all.data();
    if (!is_first && used + each.size() + 3 > columns) {
      text += ",\n" + std::string(indent, ' ');
      used = indent;
    } else if (!is_first) {
      text += ", ";
      used += 2;
    }
    text += folded(each, used, indent + 4);
    used += each.size();
  }
  return text;
}

/// Opens a namespace that uses the names of the library; a library name that the namespace would hide is
/// declared separately.
inline std::string opened(const std::string& called, std::initializer_list<std::string_view> words) {
  const bool hides = std::ranges::find(words, called) != words.end();
  return "namespace " + called + " {\n\nusing namespace kanexpr;\n" +
         (hides ? "using kanexpr::" + called + ";\n" : "") + "\n";
}

/// Returns text from a file in a form that is safe in a comment: it can neither end the line nor continue it.
inline std::string comment(std::string_view said) {
  std::string plain;
  for (char c : said.substr(0, 80)) plain += c >= ' ' && c < 0x7f && c != '\\' && c != '?' ? c : '_';
  return plain;
}

} // namespace header_text

} // namespace kanexpr::robots
