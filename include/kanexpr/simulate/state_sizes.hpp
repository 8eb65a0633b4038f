#pragma once

#include <kanexpr/compiled/equations_of_motion.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kanexpr::simulated {

/// How large the coordinates and speeds of a motion are, in whatever units, as far as its first instant
/// tells: their values there, and what their rates and accelerations make of them in the time in which the
/// motion changes. What does not move at all is as large as the largest of its kind, coordinates or speeds,
/// and 1 where all of these rest at zero.
template <class System>
class state_sizes {
public:
  using state = kanexpr::state<System>;

  template <class P, class R>
  state_sizes(double t, const state& x, const P& p, const R& r, double span) : sizes_(x.cwiseAbs()) {
    const auto rates = equations_of_motion<System>::rhs(t, x, p, r);
    const double instant = 1e-9 * span;
    if (compiled::status_of(rates) && instant > 0) {
      const state ahead = state(x + instant * rates);
      const auto later = equations_of_motion<System>::rhs(t, ahead, p, r);
      if (compiled::status_of(later)) take(rates, state((later - rates) / instant), span);
    }
    fill(0, state::coordinates);
    fill(state::coordinates, state::coordinates + state::speeds);
  }

  const state& sizes() const { return sizes_; }

private:
  /// The median of what each entry says of the time, so that one which happens to be next to zero does not
  /// matter.
  template <class Rates>
  void take(const Rates& rates, const state& accelerations, double span) {
    std::vector<double> times;
    const auto add = [&](double time) {
      if (time > 0 && std::isfinite(time)) times.push_back(time);
    };
    for (Eigen::Index i = 0; i < sizes_.size(); ++i) {
      const double acceleration = std::abs(accelerations(i));
      add(sizes_(i) / std::abs(rates(i)));
      add(std::sqrt(sizes_(i) / acceleration));
      add(std::abs(rates(i)) / acceleration);
    }
    double time = span;
    if (!times.empty()) {
      const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
      std::nth_element(times.begin(), middle, times.end());
      time = std::min(span, *middle);
    }
    for (Eigen::Index i = 0; i < sizes_.size(); ++i) {
      const double size = std::max(std::abs(rates(i)) * time, std::abs(accelerations(i)) * time * time / 2);
      if (std::isfinite(size)) sizes_(i) = std::max(sizes_(i), size);
    }
  }

  void fill(Eigen::Index begin, Eigen::Index end) {
    double largest = 0;
    for (Eigen::Index i = begin; i < end; ++i) largest = std::max(largest, sizes_(i));
    for (Eigen::Index i = begin; i < end; ++i)
      if (!(sizes_(i) > 1e-12 * largest)) sizes_(i) = largest > 0 ? largest : 1;
  }

  state sizes_;
};

} // namespace kanexpr::simulated
