#pragma once

#include <kanexpr/simulate/rates_at.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
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

  state_sizes(surroundings<System>& around, double t, const state& x, double span) : sizes_(x.cwiseAbs()) {
    state rates, later;
    const double instant = 1e-9 * span;
    if (instant > 0 && rates_at(around, t, x, rates) &&
        rates_at(around, t + instant, state(x + instant * rates), later))
      take(rates, state((later - rates) / instant), span);
    around.forget();
    fill(0, state::coordinates);
    fill(state::coordinates, state::coordinates + state::speeds);
  }

  const state& sizes() const { return sizes_; }

private:
  /// The median of what each entry says of the time, so that one which happens to be next to zero does not
  /// matter.
  void take(const state& rates, const state& accelerations, double span) {
    std::vector<double> times;
    const auto add = [&](double time) {
      if (time > 0 && std::isfinite(time)) times.push_back(time);
    };
    for (Eigen::Index i = 0; i < sizes_.size(); ++i) {
      const double acceleration = std::abs(accelerations(i));
      const double farthest = (std::max)(std::abs(rates(i)) * span, acceleration * span * span / 2);
      add(std::abs(rates(i)) / acceleration);
      if (sizes_(i) <= std::numeric_limits<double>::epsilon() * farthest) continue; // it begins at zero
      add(sizes_(i) / std::abs(rates(i)));
      add(std::sqrt(sizes_(i) / acceleration));
    }
    double time = span;
    if (!times.empty()) {
      const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
      std::nth_element(times.begin(), middle, times.end());
      time = (std::min)(span, *middle);
    }
    for (Eigen::Index i = 0; i < sizes_.size(); ++i) {
      const double size = (std::max)(std::abs(rates(i)) * time, std::abs(accelerations(i)) * time * time / 2);
      if (std::isfinite(size)) sizes_(i) = (std::max)(sizes_(i), size);
    }
  }

  void fill(Eigen::Index begin, Eigen::Index end) {
    double largest = 0;
    for (Eigen::Index i = begin; i < end; ++i) largest = (std::max)(largest, sizes_(i));
    for (Eigen::Index i = begin; i < end; ++i)
      if (!(sizes_(i) > 1e-12 * largest)) sizes_(i) = largest > 0 ? largest : 1;
  }

  state sizes_;
};

} // namespace kanexpr::simulated
