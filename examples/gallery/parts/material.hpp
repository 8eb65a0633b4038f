#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/cost.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The parts from which a page of the gallery is written.
namespace gallery {

/// The words of a page.
struct entry {
  std::string title{};
  std::string kind{};   ///< the chapter of the gallery, one of those in site/chapters.json
  std::string see{};    ///< two sentences: what to watch for, and why it happens
  std::string source{}; ///< where the literature describes the system
};

/// The figure of a page; see docs/figures.md.
struct figure_view {
  double at = 0;                           ///< the time of the state that it shows
  std::optional<Eigen::Vector3d> upward{}; ///< in inertial axes; by default opposite to gravity
  std::optional<Eigen::Vector3d> eye{};    ///< the direction to the eye
  bool angles = true, lengths = true, loads = true, names = true;
};

/// A page without its HTML.
struct material {
  entry about{};
  figure_view figure{};
  std::function<kanexpr::model()> derive{};
  kanexpr::animation motion{};
  Eigen::VectorXd start{};      ///< the state at the beginning of the motion
  Eigen::VectorXd state{};      ///< the state of the figure
  Eigen::VectorXd parameters{}; ///< their values
  Eigen::VectorXd inputs{};     ///< their values in the figure
  kanexpr::symbolic::cost udot{};
  double nanoseconds = 0; ///< of one call of u̇
};

/// Median nanoseconds of one call of `f(x)`. The state changes a little, so that each call does its work.
template <class State, class Function>
double nanoseconds_of(State x, Function f) {
  constexpr int rounds = 31, calls = 1000;
  volatile double kept = 0;
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) {
      x.array() += 1e-9;
      kept = f(x);
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    times.push_back(taken.count() / calls);
  }
  static_cast<void>(kept);
  std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
  return times[rounds / 2];
}

} // namespace gallery
