#pragma once

#include <kanexpr/export/wanted.hpp>

#include <array>
#include <vector>

namespace kanexpr::exporting {

/// A method of steps/methods.hpp by its numbers: a stage evaluates ẋ at t + c h and x + h a k, k that of the
/// stage before, and the step is h Σ b k; with one a and b for coordinates, and one for speeds.
struct step_tableau {
  struct stage {
    std::array<double, 2> a{}, b{};
    double c = 0;
  };
  const char* name = "";
  std::vector<stage> stages{};

  static step_tableau of(step_method method) {
    if (method == step_method::semi_implicit_euler)
      return {"semi-implicit Euler", {{{0, 0}, {0, 1}, 0}, {{0, 1}, {1, 0}, 0}}};
    constexpr double third = 1.0 / 3, sixth = 1.0 / 6;
    return {"the classic Runge-Kutta method",
            {{{0, 0}, {sixth, sixth}, 0},
             {{0.5, 0.5}, {third, third}, 0.5},
             {{0.5, 0.5}, {third, third}, 0.5},
             {{1, 1}, {sixth, sixth}, 1}}};
  }
};

} // namespace kanexpr::exporting
