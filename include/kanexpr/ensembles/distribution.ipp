#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/ensembles/distribution.hpp>
#include <kanexpr/ensembles/lerp.hpp>
#include <kanexpr/numeric/elementary.hpp>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

namespace ensembles {

/// "normal(1, 0.2)".
inline std::string call_of(const char* name, const std::vector<double>& numbers,
                           std::string (*digits)(double)) {
  std::string text = name;
  for (double each : numbers) text += (text.ends_with(name) ? "(" : ", ") + digits(each);
  return text + ')';
}

inline std::string all_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

inline distribution distribution_of(const char* name, const std::vector<double>& numbers,
                                    const char* requirement, bool can_be,
                                    std::function<double(double)> quantile) {
  if (!can_be)
    return distribution::mistaken("invalid distribution " + call_of(name, numbers, base::digits) + ": " +
                                  requirement);
  return {call_of(name, numbers, all_digits), std::move(quantile)};
}

/// Quantiles out of range are infinite; no exception is thrown.
using standard_normal = boost::math::normal_distribution<
    double, boost::math::policies::policy<
                boost::math::policies::domain_error<boost::math::policies::ignore_error>,
                boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>>;

} // namespace ensembles

KANEXPR_ENSEMBLES distribution uniform(double from, double to) {
  return ensembles::distribution_of("uniform", {from, to}, "its start must be below its end",
                                    from < to && numeric::is_finite(from) && numeric::is_finite(to),
                                    [=](double part) { return ensembles::lerp(from, to, part); });
}

KANEXPR_ENSEMBLES distribution log_uniform(double from, double to) {
  const bool can_be = 0 < from && from < to && numeric::is_finite(from) && numeric::is_finite(to);
  const double low = can_be ? numeric::elementary::log(from) : 0,
               high = can_be ? numeric::elementary::log(to) : 0;
  return ensembles::distribution_of(
      "log_uniform", {from, to}, "its start must be above 0 and below its end", can_be, [=](double part) {
        return std::clamp(numeric::elementary::exp(ensembles::lerp(low, high, part)), from, to);
      });
}

KANEXPR_ENSEMBLES distribution normal(double mean, double deviation) {
  // Draws are within 8.3 standard deviations of the mean.
  const bool can_be = deviation > 0 && numeric::is_finite(std::fabs(mean) + 9 * deviation);
  return ensembles::distribution_of(
      "normal", {mean, deviation},
      deviation > 0 ? "its draws must be finite" : "the deviation must be positive", can_be,
      [=](double part) {
        return std::fma(deviation, boost::math::quantile(ensembles::standard_normal(), part), mean);
      });
}

KANEXPR_ENSEMBLES distribution truncated_normal(double mean, double deviation, double from, double to) {
  const ensembles::standard_normal standard;
  const bool is_normal = deviation > 0 && from < to && numeric::is_finite(mean) &&
                         numeric::is_finite(deviation) && !numeric::is_nan(from) && !numeric::is_nan(to);
  // Mirrored if the bounds lie above the mean, because only probabilities near 0 are accurate.
  const bool is_mirrored = from > mean;
  const double sign = is_mirrored ? -1 : 1;
  const auto below = [&](double bound) {
    return is_normal ? boost::math::cdf(standard, sign * ((bound - mean) / deviation)) : 0;
  };
  const double low = below(is_mirrored ? to : from), high = below(is_mirrored ? from : to);
  constexpr double greatest = (std::numeric_limits<double>::max)();
  return ensembles::distribution_of(
      "truncated_normal", {mean, deviation, from, to},
      "the deviation must be positive, and the probability between the bounds must not vanish",
      high - low >= (std::numeric_limits<double>::min)(), [=](double part) {
        const double within = ensembles::lerp(low, high, is_mirrored ? 1 - part : part);
        const double z = sign * boost::math::quantile(ensembles::standard_normal(), within);
        return std::clamp(std::fma(deviation, z, mean), (std::max)(from, -greatest),
                          (std::min)(to, greatest));
      });
}

KANEXPR_ENSEMBLES distribution triangular(double from, double mode, double to) {
  // Scaled by one half if the width overflows.
  const double scale = numeric::is_finite(to - from) ? 1 : 0.5;
  const double rises = (mode * scale - from * scale) / (to * scale - from * scale);
  return ensembles::distribution_of(
      "triangular", {from, mode, to}, "its mode must lie between its ends",
      from <= mode && mode <= to && from < to && numeric::is_finite(from) && numeric::is_finite(to),
      [=](double part) {
        return part < rises ? ensembles::lerp(from, to, std::sqrt(part * rises))
                            : ensembles::lerp(to, from, std::sqrt((1 - part) * (1 - rises)));
      });
}

} // namespace kanexpr
