#pragma once

#include <kanexpr/animate/scene.hpp>
#include <kanexpr/compiled/out_of_line.hpp>

#include <algorithm>
#include <iterator>

#ifndef KANEXPR_COMPILED_PAGES
#include <kanexpr/animate/camera.hpp>
#endif

namespace kanexpr {

namespace animate {

/// A picture and a trajectory of types.
template <class Picture, class Trajectory>
class compiled_scene final : public scene {
  using numbers_in = numbers_of<Picture>;
  using System = typename Picture::System;

public:
  explicit compiled_scene(const Trajectory& trajectory)
      : scene(compiled::survey_of<System>, records_of<Picture>::list, numbers_in::count,
              numbers_in::first_rate, numbers_in::rate_count),
        trajectory_(trajectory) {}

  std::size_t samples() const override {
    return static_cast<std::size_t>(std::distance(trajectory_.begin(), trajectory_.end()));
  }
  status take(std::size_t sample, double& t, double* x, double* all) const override {
    const auto& s = *std::next(trajectory_.begin(), static_cast<std::ptrdiff_t>(sample));
    t = s.t;
    std::copy_n(s.x.data(), s.x.size(), x);
    return evaluate(s, all);
  }
  bool take_between(double t, double* all) const override {
    if constexpr (numbers_in::rate_count != 0 && requires { *trajectory_.at(t); })
      if (const auto between = trajectory_.at(t)) {
        evaluate(*between, all);
        return true;
      }
    static_cast<void>(t), static_cast<void>(all);
    return false;
  }

private:
  template <class Sample>
  status evaluate(const Sample& s, double* all) const {
    const auto found = out_of_line<function<System, numbers_in{}>>{}(s.t, s.x, trajectory_.parameters(), s.r);
    std::copy_n(found.data(), found.size(), all);
    return compiled::status_of(found);
  }

  const Trajectory& trajectory_;
};

} // namespace animate

/// The shapes of a picture along a trajectory: any range of samples that have a time `t`, a state `x` and
/// inputs `r`, with the `parameters()` of the system.
template <class Picture, class Trajectory>
animation animated(const Trajectory& trajectory) {
  if constexpr (animate::sound_picture<Picture>::value)
    return animate::film(animate::compiled_scene<Picture, Trajectory>(trajectory));
  else
    return {};
}

} // namespace kanexpr
