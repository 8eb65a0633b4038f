#pragma once

#include <kanexpr/robots/identifiers.hpp>
#include <kanexpr/robots/pose.hpp>

#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// Formats the C++ text of a header.
namespace kanexpr::robots::cpp {

/// The shortest text that reads back as the same number.
inline std::string number(double x) {
  char letters[32];
  const auto end = std::to_chars(letters, letters + sizeof letters, x + 0.0, std::chars_format::general).ptr;
  std::string shortest(letters, end);
  if (shortest.find_first_of(".e") == shortest.npos && shortest.size() > 9) shortest += ".0"; // not an int
  return shortest;
}

/// Formats a limit, which may be infinite.
inline std::string limit(double x) {
  if (std::abs(x) <= (std::numeric_limits<double>::max)()) return number(x);
  return x < 0 ? "-no_limit" : "no_limit";
}

/// Writes c0 A::x + c1 A::y + c2 A::z.
inline std::string along(const std::string& axes, const vector3& v) {
  std::string sum;
  for (std::size_t i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    const double size = std::abs(v[i]);
    sum += v[i] < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
    sum += (size == 1 ? "" : number(size) + " * ") + axes + "::" + "xyz"[i];
  }
  return sum.empty() ? "0.0 * " + axes + "::x" : sum;
}

/// Returns an expression, in parentheses if it is a sum.
inline std::string factor(const std::string& e) {
  return e.find(' ') == e.npos && !e.starts_with('-') ? e : "(" + e + ")";
}

inline std::string list(const std::vector<std::string>& all, const char* separator = ", ") {
  std::string joined;
  for (const std::string& each : all) joined += (joined.empty() ? "" : separator) + each;
  return joined;
}

/// The entries of a rotation matrix, row by row.
inline std::string list(const rotation& r) {
  std::vector<std::string> entries;
  for (const vector3& row : r)
    for (double e : row) entries.push_back(number(e));
  return list(entries);
}

inline constexpr std::size_t columns = 110;

/// Breaks a line that starts at `column` after commas and signs if it is too long; continuation lines are
/// indented by `indent`.
inline std::string break_line(const std::string& line, std::size_t column, std::size_t indent) {
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

/// Writes a list after `before`, on as many lines as it needs; further lines are indented by the length of
/// `before`.
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
    text += break_line(each, used, indent + 4);
    used += each.size();
  }
  return text;
}

/// Writes an #include of the header, not of this file.
inline std::string include(const std::string& header) {
  return std::string("#") + "include <" + header + ">\n";
}

/// Opens a namespace that uses the names of the library, listed in `words`; a name that the namespace would
/// hide is declared separately.
inline std::string namespace_opening(const std::string& called, std::string_view words) {
  return "namespace " + called + " {\n\nusing namespace kanexpr;\n" +
         (is_in(words, called) ? "using kanexpr::" + called + ";\n" : "") + "\n";
}

/// Returns text from a file in a form that is safe in a comment: it can neither end the line nor continue it.
inline std::string comment(std::string_view in_file) {
  std::string plain;
  for (char c : in_file.substr(0, 80)) plain += c >= ' ' && c < 0x7f && c != '\\' && c != '?' ? c : '_';
  return plain;
}

} // namespace kanexpr::robots::cpp
