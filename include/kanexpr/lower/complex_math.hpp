#pragma once

#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <complex>
#include <concepts>
#include <limits>
#include <utility>

namespace kanexpr::lower {

/// Complex numbers for complex-step differentiation: functions that depend on magnitudes or signs use the
/// real part, so every function remains analytic (Squire & Trapp, Using complex variables to estimate
/// derivatives of real functions, SIAM Review 40, 1998).
template <class Real>
struct scalar_math<std::complex<Real>> : default_scalar_math<std::complex<Real>> {
  using number = std::complex<Real>;

  static number sign(const number& x) { return scalar_math<Real>::sign(x.real()); }
  static bool exceeds(const number& x, const number& bound) {
    return scalar_math<Real>::exceeds(x.real(), bound.real());
  }
  static bool is_finite(const number& x) {
    return scalar_math<Real>::is_finite(x.real()) && scalar_math<Real>::is_finite(x.imag());
  }
  static void exchange_if_positive(const number& d, number& a, number& b) {
    if (d.real() > Real(0)) std::swap(a, b);
  }
  template <symbolic::operation op>
  static number selected(const number& condition, const number& x) {
    const Real by = condition.real();
    if (op == symbolic::operation::if_positive ? Real(0) < by : by <= Real(0)) return x;
    return base::is_number(by) ? number() : condition;
  }
  /// A user-supplied function that accepts only real numbers is evaluated to first order, from its
  /// derivatives.
  template <class Function>
  static constexpr bool interprets = Function::has_slopes;
  template <class Function>
  static constexpr bool calls =
      Function::template accepts<number>() || (Function::template accepts<Real>() && Function::has_slopes);
  template <class Function>
  static number called(const std::same_as<number> auto&... x) {
    if constexpr (Function::template accepts<number>()) {
      return Function::template value<number>(x...);
    } else {
      const number operands[]{x...};
      return called(Function::function, operands);
    }
  }
  static number called(const symbolic::external_function& f, const number* x) {
    double operands[symbolic::max_operands]{};
    for (int i = 0; i < f.operands; ++i) operands[i] = static_cast<double>(x[i].real());
    Real along = 0;
    for (int i = 0; i < f.operands; ++i) {
      const symbolic::external_function& slope = f.slope(i);
      along += slope.is_provided() ? static_cast<Real>(slope.value(operands)) * x[i].imag()
                                   : std::numeric_limits<Real>::quiet_NaN();
    }
    return {static_cast<Real>(f.value(operands)), along};
  }
  /// A function that <complex> does not provide is evaluated for the real part and extended to first order.
  template <symbolic::operation op>
  static number by_name(const number& x) {
    if constexpr (symbolic::properties_of(op).has_complex) {
      return default_scalar_math<number>::template by_name<op>(x);
    } else {
      const Real f = scalar_math<Real>::template by_name<op>(x.real());
      return {f, slope<op>(x.real(), f) * x.imag()};
    }
  }
  template <symbolic::operation op>
  static number by_name(const number& a, const number& b) {
    const Real f = scalar_math<Real>::template by_name<op>(a.real(), b.real());
    return {f, symbolic::binary_rate_of<op>(a.real(), b.real(), f, a.imag(), b.imag())};
  }

private:
  /// Computes in double, the precision of functions in constant expressions.
  template <symbolic::operation op>
  static Real slope(Real x, Real f) {
    return static_cast<Real>(symbolic::function_slope<op>(static_cast<double>(x), static_cast<double>(f)));
  }
};

} // namespace kanexpr::lower
