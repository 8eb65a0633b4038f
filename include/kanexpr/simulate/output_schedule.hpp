#pragma once

#include <kanexpr/simulate/time_span.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace kanexpr::simulated {

/// The times at which samples are asked for, one after another: regular ones with both ends of the span, or
/// those of a list.
class output_schedule {
public:
  output_schedule(const time_span& span, double every, const std::vector<double>& times)
      : span_(span), every_(every), times_(times) {
    if (every > 0)
      count_ = static_cast<std::size_t>(std::ceil((span.to - span.from) / every * (1 - 1e-12))) + 1;
    if (!times.empty()) count_ = times.size();
  }

  /// Whether no times are asked for: each step of the integrator is a sample.
  bool takes_each_step() const { return every_ == 0 && times_.empty(); }

  bool is_over() const { return next_ == count_; }
  double next() const {
    if (!times_.empty()) return times_[next_];
    return next_ + 1 == count_ ? span_.to : span_.from + static_cast<double>(next_) * every_;
  }
  void pass() { ++next_; }

private:
  time_span span_;
  double every_;
  const std::vector<double>& times_;
  std::size_t next_ = 0, count_ = 0;
};

} // namespace kanexpr::simulated
