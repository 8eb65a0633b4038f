#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace kanexpr::numeric {

/// Returns typical sizes of the entries of a state if nothing else is known about them: their magnitudes, but
/// no less than 1. If the constraints repeat after one turn of a coordinate, it is an angle, of size 1
/// regardless of the number of turns.
template <class Equations, class State = typename Equations::state>
State typical_magnitudes(const Equations& of, const State& x) {
  using number = typename State::Scalar;
  using rows_of_coordinates = Eigen::Matrix<number, Equations::fixed_rows_of_coordinates, 1>;
  using rows_of_speeds = Eigen::Matrix<number, Equations::fixed_rows_of_speeds, 1>;
  using by_coordinates =
      Eigen::Matrix<number, Equations::fixed_rows_of_coordinates, Equations::fixed_coordinates>;
  using by_speeds = Eigen::Matrix<number, Equations::fixed_rows_of_speeds, Equations::fixed_speeds>;
  struct rows {
    by_coordinates by_q;
    by_speeds by_u;
    number distance(const rows& other) const {
      return (by_q - other.by_q).norm() + (by_u - other.by_u).norm();
    }
  };
  const auto rows_at = [&](int i, number ahead) {
    State there = x;
    there(i) += ahead;
    rows found{by_coordinates::Zero(of.rows_of_coordinates(), of.coordinates()),
               by_speeds::Zero(of.rows_of_speeds(), of.speeds())};
    rows_of_coordinates left_q = rows_of_coordinates::Zero(of.rows_of_coordinates());
    rows_of_speeds left_u = rows_of_speeds::Zero(of.rows_of_speeds());
    of.configuration(there, left_q, found.by_q);
    of.velocities(there, left_u, found.by_u);
    return found;
  };
  const number turn = number(6.283185307179586), rounding = std::sqrt(std::numeric_limits<number>::epsilon());
  State sizes = x.cwiseAbs().cwiseMax(number(1));
  for (int i = 0; i < of.coordinates(); ++i) {
    if (!(sizes(i) > turn / 2)) continue;
    const rows here = rows_at(i, 0);
    const number change = here.distance(rows_at(i, 1));
    if (here.distance(rows_at(i, turn)) < rounding * change) sizes(i) = 1;
  }
  return sizes;
}

} // namespace kanexpr::numeric
