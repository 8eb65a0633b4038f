#pragma once

#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace playground {

using kanexpr::symbolic::expression;

/// A function for expressions and for numbers.
struct function_of_one {
  std::string_view called{};
  expression (*of)(expression) = nullptr;
  double (*of_number)(double) = nullptr;
};
struct function_of_two {
  std::string_view called{};
  expression (*of)(expression, expression) = nullptr;
  double (*of_numbers)(double, double) = nullptr;
};

/// The functions of scalars, by the names that they have in C++.
inline constexpr function_of_one functions_of_one[]{
    {"sqrt", [](expression x) { return sqrt(x); }, [](double x) { return std::sqrt(x); }},
    {"sin", [](expression x) { return sin(x); }, [](double x) { return std::sin(x); }},
    {"cos", [](expression x) { return cos(x); }, [](double x) { return std::cos(x); }},
    {"tan", [](expression x) { return tan(x); }, [](double x) { return std::tan(x); }},
    {"asin", [](expression x) { return asin(x); }, [](double x) { return std::asin(x); }},
    {"acos", [](expression x) { return acos(x); }, [](double x) { return std::acos(x); }},
    {"atan", [](expression x) { return atan(x); }, [](double x) { return std::atan(x); }},
    {"exp", [](expression x) { return exp(x); }, [](double x) { return std::exp(x); }},
    {"log", [](expression x) { return log(x); }, [](double x) { return std::log(x); }},
    {"sinh", [](expression x) { return sinh(x); }, [](double x) { return std::sinh(x); }},
    {"cosh", [](expression x) { return cosh(x); }, [](double x) { return std::cosh(x); }},
    {"tanh", [](expression x) { return tanh(x); }, [](double x) { return std::tanh(x); }},
    {"abs", [](expression x) { return abs(x); }, [](double x) { return std::abs(x); }},
    {"sign", [](expression x) { return sign(x); },
     [](double x) { return static_cast<double>(x > 0) - (x < 0); }},
};
inline constexpr function_of_two functions_of_two[]{
    {"atan2", [](expression y, expression x) { return atan2(y, x); },
     [](double y, double x) { return std::atan2(y, x); }},
    {"hypot", [](expression x, expression y) { return hypot(x, y); },
     [](double x, double y) { return std::hypot(x, y); }},
    {"pow", [](expression x, expression n) { return kanexpr::symbolic::power(x, n); },
     [](double x, double n) { return std::pow(x, n); }},
    {"min", [](expression a, expression b) { return (kanexpr::symbolic::min)(a, b); },
     [](double a, double b) { return (std::min)(a, b); }},
    {"max", [](expression a, expression b) { return (kanexpr::symbolic::max)(a, b); },
     [](double a, double b) { return (std::max)(a, b); }},
};

} // namespace playground
