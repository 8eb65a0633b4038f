#pragma once

#include <kanexpr/describe/expression.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <type_traits>
#include <variant>

namespace kanexpr::runtime {

/// A number in the type in which it was passed. In C++, 1/2 is the integer 0, which is never intended.
class given_number {
public:
  template <class Number>
    requires std::is_arithmetic_v<Number> &&
                 (!base::letter<Number>) // bool is allowed: `i == 0` evaluates to 1 or 0
  given_number(Number value)
      : value_(static_cast<double>(value)), is_whole_zero_(describe::is_whole_zero(value)) {}

  double value() const { return value_; }
  bool is_whole_zero() const { return is_whole_zero_; }

private:
  double value_;
  bool is_whole_zero_;
};

/// A number or an expression.
class number_or_expression {
public:
  template <class Number>
    requires std::is_arithmetic_v<Number> && (!base::letter<Number>)
  number_or_expression(Number value) : held_(given_number(value)) {}
  number_or_expression(symbolic::expression e) : held_(e) {}

  const std::variant<given_number, symbolic::expression>& held() const { return held_; }
  bool is_whole_zero() const {
    const given_number* const number = std::get_if<given_number>(&held_);
    return number != nullptr && number->is_whole_zero();
  }

private:
  std::variant<given_number, symbolic::expression> held_;
};

} // namespace kanexpr::runtime
