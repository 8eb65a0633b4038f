#pragma once

#include "playground/model/functions.hpp"
#include "playground/text/tree.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace playground {

/// A number in C++; zero is written as 0.0, because the integer 0 is rejected in models.
inline std::string number_in_cpp(double value, bool is_decimal = false) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  std::string digits(text.data(), written.ptr);
  const bool is_integer = digits.find_first_of(".e") == digits.npos;
  if (is_integer && (is_decimal || value == 0 || digits.size() > 9)) digits += ".0";
  return digits;
}

/// Writes expressions of lines in the words of C++.
class cpp_expression {
public:
  /// `own` is the frame that is being declared, whose axes are own::x, own::y and own::z.
  explicit cpp_expression(std::string own = "") : own_(std::move(own)) {}

  std::string operator()(const tree& e) const { return text(e); }

private:
  static int strength(const tree& e) {
    switch (e.is) {
    case tree::kind::sum:
    case tree::kind::difference: return 1;
    case tree::kind::product:
    case tree::kind::quotient: return 2;
    case tree::kind::negative: return 3;
    case tree::kind::number:
    case tree::kind::name:
    case tree::kind::axis:
    case tree::kind::call:
    case tree::kind::power: break;
    }
    return 4;
  }
  std::string in_parentheses_below(int least, const tree& e) const {
    return strength(e) < least ? '(' + text(e) + ')' : text(e);
  }

  /// Whether an expression contains only numbers. C++ would compute it with integers, or not at compile time.
  static bool is_numerical(const tree& e) {
    if (e.is == tree::kind::name) return e.text == "pi";
    if (e.is == tree::kind::axis || (e.is == tree::kind::call && !value_of_call(e))) return false;
    return std::ranges::all_of(e.parts, is_numerical);
  }
  static std::optional<double> value_of_call(const tree& e) {
    if (!std::ranges::all_of(e.parts, is_numerical)) return std::nullopt;
    for (const function_of_one& f : functions_of_one)
      if (f.called == e.text) return f.of_number(value_of(e.parts[0]));
    for (const function_of_two& f : functions_of_two)
      if (f.called == e.text) return f.of_numbers(value_of(e.parts[0]), value_of(e.parts[1]));
    return std::nullopt;
  }
  static double value_of(const tree& e) {
    const auto part = [&](std::size_t i) { return value_of(e.parts[i]); };
    switch (e.is) {
    case tree::kind::name: return std::numbers::pi;
    case tree::kind::call: return value_of_call(e).value_or(0);
    case tree::kind::negative: return -part(0);
    case tree::kind::sum: return part(0) + part(1);
    case tree::kind::difference: return part(0) - part(1);
    case tree::kind::product: return part(0) * part(1);
    case tree::kind::quotient: return part(0) / part(1);
    case tree::kind::power: return std::pow(part(0), part(1));
    case tree::kind::number:
    case tree::kind::axis: break;
    }
    return e.value;
  }

  std::string text(const tree& e) const {
    const bool is_literal =
        e.parts.empty() || (e.is == tree::kind::negative && e.parts[0].is == tree::kind::number);
    if (!is_literal && is_numerical(e)) {
      const double value = value_of(e);
      return value < 0 ? '(' + number_in_cpp(value, true) + ')' : number_in_cpp(value, true);
    }
    const auto part = [&](std::size_t i, int least) { return in_parentheses_below(least, e.parts[i]); };
    switch (e.is) {
    case tree::kind::number: return number_in_cpp(e.value);
    case tree::kind::name: return e.text == "pi" ? number_in_cpp(std::numbers::pi) : e.text;
    case tree::kind::axis: return (e.text == own_ ? "own" : e.text) + "::" + e.axis;
    case tree::kind::call: return call(e);
    case tree::kind::negative: return "-" + part(0, 4); // -(-q), since --q decrements
    case tree::kind::sum: return part(0, 1) + " + " + part(1, 2);
    case tree::kind::difference: return part(0, 1) + " - " + part(1, 2);
    case tree::kind::product: return part(0, 2) + '*' + part(1, 3);
    case tree::kind::quotient: return part(0, 2) + '/' + part(1, 3);
    case tree::kind::power: return "pow(" + text(e.parts[0]) + ", " + text(e.parts[1]) + ')';
    }
    return {};
  }

  std::string call(const tree& e) const {
    const bool names_things = e.text.ends_with("_of");
    std::string all = e.text + (names_things ? '<' : '(');
    for (std::size_t i = 0; i < e.parts.size(); ++i) all += (i == 0 ? "" : ", ") + text(e.parts[i]);
    return all + (names_things ? '>' : ')');
  }

  std::string own_;
};

} // namespace playground
