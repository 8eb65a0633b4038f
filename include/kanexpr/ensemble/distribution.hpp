#pragma once

#include <kanexpr/ensemble/compiled_ensembles.hpp>

#include <functional>
#include <string>
#include <utility>

namespace kanexpr {

/// How a number is distributed, by its quantiles: the value below which it lies with a given probability,
/// between 0 and 1. `uniform`, `normal` and others are below; any other is made of its quantiles, as those of
/// Boost.Math: `distribution("weibull(1.5, 2)", [w](double part) { return quantile(w, part); })`.
///
/// The text must tell all parameters, with all their digits, since a study is known again by it: a checkpoint
/// goes on if the text is the same.
///
/// `uniform` and `triangular` have the same bits on every machine. The last digits of the others depend on
/// its long double, and those of the normal ones on Boost.Math too.
class distribution {
public:
  distribution(std::string text, std::function<double(double part)> quantile)
      : text_(std::move(text)), quantile_(std::move(quantile)) {}
  /// One that cannot be.
  static distribution mistaken(std::string mistake) {
    distribution none({}, {});
    none.mistake_ = std::move(mistake);
    return none;
  }

  double quantile(double part) const { return quantile_(part); }
  /// What it is, with all digits, by which a study is known again.
  const std::string& text() const { return text_; }
  const std::string& mistake() const { return mistake_; }

private:
  std::string text_;
  std::function<double(double)> quantile_;
  std::string mistake_{};
};

KANEXPR_ENSEMBLES distribution uniform(double from, double to);
/// The logarithm is uniform: for what is known by its order of magnitude.
KANEXPR_ENSEMBLES distribution log_uniform(double from, double to);
KANEXPR_ENSEMBLES distribution normal(double mean, double deviation);
/// A normal one without what lies outside of [from, to], as of masses, which are positive.
KANEXPR_ENSEMBLES distribution truncated_normal(double mean, double deviation, double from, double to);
/// Most probable is `mode`.
KANEXPR_ENSEMBLES distribution triangular(double from, double mode, double to);

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/distribution.hpp>
#endif
