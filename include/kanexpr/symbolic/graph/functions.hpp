#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/selection.hpp>
#include <kanexpr/symbolic/graph/binary_functions.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cmath>
#include <numbers>
#include <type_traits>

/// Functions of one argument: for expressions and for numbers, with their derivatives. Their plain data are
/// in operation.hpp.
namespace kanexpr::symbolic {

constexpr expression sqrt(expression a) { return apply(operation::sqrt, a); }
constexpr expression sin(expression a) { return apply(operation::sin, a); }
constexpr expression cos(expression a) { return apply(operation::cos, a); }
constexpr expression tan(expression a) { return apply(operation::tan, a); }
constexpr expression asin(expression a) { return apply(operation::asin, a); }
constexpr expression acos(expression a) { return apply(operation::acos, a); }
constexpr expression atan(expression a) { return apply(operation::atan, a); }
constexpr expression exp(expression a) { return apply(operation::exp, a); }
constexpr expression log(expression a) { return apply(operation::log, a); }
constexpr expression sinh(expression a) { return apply(operation::sinh, a); }
constexpr expression cosh(expression a) { return apply(operation::cosh, a); }
constexpr expression tanh(expression a) { return apply(operation::tanh, a); }
constexpr expression abs(expression a) { return apply(operation::abs, a); }
constexpr expression sign(expression a) { return apply(operation::sign, a); }
constexpr expression cbrt(expression a) { return apply(operation::cbrt, a); }
constexpr expression erf(expression a) { return apply(operation::erf, a); }
constexpr expression wrap_to_pi(expression a) { return apply(operation::wrap_to_pi, a); }

/// `of` evaluates the function for any scalar type. `slope` is its derivative at x, for expressions and for
/// compile-time numbers; f is the value of the function at x.
template <operation op>
struct scalar_function;

template <>
struct scalar_function<operation::sqrt> {
  template <class Number>
  static Number of(const Number& x) {
    using std::sqrt;
    return sqrt(x);
  }
  template <class Number>
  static constexpr Number slope(const Number&, const Number& f) {
    return 1 / (2 * f);
  }
};

template <>
struct scalar_function<operation::sin> {
  template <class Number>
  static Number of(const Number& x) {
    using std::sin;
    return sin(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::cos;
    return cos(x);
  }
};

template <>
struct scalar_function<operation::cos> {
  template <class Number>
  static Number of(const Number& x) {
    using std::cos;
    return cos(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::sin;
    return -sin(x);
  }
};

template <>
struct scalar_function<operation::tan> {
  template <class Number>
  static Number of(const Number& x) {
    using std::tan;
    return tan(x);
  }
  template <class Number>
  static constexpr Number slope(const Number&, const Number& f) {
    return f * f + 1;
  }
};

template <>
struct scalar_function<operation::asin> {
  template <class Number>
  static Number of(const Number& x) {
    using std::asin;
    return asin(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::sqrt;
    return 1 / sqrt(1 - x * x);
  }
};

template <>
struct scalar_function<operation::acos> {
  template <class Number>
  static Number of(const Number& x) {
    using std::acos;
    return acos(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::sqrt;
    return -(1 / sqrt(1 - x * x));
  }
};

template <>
struct scalar_function<operation::atan> {
  template <class Number>
  static Number of(const Number& x) {
    using std::atan;
    return atan(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    return 1 / (x * x + 1);
  }
};

template <>
struct scalar_function<operation::exp> {
  template <class Number>
  static Number of(const Number& x) {
    using std::exp;
    return exp(x);
  }
  template <class Number>
  static constexpr Number slope(const Number&, const Number& f) {
    return f;
  }
};

template <>
struct scalar_function<operation::log> {
  template <class Number>
  static Number of(const Number& x) {
    using std::log;
    return log(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    return 1 / x;
  }
};

template <>
struct scalar_function<operation::sinh> {
  template <class Number>
  static Number of(const Number& x) {
    using std::sinh;
    return sinh(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::cosh;
    return cosh(x);
  }
};

template <>
struct scalar_function<operation::cosh> {
  template <class Number>
  static Number of(const Number& x) {
    using std::cosh;
    return cosh(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::sinh;
    return sinh(x);
  }
};

template <>
struct scalar_function<operation::tanh> {
  template <class Number>
  static Number of(const Number& x) {
    using std::tanh;
    return tanh(x);
  }
  template <class Number>
  static constexpr Number slope(const Number&, const Number& f) {
    return 1 - f * f;
  }
};

template <>
struct scalar_function<operation::abs> {
  template <class Number>
  static Number of(const Number& x) {
    using std::abs;
    return abs(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::sign;
    return sign(x);
  }
};

template <>
struct scalar_function<operation::sign> {
  template <class Number>
  static Number of(const Number& x) {
    if constexpr (numeric::selected_by_masks<Number>)
      return numeric::where_number(x, static_cast<Number>((Number(0) < x) - (x < Number(0))));
    else if constexpr (std::is_arithmetic_v<Number>)
      return base::is_number(x) ? static_cast<Number>((Number(0) < x) - (x < Number(0))) : x;
    else
      return Number((Number(0) < x) - (x < Number(0)));
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    return x - x;
  }
};

template <>
struct scalar_function<operation::cbrt> {
  template <class Number>
  static Number of(const Number& x) {
    using std::cbrt;
    return cbrt(x);
  }
  template <class Number>
  static constexpr Number slope(const Number&, const Number& f) {
    return 1 / (3 * (f * f));
  }
};

template <>
struct scalar_function<operation::erf> {
  template <class Number>
  static Number of(const Number& x) {
    using std::erf;
    return erf(x);
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    using numeric::elementary::exp;
    return 2 * std::numbers::inv_sqrtpi * exp(-(x * x));
  }
};

template <>
struct scalar_function<operation::wrap_to_pi> {
  /// The remainder is exact, so the value does not depend on the compiler or the processor.
  template <class Number>
  static Number of(const Number& x) {
    if constexpr (std::is_floating_point_v<Number>) {
      constexpr Number pi = std::numbers::pi_v<Number>;
      const Number r = std::remainder(x, 2 * pi);
      return r - static_cast<Number>(r >= pi) * (2 * pi);
    } else {
      return wrap_to_pi(x);
    }
  }
  template <class Number>
  static constexpr Number slope(const Number& x, const Number&) {
    return 1 + (x - x);
  }
};

/// Calls `use.template operator()<op>()` for a function of one argument, with `op` as a constant.
template <class Use>
constexpr decltype(auto) with_function(operation op, const Use& use) {
  switch (op) {
  case operation::sqrt: return use.template operator()<operation::sqrt>();
  case operation::sin: return use.template operator()<operation::sin>();
  case operation::cos: return use.template operator()<operation::cos>();
  case operation::tan: return use.template operator()<operation::tan>();
  case operation::asin: return use.template operator()<operation::asin>();
  case operation::acos: return use.template operator()<operation::acos>();
  case operation::atan: return use.template operator()<operation::atan>();
  case operation::exp: return use.template operator()<operation::exp>();
  case operation::log: return use.template operator()<operation::log>();
  case operation::sinh: return use.template operator()<operation::sinh>();
  case operation::cosh: return use.template operator()<operation::cosh>();
  case operation::tanh: return use.template operator()<operation::tanh>();
  case operation::abs: return use.template operator()<operation::abs>();
  case operation::sign: return use.template operator()<operation::sign>();
  case operation::cbrt: return use.template operator()<operation::cbrt>();
  case operation::erf: return use.template operator()<operation::erf>();
  case operation::wrap_to_pi: return use.template operator()<operation::wrap_to_pi>();
  case operation::constant:
  case operation::symbol:
  case operation::negate:
  case operation::add:
  case operation::subtract:
  case operation::multiply:
  case operation::divide:
  case operation::power:
  case operation::atan2:
  case operation::if_positive:
  case operation::if_not_positive:
  case operation::pair:
  case operation::factorization:
  case operation::solve:
  case operation::transposed_solve:
  case operation::component:
  case operation::singularity_measure:
  case operation::call: break;
  }
  __builtin_unreachable();
}

/// The derivative of a function of one argument at x, where its value is f.
template <class Number>
constexpr Number slope_of(operation op, const Number& x, const Number& f) {
  return with_function(op, [&]<operation function>() { return scalar_function<function>::slope(x, f); });
}

} // namespace kanexpr::symbolic
