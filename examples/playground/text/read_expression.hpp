#pragma once

#include "playground/text/scanner.hpp"
#include "playground/text/tree.hpp"

#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace playground {

/// Reads an expression, with the precedence that mathematics gives to + - * / ^. What follows works through
/// expressions by recursion, so their depth has a limit.
class expression_reader {
public:
  explicit expression_reader(scanner& from) : from_(from) {}

  tree sum() {
    tree all = product();
    while (from_.next().text == "+" || from_.next().text == "-") {
      const bool adds = from_.take().text == "+";
      if (is_too_long()) return all;
      all = joined(adds ? tree::kind::sum : tree::kind::difference, std::move(all), product());
    }
    return all;
  }

private:
  tree product() {
    tree all = factor();
    while (from_.next().text == "*" || from_.next().text == "/") {
      const bool multiplies = from_.take().text == "*";
      if (is_too_long()) return all;
      all = joined(multiplies ? tree::kind::product : tree::kind::quotient, std::move(all), factor());
    }
    return all;
  }

  tree factor() {
    if (depth_ == most_levels) {
      from_.fail("the expression is nested more than " + std::to_string(most_levels) + " levels deep");
      return {};
    }
    ++depth_;
    tree read = signed_factor();
    --depth_;
    return read;
  }

  tree signed_factor() {
    if (from_.take_if("-")) return {.is = tree::kind::negative, .parts = {factor()}};
    from_.take_if("+");
    tree base = primary();
    if (!from_.take_if("^")) return base;
    return joined(tree::kind::power, std::move(base), factor());
  }

  tree primary() {
    if (from_.take_if("(")) {
      tree inner = sum();
      if (!from_.take_if(")")) from_.fail_expecting("a closing parenthesis");
      return inner;
    }
    if (from_.next().is == token::kind::number) return number();
    if (from_.next().is != token::kind::name) {
      from_.fail_expecting("an expression");
      return {};
    }
    tree named{.is = tree::kind::name, .text = from_.take().text};
    if (from_.take_if(".")) return axis_of(named);
    return from_.take_if("(") ? call_of(named) : named;
  }

  tree number() {
    const std::string digits = from_.take().text;
    std::istringstream in(digits);
    in.imbue(std::locale::classic());
    tree read;
    if (!(in >> read.value) || in.peek() != std::istringstream::traits_type::eof())
      from_.fail(digits + " is not a number");
    return read;
  }

  tree axis_of(tree& frame) {
    const std::string letter = from_.next().text;
    if (letter != "x" && letter != "y" && letter != "z")
      from_.fail("the axes of frame " + frame.text + " are " + frame.text + ".x, " + frame.text + ".y and " +
                 frame.text + ".z");
    from_.take();
    frame.is = tree::kind::axis;
    frame.axis = letter.empty() ? 'x' : letter[0];
    return std::move(frame);
  }

  tree call_of(tree& function) {
    function.is = tree::kind::call;
    do function.parts.push_back(sum());
    while (from_.take_if(","));
    if (!from_.take_if(")")) from_.fail_expecting("a closing parenthesis");
    return std::move(function);
  }

  static tree joined(tree::kind operation, tree left, tree right) {
    tree both{.is = operation};
    both.parts.push_back(std::move(left));
    both.parts.push_back(std::move(right));
    return both;
  }

  bool is_too_long() {
    if (++operations_ <= most_operations) return false;
    from_.fail("the expression has more than " + std::to_string(most_operations) + " operations");
    return true;
  }

  static constexpr int most_levels = 100, most_operations = 1000;

  scanner& from_;
  int depth_ = 0, operations_ = 0;
};

} // namespace playground
