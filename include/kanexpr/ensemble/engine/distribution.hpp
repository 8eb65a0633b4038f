#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/ensemble/distribution.hpp>

#include <boost/math/distributions/normal.hpp>

#include <cmath>
#include <initializer_list>

namespace kanexpr {

namespace ensembles {

/// "normal(1, 0.2)".
inline std::string called(const char* name, std::initializer_list<double> numbers) {
  std::string text = name;
  for (const char* before = "("; double number : numbers) {
    text += before + simulated::digits(number);
    before = ", ";
  }
  return text + ')';
}

inline distribution distribution_of(std::string text, const char* needs, bool can_be,
                                    std::function<double(double)> quantile) {
  if (!can_be) return distribution::mistaken("there is no distribution " + text + ": " + needs);
  return {std::move(text), std::move(quantile)};
}

} // namespace ensembles

KANEXPR_ENSEMBLES distribution uniform(double from, double to) {
  return ensembles::distribution_of(ensembles::called("uniform", {from, to}), "it must begin below its end",
                                    from < to && std::isfinite(from) && std::isfinite(to),
                                    [=](double part) { return from + part * (to - from); });
}

KANEXPR_ENSEMBLES distribution log_uniform(double from, double to) {
  return ensembles::distribution_of(ensembles::called("log_uniform", {from, to}),
                                    "it must begin above 0, and below its end",
                                    0 < from && from < to && std::isfinite(to),
                                    [=](double part) { return from * std::exp(part * std::log(to / from)); });
}

KANEXPR_ENSEMBLES distribution normal(double mean, double deviation) {
  return ensembles::distribution_of(
      ensembles::called("normal", {mean, deviation}), "the deviation must be positive",
      deviation > 0 && std::isfinite(mean) && std::isfinite(deviation), [=](double part) {
        return mean + deviation * boost::math::quantile(boost::math::normal_distribution<>(), part);
      });
}

KANEXPR_ENSEMBLES distribution truncated_normal(double mean, double deviation, double from, double to) {
  const boost::math::normal_distribution<> standard;
  const bool can_be = deviation > 0 && from < to && std::isfinite(mean) && std::isfinite(deviation);
  const double low = can_be ? boost::math::cdf(standard, (from - mean) / deviation) : 0;
  const double high = can_be ? boost::math::cdf(standard, (to - mean) / deviation) : 1;
  return ensembles::distribution_of(
      ensembles::called("truncated_normal", {mean, deviation, from, to}),
      "the deviation must be positive, and some of it must lie between the bounds", can_be && high > low,
      [=](double part) {
        const double within = mean + deviation * boost::math::quantile(standard, low + part * (high - low));
        return within < from ? from : within > to ? to : within;
      });
}

KANEXPR_ENSEMBLES distribution triangular(double from, double mode, double to) {
  return ensembles::distribution_of(
      ensembles::called("triangular", {from, mode, to}), "its mode must lie between its ends",
      from <= mode && mode <= to && from < to && std::isfinite(from) && std::isfinite(to), [=](double part) {
        const double width = to - from, rises = (mode - from) / width;
        return part < rises ? from + width * std::sqrt(part * rises)
                            : to - width * std::sqrt((1 - part) * (1 - rises));
      });
}

} // namespace kanexpr
