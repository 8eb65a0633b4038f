#pragma once

#include <kanexpr/compiled/state.hpp>

#include <optional>
#include <vector>

namespace tests {

template <class System>
struct sample {
  double t = 0;
  kanexpr::state<System> x;
  kanexpr::input_values<System> r;
};

/// The minimum that a picture requires of a trajectory: samples and parameters.
template <class System>
struct samples {
  std::vector<sample<System>> all;
  kanexpr::parameter_values<System> p;

  auto begin() const { return all.begin(); }
  auto end() const { return all.end(); }
  const auto& parameters() const { return p; }
};

/// A motion that is known at any time, sampled.
template <class System, class Motion>
struct known_motion : samples<System> {
  Motion motion;

  known_motion(const kanexpr::parameter_values<System>& parameters, Motion m, int steps, double step)
      : samples<System>{{}, parameters}, motion(m) {
    for (int i = 0; i <= steps; ++i) this->all.push_back({i * step, motion(i * step), {}});
  }
  std::optional<sample<System>> at(double t) const { return sample<System>{t, motion(t), {}}; }
};

} // namespace tests
