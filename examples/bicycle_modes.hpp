#pragma once

#include <kanexpr/steps/assemble.hpp>
#include <models/bicycle.hpp>

#include <Eigen/Eigenvalues>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <cstdint>
#include <functional>
#include <tuple>

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

/// The eigenvalues, in 1/s. In the weave mode the bicycle swings from side to side; below 0.7 m/s the mode
/// splits into two real ones, and the bicycle simply falls. In the capsize mode it slowly falls to one side,
/// and in the castering mode the front wheel turns into its track.
struct modes {
  std::complex<double> weave[2];
  double capsize, castering;
};

/// Oscillating modes come first, then those that grow faster.
inline modes modes_at(double v) {
  const Eigen::Vector4cd found = lean_and_steer(v).eigenvalues();
  std::array s{found(0), found(1), found(2), found(3)};
  const auto rank = [](std::complex<double> one) {
    return std::tuple(one.imag() != 0, one.real(), one.imag());
  };
  std::ranges::sort(s, std::greater{}, rank);
  return {{s[0], s[1]}, s[2].real(), s[3].real()};
}

/// The speed, up to 10 m/s, at which a mode neither grows nor decays.
template <class Growth>
double critical_speed(const Growth& growth) {
  using namespace boost::math::tools;
  std::uintmax_t most_steps = 100;
  const auto [below, above] = toms748_solve(growth, 0.0, 10.0, eps_tolerance<double>(), most_steps);
  return (below + above) / 2;
}
inline double weave_speed() {
  return critical_speed([](double v) { return modes_at(v).weave[0].real(); });
}
inline double capsize_speed() {
  return critical_speed([](double v) { return modes_at(v).capsize; });
}

} // namespace bicycle
