// A random mechanism with random constraints at a state that satisfies them, and its motion by the
// Newton-Euler equations with Lagrange multipliers, [M −Jᵀ; J 0] [u̇; λ] = [f; −γ].
#pragma once

#include "elimination.hpp"
#include "in_units.hpp"
#include "newton_euler_dynamics.hpp"
#include "random_constraints.hpp"
#include "random_mechanism.hpp"
#include "random_springs.hpp"

#include <kanexpr/base/sequence.hpp>

#include <algorithm>
#include <iterator>
#include <vector>

namespace recipe {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

inline VectorXd speeds_of(const mechanism& m) {
  return VectorXd::Map(m.u.data(), static_cast<Index>(m.u.size()));
}

// Orders constraints so that those of the configuration follow the others.
inline void move_configuration_constraints_to_the_end(std::vector<constraint>& bounds) {
  const auto of_configuration = [](const constraint& c) { return c.what == bound::configuration; };
  std::vector<constraint> last;
  std::ranges::copy_if(bounds, std::back_inserter(last), of_configuration);
  std::erase_if(bounds, of_configuration);
  bounds.insert(bounds.end(), last.begin(), last.end());
}

// The mechanism, its constraints, and a state that satisfies them.
struct constrained {
  mechanism m;
  std::vector<constraint> bounds;
  linear_constraints linear;
  newton_euler::dynamics free;
  VectorXd udot, multipliers;
  bool regular = false;

  // `in_any_units`: no sines of lengths.
  explicit constrained(unsigned seed, bool in_any_units = false) : m(generator(seed, false).run()) {
    if (m.u.size() < 2) return;
    if (in_any_units) without_sines_of_lengths(m);
    random_springs(m, seed).hang();
    if (in_any_units) without_sines_of_lengths(m);
    for (unsigned attempt = 0; attempt < 10 && !regular; ++attempt) {
      bounds = random_constraints(m, 1000 * seed + attempt).run();
      if (in_any_units)
        for (constraint& c : bounds) without_sines_of_lengths(m, c);
      move_configuration_constraints_to_the_end(bounds);
      linear = linearized(m, bounds);
      regular = is_regular(linear.jacobian);
    }
    if (!regular) return;
    const MatrixXd& j = linear.jacobian;
    const MatrixXd slip = elimination::product(j, speeds_of(m)) + linear.remainder;
    const MatrixXd nearest = elimination::solve(elimination::product(j, elimination::transposed(j)), slip)
                                 .x; // the least change of the speeds
    for (std::size_t i = 0; i < m.u.size(); ++i)
      for (Index r = 0; r < j.rows(); ++r) m.u[i] -= j(r, static_cast<Index>(i)) * nearest(r, 0);
    linear = linearized(m, bounds);
    free = newton_euler::evaluate(m);
    solve();
  }

private:
  // Whether the directions of all constraints are clearly distinct.
  static bool is_regular(const MatrixXd& j) {
    return elimination::solve(j, MatrixXd::Zero(j.rows(), 1)).least_pivot > 0.02 * elimination::largest(j);
  }

  void solve() {
    const Index p = free.mass_matrix.rows(), rows = linear.jacobian.rows();
    MatrixXd all = MatrixXd::Zero(p + rows, p + rows), right(p + rows, 1);
    for (Index i = 0; i < p; ++i) {
      for (Index j = 0; j < p; ++j) all(i, j) = free.mass_matrix(i, j);
      for (Index r = 0; r < rows; ++r)
        all(i, p + r) = -linear.jacobian(r, i), all(p + r, i) = linear.jacobian(r, i);
      right(i) = free.forcing(i);
    }
    for (Index r = 0; r < rows; ++r) right(p + r) = -linear.bias(r);
    const elimination::solved s = elimination::solve(all, right);
    udot = s.x.topRows(p), multipliers = s.x.bottomRows(rows);
    regular = s.least_pivot > 1e-5 * elimination::largest(all);
  }
};

// Entries of a vector, columns of a matrix.
inline VectorXd entries_of(const VectorXd& v, const kanexpr::base::sequence<int>& which) {
  VectorXd some(which.size());
  for (int i = 0; i < which.size(); ++i) some(i) = v(which[i]);
  return some;
}
inline MatrixXd columns_of(const MatrixXd& a, const kanexpr::base::sequence<int>& which) {
  MatrixXd some(a.rows(), which.size());
  for (int i = 0; i < which.size(); ++i) some.col(i) = a.col(which[i]);
  return some;
}

} // namespace recipe
