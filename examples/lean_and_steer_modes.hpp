#pragma once

#include <Eigen/Eigenvalues>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <cstdint>
#include <functional>
#include <tuple>

/// The modes of a bicycle near upright and straight ahead.
namespace bicycle {

/// The eigenvalues, in 1/s. In the weave mode the bicycle swings from side to side; below 0.7 m/s the mode
/// splits into two real ones, and the bicycle simply falls. In the capsize mode it slowly falls to one side,
/// and in the castering mode the front wheel turns into its track.
struct modes {
  std::complex<double> weave[2];
  double capsize, castering;
};

/// The modes of ẋ = A x with the state lean, steer and their rates. Oscillating modes come first, then those
/// that grow faster.
inline modes modes_of(const Eigen::Matrix4d& A) {
  const Eigen::Vector4cd found = A.eigenvalues();
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

} // namespace bicycle
