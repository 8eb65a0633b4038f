#pragma once

#include "lean_and_steer_modes.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/bicycle.hpp>

#include <array>

/// The motion of the bicycle near upright straight riding, described by the eigenvalues of its linearized
/// equations.
namespace bicycle {

/// Upright, straight ahead at v m/s; the pitch and the spin of the front wheel follow from the constraints.
inline kanexpr::state<BoundSystem> straight_ahead(double v) {
  constexpr double rear_radius = 0.3;
  kanexpr::state<BoundSystem> x;
  x[u3] = v / rear_radius;
  kanexpr::assemble<BoundSystem>(x);
  return x;
}

/// A in ẋ = A x near that motion, for lean, steer and their rates. Nothing depends on the yaw, and the spins
/// of the wheels are constant.
inline Eigen::Matrix4d lean_and_steer(double v) {
  const auto [A, B] = kanexpr::linearization<BoundSystem>::explicit_form(straight_ahead(v));
  const std::array places{1, 2, 3, 5}; // among q1, q2, q5, u2, u3, u5
  return A(places, places);
}

inline modes modes_at(double v) { return modes_of(lean_and_steer(v)); }

inline double weave_speed() {
  return critical_speed([](double v) { return modes_at(v).weave[0].real(); });
}
inline double capsize_speed() {
  return critical_speed([](double v) { return modes_at(v).capsize; });
}

} // namespace bicycle
