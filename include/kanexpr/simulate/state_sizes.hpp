#pragma once

#include <kanexpr/simulate/rates_at.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kanexpr::simulated {

/// How large the coordinates and speeds of a motion are, in whatever units, as far as its beginning tells:
/// their values there, and what they become in the time in which the motion changes. What does not move at
/// all is as large as the largest of its kind, coordinates or speeds, and 1 where all of these rest at zero.
template <class System>
class state_sizes {
public:
  using state = kanexpr::state<System>;

  state_sizes(surroundings<System>& around, double t, const state& x, double span)
      : around_(around), t_(t), start_(x), sizes_(x.cwiseAbs()) {
    if (span > 0 && rates_at(around_, t, x, rates_)) {
      look_ahead(span);
      grow();
      heed_coordinates(span);
    }
    around.forget();
    fill(0, state::coordinates);
    fill(state::coordinates, state::coordinates + state::speeds);
  }

  const state& sizes() const { return sizes_; }

private:
  /// What a step from the start changes; not a number where it cannot be told.
  struct outlook {
    double ahead;
    state change;
  };

  /// Goes steps of the classic Runge-Kutta method from the start, each longer than the one before, until most
  /// entries differ from what two of half the length give: the motion has a time of its own, and it is over.
  void look_ahead(double span) {
    long most = 0;
    state rough, half, fine;
    for (double ahead = 0x1p-30 * span; ahead <= span; ahead *= 4) {
      if (!step(t_, start_, rates_, ahead, rough) || !step(t_, start_, rates_, ahead / 2, half)) return;
      state there;
      if (!rates_at(around_, t_ + ahead / 2, half, there)) return;
      if (!step(t_ + ahead / 2, half, there, ahead / 2, fine)) return;
      outlook seen{ahead, state(fine - start_)};
      long told = 0;
      for (Eigen::Index i = 0; i < start_.size(); ++i)
        if (is_told(i, seen.change(i), fine(i) - rough(i)))
          ++told;
        else
          seen.change(i) = std::numeric_limits<double>::quiet_NaN();
      most = (std::max)(most, told);
      has_own_time_ = 2 * told < most;
      if (has_own_time_) return;
      outlooks_.push_back(seen);
    }
  }

  /// Whether a change is more than rounding and the error of a step.
  bool is_told(Eigen::Index i, double change, double error) const {
    const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * std::abs(start_(i));
    return std::abs(change) > rounding && std::abs(error) <= 0.1 * std::abs(change);
  }

  bool step(double t, const state& x, const state& k1, double h, state& end) {
    state k2, k3, k4;
    if (!rates_at(around_, t + h / 2, state(x + h / 2 * k1), k2) ||
        !rates_at(around_, t + h / 2, state(x + h / 2 * k2), k3) ||
        !rates_at(around_, t + h, state(x + h * k3), k4))
      return false;
    end = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    return end.allFinite();
  }

  /// A motion without a time of its own, as a fall, is looked at until entries have changed by their own
  /// size: the median of these times, so that one which begins next to zero does not matter.
  double time_of_change() const {
    const double all = std::numeric_limits<double>::infinity();
    if (has_own_time_) return all;
    std::vector<double> times;
    for (Eigen::Index i = 0; i < start_.size(); ++i) {
      double farthest = 0;
      for (const outlook& o : outlooks_)
        if (std::abs(o.change(i)) > farthest) farthest = std::abs(o.change(i));
      if (std::abs(start_(i)) <= std::numeric_limits<double>::epsilon() * farthest) continue; // it is zero
      const auto changed = std::ranges::find_if(
          outlooks_, [&](const outlook& o) { return std::abs(o.change(i)) >= std::abs(start_(i)); });
      times.push_back(changed != outlooks_.end() ? changed->ahead : all);
    }
    if (times.empty()) return all;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return *middle;
  }

  void grow() {
    const double time = time_of_change();
    for (const outlook& o : outlooks_)
      for (Eigen::Index i = 0; i < sizes_.size(); ++i)
        if (o.ahead <= time && std::isfinite(o.change(i)))
          sizes_(i) = (std::max)({sizes_(i), std::abs(o.change(i)), std::abs(start_(i) + o.change(i))});
  }

  /// Errors of a speed do not matter that would move each coordinate by less than its own error: by a tenth
  /// in the motion's own time, or by much less in the whole span.
  void heed_coordinates(double span) {
    const bool has_time = has_own_time_ && !outlooks_.empty();
    const double most = has_time ? 0.1 / outlooks_.back().ahead : 1e-4 / span;
    constexpr auto n = static_cast<Eigen::Index>(state::coordinates);
    for (Eigen::Index j = n; j < sizes_.size(); ++j) {
      state beside = start_, rates;
      const double more = sizes_(j) > 0 ? sizes_(j) : 1;
      beside(j) += more;
      if (!rates_at(around_, t_, beside, rates)) continue;
      double least = std::numeric_limits<double>::infinity();
      for (Eigen::Index i = 0; i < n; ++i)
        if (const double moved = std::abs(rates(i) - rates_(i)) / more; moved > 0 && sizes_(i) > 0)
          least = (std::min)(least, sizes_(i) / moved);
      if (std::isfinite(least)) sizes_(j) = (std::max)(sizes_(j), most * least);
    }
  }

  void fill(Eigen::Index begin, Eigen::Index end) {
    double largest = 0;
    for (Eigen::Index i = begin; i < end; ++i) largest = (std::max)(largest, sizes_(i));
    for (Eigen::Index i = begin; i < end; ++i)
      if (!(sizes_(i) > 1e-12 * largest)) sizes_(i) = largest > 0 ? largest : 1;
  }

  surroundings<System>& around_;
  double t_;
  state start_, rates_{}, sizes_;
  std::vector<outlook> outlooks_{};
  bool has_own_time_ = false;
};

} // namespace kanexpr::simulated
