#pragma once

#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/coefficient.hpp>
#include <kanexpr/symbolic/limits/series.hpp>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// Functions of series, for ε > 0: Griewank & Walther, Evaluating Derivatives (2008), section 13.2. Inverse
/// functions are integrals of algebraic functions.
namespace kanexpr::symbolic::limits {

namespace detail {

inline expansion constant_or(const std::optional<coefficient>& c, obstacle otherwise) {
  if (!c) return otherwise;
  return series(*c);
}

/// Σ j s_j w_{k-j} for j = 1..k
template <class Weights>
coefficient weighted(const series& s, int k, const Weights& w) {
  coefficient sum;
  for (int j = 1; j <= k && j < s.nonzero_end(); ++j)
    sum = sum + coefficient(j) * s[j] * w[static_cast<std::size_t>(k - j)];
  return sum;
}

} // namespace detail

/// The obstacle to expanding an entire function at this argument.
inline obstacle entire_function_obstacle(const series& s) {
  if (s.has_terms() && s.order() < 0) return obstacle::infinite_argument;
  return s.end() <= 0 ? obstacle::truncated : obstacle::none;
}

/// The circular or hyperbolic sine or cosine.
inline expansion sine(const series& s, operation wanted) {
  if (const obstacle reason = entire_function_obstacle(s); reason != obstacle::none) return reason;
  if (s.is_constant()) return detail::constant_or(apply(wanted, s[0]), obstacle::not_real);
  const bool is_circular = wanted == operation::sin || wanted == operation::cos;
  const auto first_sine = apply(is_circular ? operation::sin : operation::sinh, s[0]),
             first_cosine = apply(is_circular ? operation::cos : operation::cosh, s[0]);
  if (!first_sine || !first_cosine) return obstacle::not_real;
  std::vector<coefficient> sines{*first_sine}, cosines{*first_cosine};
  for (int k = 1; k < s.computed_end(); ++k) {
    const coefficient next = detail::weighted(s, k, cosines) / coefficient(k),
                      slope = detail::weighted(s, k, sines) / coefficient(k);
    cosines.push_back(is_circular ? -slope : slope);
    sines.push_back(next);
  }
  const bool is_sine = wanted == operation::sin || wanted == operation::sinh;
  return series(0, std::move(is_sine ? sines : cosines), s.computed_end(), s.max_order());
}

/// Integrates t' = (1 + t²) s'; where the cosine vanishes, a quotient is used.
inline expansion tan(const series& s) {
  if (const obstacle reason = entire_function_obstacle(s); reason != obstacle::none) return reason;
  const std::optional<coefficient> cosine = apply(operation::cos, s[0]);
  if (!cosine) return obstacle::not_real;
  if (cosine->is_zero()) {
    if (s.is_constant()) return obstacle::zero_divisor;
    const series above = *sine(s, operation::sin);
    return quotient(above, *sine(s, operation::cos));
  }
  const std::optional<coefficient> first = apply(operation::tan, s[0]);
  if (!first || s.is_constant()) return detail::constant_or(first, obstacle::not_real);
  std::vector<coefficient> t{*first}, slope{coefficient(1) + *first * *first};
  for (int k = 1; k < s.computed_end(); ++k) {
    t.push_back(detail::weighted(s, k, slope) / coefficient(k));
    coefficient square;
    for (std::size_t j = 0; j < t.size(); ++j) square = square + t[j] * t[t.size() - 1 - j];
    slope.push_back(square);
  }
  return series(0, std::move(t), s.computed_end(), s.max_order());
}

/// sᵖ for a constant exponent, from h' s = p h s'. The leading term decides whether the result is real;
/// `root`, if given, is applied to it instead of a power.
inline expansion power(const series& s, const coefficient& p, operation root = operation::power) {
  if (s.is_zero() && p.is_number() && !p.value().negative()) return series(coefficient(p.is_zero() ? 1 : 0));
  if (s.is_zero()) return obstacle::zero_divisor;
  if (!s.has_terms()) return obstacle::truncated;
  int order = 0;
  if (s.order() != 0) {
    const number scaled = p.value() * exactly(s.order());
    if (!p.is_number() || !scaled.integer()) return obstacle::fractional_order;
    order = static_cast<int>(scaled.numerator);
  }
  if (p.is_number() && p.value() == exactly(1, 2)) root = operation::sqrt;
  const std::optional<coefficient> first =
      root == operation::power ? power(s.lead(), p) : apply(root, s.lead());
  if (!first) return obstacle::not_real;
  if (s.end() == series::all_orders && s.nonzero_end() == s.order() + 1)
    return series(order, {*first}, series::all_orders, s.max_order());
  std::vector<coefficient> h{*first};
  const int end = s.computed_end() - s.order(); // that many terms of s are known
  for (int k = 1; k < end; ++k) {
    coefficient sum;
    for (int j = 1; j <= k && j + s.order() < s.nonzero_end(); ++j) {
      const coefficient weight = p * coefficient(j) - coefficient(k - j);
      sum = sum + weight * s[s.order() + j] * h[static_cast<std::size_t>(k - j)];
    }
    h.push_back(sum / (coefficient(k) * s.lead()));
  }
  return series(order, std::move(h), order + end, s.max_order());
}

inline expansion sqrt(const series& s) { return power(s, coefficient(exactly(1, 2))); }
inline expansion cbrt(const series& s) { return power(s, coefficient(exactly(1, 3)), operation::cbrt); }

/// |s| or the sign of s; the leading term decides.
inline expansion magnitude(const series& s) {
  if (!s.has_terms()) return s;
  if (s.lead().is_number()) return s.lead().value().negative() ? -s : s;
  const std::optional<coefficient> side = apply(operation::sign, s.lead());
  const series first(s.order(), {*apply(operation::abs, s.lead())}, series::all_orders, s.max_order());
  return first + (s - series(s.order(), {s.lead()}, series::all_orders, s.max_order())) * series(*side);
}
/// The leading term of the condition decides; if it is symbolic, every term gets a selection.
inline expansion selected(operation op, const series& condition, const series& s) {
  if (condition.is_zero()) return op == operation::if_positive ? series{} : s;
  if (!condition.has_terms()) return obstacle::truncated;
  const coefficient& lead = condition.lead();
  if (lead.is_number()) return lead.value().negative() == (op == operation::if_positive) ? series{} : s;
  if (s.is_zero()) return s;
  std::vector<coefficient> terms;
  for (int k = s.order(); k < s.nonzero_end(); ++k) terms.push_back(selected(op, lead, s[k]));
  return series(s.order(), std::move(terms), s.end(), s.max_order());
}

inline expansion sign(const series& s) {
  if (s.is_zero()) return s;
  if (!s.has_terms()) return obstacle::truncated;
  return detail::constant_or(apply(operation::sign, s.lead()), obstacle::not_real);
}

/// s minus whole turns. At an odd multiple of π, the first term that follows decides between π and -π.
inline expansion wrap_to_pi(const series& s) {
  if (const obstacle reason = entire_function_obstacle(s); reason != obstacle::none) return reason;
  const std::optional<coefficient> first = apply(operation::wrap_to_pi, s[0]);
  if (!first || s.is_constant()) return detail::constant_or(first, obstacle::not_real);
  const series rest = s - series(s[0]);
  const coefficient half_turn(real(numeric::elementary::detail::half_turn));
  const double gap = first->is_number() ? half_turn.value().value() - std::abs(first->value().value()) : 1;
  if (gap > 4 * s[0].at()[0].error) return rest + series(*first);
  if (!rest.has_terms()) return rest.is_zero() ? rest + series(*first) : expansion(obstacle::truncated);
  if (!rest.lead().is_number()) return obstacle::piecewise;
  return rest + series(rest.lead().value().negative() ? half_turn : -half_turn);
}

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

/// The arcsine or arccosine. At the ends of the domain, the rate is a quotient whose numerator and
/// denominator both vanish.
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
