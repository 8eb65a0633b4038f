// builds: clang++
// The form of u̇, chosen by the number of its operations. Operations are counted, not timed.
#include "mechanics/workbench.hpp"

#include <kanexpr/lower/tape.hpp>
#include <kanexpr/mechanics/dynamics/articulated_bodies.hpp>
#include <kanexpr/mechanics/dynamics/solution_cost.hpp>

#include <algorithm>

namespace {

using kanexpr::runtime::builder;
using kanexpr::symbolic::cost;
using workbench::mechanics::equations;
using workbench::mechanics::quantity;

enum class joints { in_plane, in_space };

// A chain of rods, each angle measured from the rod before.
struct chain : workbench::builder {
  explicit chain(int links, joints kind) : builder("N") {
    workbench::frame_id frame = inertial_frame();
    workbench::point_id hinge = origin("O");
    for (int i = 1; i <= links; ++i) {
      const std::string k = std::to_string(i);
      const workbench::expression q = coordinate("q" + k), u = speed("u" + k), l = parameter("l" + k);
      kinematic_equation(dot(q) - u);
      const bool about_x = kind == joints::in_space && i % 2 == 1;
      const workbench::frame_id rod = rotated("A" + k, frame, q, along(frame, about_x, 0, !about_x));
      rigid_body("B" + k, offset("C" + k, hinge, along(rod, 0, -l / 2, 0)), rod, parameter("m" + k),
                 inertia(rod, parameter("I" + k), parameter("J" + k), parameter("K" + k)));
      hinge = offset("P" + k, hinge, along(rod, 0, -l, 0));
      frame = rod;
    }
    gravity(along(inertial_frame(), 0, -9.81, 0));
  }
};

int operations_of(builder& b, const kanexpr::base::sequence<workbench::expression>& all) {
  const cost c =
      kanexpr::lower::cost_of(kanexpr::lower::tape_of(b.graph(), kanexpr::symbolic::nodes_of(all)));
  return c.multiplications + c.additions + c.divisions;
}

// The operations of u̇ in the chosen form and in both others.
struct counted_forms {
  int chosen = 0, by_elimination = 0, by_articulated_bodies = 0;

  counted_forms(int links, joints kind) {
    chain chosen_form(links, kind), both(links, kind);
    equations e(chosen_form.system()), other(both.system());
    chosen = operations_of(chosen_form, e.get(quantity::udot).entries);
    const auto mass = other.get(quantity::mass_matrix);
    const auto force = other.get(quantity::forcing).entries;
    by_elimination = operations_of(both, kanexpr::symbolic::solve_symmetric(both.graph(), mass, force).x);
    const cost predicted = kanexpr::mechanics::cost_by_elimination(mass, force);
    EXPECT_EQ(by_elimination, predicted.multiplications + predicted.additions + predicted.divisions);
    by_articulated_bodies =
        operations_of(both, kanexpr::mechanics::articulated_bodies(other.skeleton_used()).solve(force).x);
  }
};

TEST(formulation, of_every_chain_is_the_cheapest) {
  for (const joints kind : {joints::in_plane, joints::in_space})
    for (const int links : {2, 4, 6, 7, 8, 10, 11, 12, 14, 16, 24}) {
      const counted_forms all(links, kind);
      const int cheapest = std::min(all.by_elimination, all.by_articulated_bodies);
      // the choice also counts the entries of M to which a status compares the pivots
      EXPECT_LE(all.chosen, 1.09 * cheapest) << links << " links";
      EXPECT_LE(all.chosen, all.by_elimination) << links << " links";
    }
}

int operations_in(int links, joints kind, const kanexpr::symbolic::operation_weights& weights) {
  chain b(links, kind);
  b.weighted_by(weights);
  equations e(b.system());
  return operations_of(b, e.get(quantity::udot).entries);
}

// Elimination has more sums that can be evaluated together with a product, so it pays up to longer chains on
// a processor with such an operation.
TEST(formulation, depends_on_what_operations_cost) {
  int changed = 0;
  for (int links = 7; links <= 16; ++links)
    for (const joints kind : {joints::in_plane, joints::in_space}) {
      const counted_forms all(links, kind);
      const int fused = operations_in(links, kind, {.fused = 1});
      if (fused == all.chosen) continue;
      EXPECT_EQ(all.chosen, all.by_articulated_bodies) << links << " links";
      EXPECT_EQ(fused, all.by_elimination) << links << " links";
      ++changed;
    }
  EXPECT_GT(changed, 0);
}

TEST(formulation, takes_operations_in_proportion_to_the_length_of_a_chain) {
  const counted_forms plane_16(16, joints::in_plane), plane_32(32, joints::in_plane),
      space_16(16, joints::in_space), space_32(32, joints::in_space);
  EXPECT_LT(plane_32.chosen, 2.1 * plane_16.chosen);
  EXPECT_LT(space_32.chosen, 2.3 * space_16.chosen);
  EXPECT_LE(plane_32.chosen, 4500);
  EXPECT_GT(plane_32.by_elimination, 5 * plane_32.chosen);
}

} // namespace
