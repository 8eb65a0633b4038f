#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/simulations/settings.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kanexpr::simulations {

/// The times of the requested samples, in order: regularly spaced times that include both ends of the span,
/// or the times of a list.
class output_schedule {
public:
  output_schedule(const time_span& span, double every, const std::vector<double>& times)
      : span_(span), every_(every), times_(times) {
    if (every > 0) {
      const double parts = (span.to - span.from) / every;
      const double rounding = (std::min)(1e-12 * parts, 1e-3); // a shorter last interval is ignored
      count_ = std::ceil(parts - rounding) + 1;
    }
    if (!times.empty()) count_ = static_cast<double>(times.size());
  }

  /// Whether no times are requested, so that each step of the integrator is a sample.
  bool takes_each_step() const { return base::equal(every_, 0.0) && times_.empty(); }

  bool is_over() const { return base::equal(next_, count_); }
  double next() const {
    if (!times_.empty()) return times_[static_cast<std::size_t>(next_)];
    return base::equal(next_ + 1, count_) ? span_.to : span_.from + next_ * every_;
  }
  void advance() { ++next_; }

private:
  time_span span_;
  double every_;
  const std::vector<double>& times_;
  double next_ = 0, count_ = 0; // integers
};

} // namespace kanexpr::simulations
