// A chain of rods, built at run time, and what its u̇ costs in each form of the equations.
#pragma once

#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/mechanics/dynamics/articulated_bodies.hpp>
#include <kanexpr/mechanics/dynamics/solution_cost.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <string>

namespace rod_chain {

using kanexpr::symbolic::expression;

enum class joints { in_plane, in_space };
enum class speeds { from_rod_before, from_ground };

// Each angle is measured from the rod before.
struct chain : kanexpr::runtime::builder {
  explicit chain(int links, joints kind, speeds measured = speeds::from_rod_before) : builder("N") {
    expression speed_before = number(0);
    for (int i = 1; i <= links; ++i) {
      const std::string k = std::to_string(i);
      const expression q = coordinate("q" + k), u = speed("u" + k), l = parameter("l" + k);
      kinematic_equation(dot(q) - (measured == speeds::from_rod_before ? u : u - speed_before));
      speed_before = u;
      const bool about_x = kind == joints::in_space && i % 2 == 1;
      const kanexpr::runtime::frame_id rod = rotated("A" + k, frame, q, along(frame, about_x, 0, !about_x));
      rigid_body("B" + k, offset("C" + k, hinge, along(rod, 0, -l / 2, 0)), rod, parameter("m" + k),
                 inertia(rod, parameter("I" + k), parameter("J" + k), parameter("K" + k)));
      hinge = offset("P" + k, hinge, along(rod, 0, -l, 0));
      frame = rod;
    }
    gravity(along(inertial_frame(), 0, -9.81, 0));
  }

  kanexpr::runtime::frame_id frame = inertial_frame(); // of the last rod
  kanexpr::runtime::point_id hinge = origin("O");      // at its end
};

inline int operations_in(const kanexpr::symbolic::cost& c) {
  return c.multiplications + c.additions + c.divisions;
}

inline int operations_of(kanexpr::runtime::builder& b, const kanexpr::base::sequence<expression>& all) {
  return operations_in(
      kanexpr::lower::cost_of(kanexpr::lower::tape_of(b.graph(), kanexpr::symbolic::nodes_of(all))));
}

// The operations of u̇ in the chosen form and in both others.
struct counted_forms {
  int chosen = 0, by_elimination = 0, predicted_by_elimination = 0, by_articulated_bodies = 0;

  counted_forms(int links, joints kind) {
    using kanexpr::mechanics::quantity;
    chain chosen_form(links, kind), both(links, kind);
    kanexpr::mechanics::equations e(chosen_form.system()), other(both.system());
    chosen = operations_of(chosen_form, e.get(quantity::udot).entries);
    const auto mass = other.get(quantity::mass_matrix);
    const auto force = other.get(quantity::forcing).entries;
    by_elimination = operations_of(both, kanexpr::symbolic::solve_symmetric(both.graph(), mass, force).x);
    predicted_by_elimination = operations_in(kanexpr::mechanics::cost_by_elimination(mass, force));
    by_articulated_bodies =
        operations_of(both, kanexpr::mechanics::articulated_bodies(other.skeleton_used()).solve(force).x);
  }
};

} // namespace rod_chain
