// F_r + F_r* of all speeds, compared with the multipliers and with the forces of the independent speeds.
#pragma once

#include "compiled/complex_steps.hpp"

namespace forces {

using Eigen::VectorXd;

// At random states, which need not satisfy the constraints: F_r + F_r* + Jᵀ λ = 0 in motion, and F_i + Aᵀ F_d
// = F̃_r + F̃_r* at arbitrary rates.
template <class System>
void balance_and_reduce(double reach = 1) {
  using eom = kanexpr::equations_of_motion<System>;
  constexpr auto motion =
      eom::together(eom::udot, eom::multipliers, eom::constraint_jacobian, eom::dependency);
  constexpr auto reduced = eom::together(eom::active_forces, eom::inertia_forces);
  const auto& is_dependent = kanexpr::linearization<System>::known.dependent;
  std::mt19937_64 source(9);
  int compared = 0;
  for (int tried = 0; compared < 100 && tried < 400; ++tried) {
    const step_checks::point<System> at =
        step_checks::random_point(source, step_checks::plain_point<System>(), reach);
    const auto [udot, lambda, J, A] = motion(at.t, at.x, at.p, at.r);
    if (!udot.status || !(udot.norm() < 1e3)) continue; // nearly singular
    const auto unreduced = [&](const VectorXd& rates) {
      no_heap::guard guard;
      return eom::unreduced_forces(at.t, at.x, at.p, at.r, rates);
    };
    const VectorXd held = J.transpose() * lambda;
    EXPECT_LE((unreduced(udot) + held).norm(), 1e-11 * held.norm());

    const VectorXd a = step_checks::random_numbers(source, udot.size(), 5);
    const VectorXd force = unreduced(a);
    const auto [active, inertia] = reduced(at.t, at.x, at.p, at.r, a);
    VectorXd independent(A.cols()), dependent(A.rows());
    Eigen::Index free = 0, bound = 0;
    for (int i = 0; i < force.size(); ++i)
      (is_dependent[eom::coordinates + i] ? dependent(bound++) : independent(free++)) = force(i);
    EXPECT_LE((independent + A.transpose() * dependent - active - inertia).norm(), 1e-11 * force.norm());
    ++compared;
  }
  EXPECT_EQ(compared, 100);
}

} // namespace forces
