#pragma once

#include <kanexpr/ensembles/compiled_ensembles.hpp>

#include <functional>
#include <string>
#include <utility>

namespace kanexpr {

/// The distribution of a number, given by its quantile function: the value below which the number lies with a
/// given probability. Some are defined below; any other is constructed from its quantile function, for
/// example one from Boost.Math: `distribution("weibull(1.5, 2)", [w](double part) { return quantile(w, part);
/// })`.
///
/// The first argument must contain all parameters with all digits, since it identifies the distribution when
/// a study resumes from a checkpoint.
///
/// The values of `uniform` and `triangular` have the same bits on every machine. The last digits of the
/// others depend on the machine's long double, and those of the normal distributions also on Boost.Math.
class distribution {
public:
  distribution(std::string identity, std::function<double(double part)> quantile)
      : identity_(std::move(identity)), quantile_(std::move(quantile)) {}
  /// Returns an invalid distribution, with the reason.
  static distribution mistaken(std::string mistake) {
    distribution none({}, {});
    none.mistake_ = std::move(mistake);
    return none;
  }

  double quantile(double part) const { return quantile_(part); }
  const std::string& identity() const { return identity_; }
  const std::string& mistake() const { return mistake_; }

private:
  std::string identity_;
  std::function<double(double)> quantile_;
  std::string mistake_{};
};

/// A uniform distribution over [from, to].
KANEXPR_ENSEMBLES distribution uniform(double from, double to);
/// A distribution whose logarithm is uniform, for quantities of which only the order of magnitude is known.
KANEXPR_ENSEMBLES distribution log_uniform(double from, double to);
/// A normal distribution with a given mean and standard deviation.
KANEXPR_ENSEMBLES distribution normal(double mean, double deviation);
/// A normal distribution restricted to [from, to], for example for masses, which are positive.
KANEXPR_ENSEMBLES distribution truncated_normal(double mean, double deviation, double from, double to);
/// A distribution whose density rises linearly from zero at `from` to its peak at `mode` and falls
/// linearly to zero at `to`.
KANEXPR_ENSEMBLES distribution triangular(double from, double mode, double to);

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensembles/distribution.ipp>
#endif
