#pragma once

#include <kanexpr/ensemble.hpp>
#include <models/simple_pendulum.hpp>

#include <utility>
#include <vector>

namespace simple_pendulum {

// Without gravity and friction the angle is q + u t, and steps are long.
inline study<System> turning(std::vector<grid_axis> axes) {
  return {.runs = grid(std::move(axes)),
          .parameters = {{m, 1}, {l, 1}, {g, 0}, {c, 0}},
          .inputs = {{T, 0}},
          .span = {0, 20}};
}

} // namespace simple_pendulum
