#pragma once

#include "checks.hpp"
#include "material.hpp"

#include <kanexpr/animate/animated.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/model.hpp>

#include <cstddef>
#include <string>
#include <utility>

/// The pages of the gallery. The program of a page writes its parts to a folder: the figure, the motion, the
/// exported files, and the words, equations and numbers as JSON. site/build.js turns them into HTML.
namespace gallery {

/// One page: the checks of its base class prove that the motion is right, and `show` writes the parts.
class page : public checks {
public:
  /// The first argument of the program is the folder to write to; its name is the name of the page.
  page(int count, char** words, entry about)
      : folder_(count > 1 ? words[1] : "."), about_(std::move(about)) {}

  /// Writes the parts and returns the exit status of the program. `run` is a simulation or a trajectory.
  template <class Picture, class Run>
  int show(const Run& run, const figure_view& figure = {}) {
    if constexpr (requires { run.trajectory; }) {
      if (!run) refuse(run.cause());
      return show_path<Picture>(run.trajectory, figure);
    } else {
      return show_path<Picture>(run, figure);
    }
  }

private:
  template <class Picture, class Trajectory>
  int show_path(const Trajectory& path, const figure_view& figure) {
    using System = typename Picture::System;
    using eom = kanexpr::equations_of_motion<System>;
    if (path.size() == 0) refuse("the motion has no samples");
    if (!holds()) return write({});
    std::size_t at = 0;
    while (at + 1 < path.size() && path[at].t < figure.at) ++at;
    const auto& shown = path[at];
    const auto call = [&](const auto& x) { return eom::udot(shown.t, x, path.parameters(), shown.r).sum(); };
    return write({.about = about_,
                  .figure = figure,
                  .derive = [] { return kanexpr::derive<System>(); },
                  .motion = kanexpr::animated<Picture>(path),
                  .start = path[0].x,
                  .state = shown.x,
                  .parameters = path.parameters(),
                  .inputs = shown.r,
                  .udot = eom::cost(eom::udot),
                  .nanoseconds = nanoseconds_of(shown.x, call)});
  }

  int write(const material& all) const;

  std::string folder_;
  entry about_;
};

} // namespace gallery
