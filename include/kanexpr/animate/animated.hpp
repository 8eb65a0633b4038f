#pragma once

#include <kanexpr/animate/scene.hpp>

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <utility>

#ifndef KANEXPR_COMPILED_PAGES
#include <kanexpr/animate/camera.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#endif

namespace kanexpr {

namespace animate {

/// The scene of a picture and a trajectory given as types.
template <class Picture, class Trajectory>
class compiled_scene final : public scene {
  using numbers_in = numbers_of<Picture>;
  using System = typename Picture::System;
  static constexpr int energies = numbers_in::has_energies ? 2 : 0;

public:
  explicit compiled_scene(const Trajectory& trajectory)
      : scene(compiled::survey_of<System>, records_of<Picture>::units(), records_of<Picture>::all.list,
              code(), numbers_in::count + energies, numbers_in::first_rate, numbers_in::rate_count,
              amplitudes_in(System::record.bodies)),
        trajectory_(trajectory) {}

  std::size_t samples() const override {
    return static_cast<std::size_t>(std::distance(trajectory_.begin(), trajectory_.end()));
  }
  void parameters(double* p) const override { copy(trajectory_.parameters(), p); }
  void sample(std::size_t which, double& t, double* x, double* r) const override {
    const auto& s = *std::next(trajectory_.begin(), static_cast<std::ptrdiff_t>(which));
    t = s.t;
    copy(s.x, x), copy(s.r, r);
  }
  bool between(double t, double* x, double* r) const override {
    if constexpr (numbers_in::rate_count != 0 && requires { *trajectory_.at(t); })
      if (const auto found = trajectory_.at(t)) {
        copy(found->x, x), copy(found->r, r);
        return true;
      }
    static_cast<void>(t), static_cast<void>(x), static_cast<void>(r);
    return false;
  }

private:
  template <class Values>
  static void copy(const Values& from, double* to) {
    std::copy_n(from.data(), from.size(), to);
  }

  /// The code is interpreted, which is fast enough for the few hundred samples of a page.
  static const compiled::code_table& code() {
    using sample = std::remove_cvref_t<decltype(*std::declval<const Trajectory&>().begin())>;
    using parameters = std::remove_cvref_t<decltype(std::declval<const Trajectory&>().parameters())>;
    if constexpr (numbers_in::has_energies)
      return compiled::table_for<System, double, decltype(sample::x), parameters, decltype(sample::r),
                                 numbers_of<Picture>{}, mechanics::quantity::kinetic_energy,
                                 mechanics::quantity::potential_energy>();
    else
      return compiled::table_for<System, double, decltype(sample::x), parameters, decltype(sample::r),
                                 numbers_of<Picture>{}>();
  }

  const Trajectory& trajectory_;
};

} // namespace animate

/// Returns the shapes of a picture along a trajectory. A trajectory is any range of samples with a time `t`,
/// a state `x` and inputs `r` that also provides the `parameters()` of the system.
template <class Picture, class Trajectory>
animation animated(const Trajectory& trajectory) {
  if constexpr (requires { Picture::along(trajectory); }) { // picture_of
    return Picture::along(trajectory);
  } else if constexpr (animate::valid_picture<Picture>::value) {
    animation made = animate::film(animate::compiled_scene<Picture, Trajectory>(trajectory));
    made.system = type_name<typename Picture::System>();
    return made;
  } else {
    return {};
  }
}

} // namespace kanexpr
