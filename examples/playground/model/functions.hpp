#pragma once

#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>

#include <string_view>

namespace playground {

using kanexpr::symbolic::expression;

struct function_of_one {
  std::string_view called{};
  expression (*of)(expression) = nullptr;
};
struct function_of_two {
  std::string_view called{};
  expression (*of)(expression, expression) = nullptr;
};

/// The functions of scalars, by the names that they have in C++.
inline constexpr function_of_one functions_of_one[]{
    {"sqrt", [](expression x) { return sqrt(x); }}, {"sin", [](expression x) { return sin(x); }},
    {"cos", [](expression x) { return cos(x); }},   {"tan", [](expression x) { return tan(x); }},
    {"asin", [](expression x) { return asin(x); }}, {"acos", [](expression x) { return acos(x); }},
    {"atan", [](expression x) { return atan(x); }}, {"exp", [](expression x) { return exp(x); }},
    {"log", [](expression x) { return log(x); }},   {"sinh", [](expression x) { return sinh(x); }},
    {"cosh", [](expression x) { return cosh(x); }}, {"tanh", [](expression x) { return tanh(x); }},
    {"abs", [](expression x) { return abs(x); }},   {"sign", [](expression x) { return sign(x); }},
};
inline constexpr function_of_two functions_of_two[]{
    {"atan2", [](expression y, expression x) { return atan2(y, x); }},
    {"hypot", [](expression x, expression y) { return hypot(x, y); }},
    {"pow", [](expression x, expression n) { return kanexpr::symbolic::power(x, n); }},
    {"min", [](expression a, expression b) { return (kanexpr::symbolic::min)(a, b); }},
    {"max", [](expression a, expression b) { return (kanexpr::symbolic::max)(a, b); }},
};

} // namespace playground
