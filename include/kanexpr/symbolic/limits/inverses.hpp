#pragma once

#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/function_series.hpp>

#include <optional>

/// Functions of series that are integrals of algebraic functions.
namespace kanexpr::symbolic::limits {

/// f + ∫ rate; fails if the rate has a pole.
inline expansion integral_from(const std::optional<coefficient>& f, const expansion& rate) {
  if (!f) return obstacle::not_real;
  if (!rate) return rate;
  if (rate->end() < 0) return obstacle::truncated;
  if (rate->has_terms() && rate->order() < 0) return obstacle::fractional_order;
  return integral(*rate, *f);
}

inline expansion log(const series& s) {
  if (s.is_zero() || (s.has_terms() && s.order() != 0)) return obstacle::zero_logarithm;
  if (!s.has_terms()) return obstacle::truncated;
  const std::optional<coefficient> first = apply(operation::log, s[0]);
  return integral_from(first, quotient(derivative(s), s));
}

inline expansion atan(const series& s) {
  constexpr double right_angle = 1.57079632679489661923;
  if (s.has_terms() && s.order() < 0) {
    if (s.lead().at().vanishes_at_some()) return obstacle::piecewise;
    const std::optional<coefficient> side = apply(operation::sign, s.lead());
    const expansion rest = atan(series(coefficient(1)) / s);
    if (!side || !rest) return obstacle::not_real;
    return series(*side * coefficient(real(right_angle))) - *rest;
  }
  if (s.end() <= 0) return obstacle::truncated;
  const std::optional<coefficient> first = apply(operation::atan, s[0]);
  const series rate = derivative(s);
  return integral_from(first, quotient(rate, series(coefficient(1)) + s * s));
}

/// The arcsine or arccosine. At the ends of its domain the rate is a quotient whose terms vanish.
inline expansion arcsine(const series& s, operation wanted) {
  if (s.has_terms() && s.order() < 0) return obstacle::not_real;
  if (s.end() <= 0) return obstacle::truncated;
  coefficient start = s[0];
  if ((coefficient(1) - start * start).is_zero() && start.is_number())
    start = coefficient(start.value().negative() ? -1 : 1);
  const std::optional<coefficient> first = apply(wanted, start);
  const series slope = derivative(s);
  if (slope.is_zero()) return detail::constant_or(first, obstacle::not_real);
  expansion leg = sqrt(series(coefficient(1)) - s * s);
  if (!leg) return leg;
  const expansion rate = quotient(slope, *leg);
  if (wanted == operation::asin || !rate) return integral_from(first, rate);
  return integral_from(first, -*rate);
}

namespace detail {

/// On the negative x axis, the sign of y decides.
inline std::optional<coefficient> initial_angle(const series& y, const series& x, int order) {
  if (!y[order].is_zero() || !y.has_terms()) return apply(operation::atan2, y[order], x[order]);
  const std::optional<coefficient> side = apply(operation::sign, y.lead()),
                                   angle = apply(operation::atan2, coefficient(), x[order]);
  return *side * *angle;
}

} // namespace detail

/// The angle of (x, y) from (x y' - y x')/(x² + y²); only the ratio matters, so both may vanish.
inline expansion atan2(const series& y, const series& x) {
  if (y.is_zero() && x.is_zero()) return obstacle::zero_divisor;
  const int order = (std::min)(y.order(), x.order());
  if (y.end() <= order || x.end() <= order) return obstacle::truncated;
  const bool is_positive = x[order].is_number() && !x[order].value().negative();
  if (!y.has_terms() && !y.is_zero() && !is_positive) return obstacle::truncated;
  const std::optional<coefficient> first = detail::initial_angle(y, x, order);
  const series climb = x * derivative(y), turn = climb - y * derivative(x), square = x * x;
  return integral_from(first, quotient(turn, square + y * y));
}

} // namespace kanexpr::symbolic::limits
