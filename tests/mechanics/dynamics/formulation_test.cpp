// builds: clang++
// The form of u̇, chosen by the number of its operations. Operations are counted, not timed.
#include "mechanics/rod_chain.hpp"
#include "mechanics/workbench.hpp"

#include <algorithm>
#include <string>

namespace {

using namespace rod_chain;
using workbench::mechanics::equations;
using workbench::mechanics::quantity;

TEST(formulation, of_every_chain_is_the_cheapest) {
  for (const joints kind : {joints::in_plane, joints::in_space})
    for (const int links : {2, 4, 6, 7, 8, 10, 11, 12, 14, 16, 24}) {
      const counted_forms all(links, kind);
      EXPECT_EQ(all.predicted_by_elimination, all.by_elimination) << links << " links";
      const int cheapest = std::min(all.by_elimination, all.by_articulated_bodies);
      // the choice also counts the entries of M to which a status compares the pivots
      EXPECT_LE(all.chosen, 1.09 * cheapest) << links << " links";
      EXPECT_LE(all.chosen, all.by_elimination) << links << " links";
    }
}

int weighted_operations(int links, joints kind, const kanexpr::symbolic::operation_weights& weights) {
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
      const int fused = weighted_operations(links, kind, {.fused = 1});
      if (fused == all.chosen) continue;
      EXPECT_EQ(all.chosen, all.by_articulated_bodies) << links << " links";
      EXPECT_EQ(fused, all.by_elimination) << links << " links";
      ++changed;
    }
  EXPECT_GT(changed, 0);
}

// The values of u̇ without M, by articulated bodies, are those by the elimination of M.
TEST(formulation, of_a_long_chain_needs_no_mass_matrix) {
  for (const joints kind : {joints::in_plane, joints::in_space})
    for (const speeds measured : {speeds::from_rod_before, speeds::from_ground}) {
      if (kind == joints::in_space && measured == speeds::from_ground) continue;
      chain b(32, kind, measured);
      if (measured == speeds::from_ground) b.by_articulated_bodies();
      equations e(b.system());
      kanexpr::symbolic::matrix both = e.get(quantity::udot);
      EXPECT_FALSE(e.mistake());
      const int before = b.graph().size();
      const kanexpr::base::sequence<workbench::expression> diagonal =
          kanexpr::mechanics::diagonal_of_mass_matrix(e.skeleton_used());
      const int with_diagonal = b.graph().size();
      EXPECT_EQ(with_diagonal, before); // a status compares pivots with it
      const kanexpr::symbolic::matrix mass = e.get(quantity::mass_matrix);
      EXPECT_GT(b.graph().size(), with_diagonal + 16 * 32);
      for (int i = 0; i < mass.rows; ++i) EXPECT_EQ(diagonal[i], mass(i, i)) << i;
      for (const workbench::expression& x :
           kanexpr::symbolic::solve_symmetric(b.graph(), mass, e.get(quantity::forcing).entries).x)
        both.entries.push(x);
      both.columns = 2;
      const Eigen::VectorXd all = numbers_of(both, [](const kanexpr::lower::load& l) {
                                    return 0.7 + 0.3 * ((l.position * 7 + static_cast<int>(l.from)) % 5);
                                  }).reshaped<Eigen::RowMajor>();
      const double scale = all.cwiseAbs().maxCoeff();
      EXPECT_LT((all.head(32) - all.tail(32)).cwiseAbs().maxCoeff(), 1e-11 * scale);
    }
}

std::string mistake_in(chain& b, const std::string& last) {
  equations e(b.system());
  e.get(quantity::udot);
  std::string found(e.mistake().view());
  if (const std::size_t at = found.find(last); at != std::string::npos)
    found.replace(at, last.size(), "last");
  return found;
}

// A rod more, without mass or with the axis of the one before.
TEST(formulation, does_not_change_what_is_said_of_singular_mass_matrices) {
  const auto massless = [](int links) {
    chain b(links, joints::in_plane);
    const std::string last = std::to_string(links + 1);
    const workbench::expression q = b.coordinate("q" + last), u = b.speed("u" + last);
    b.kinematic_equation(b.dot(q) - u);
    b.rotated("A" + last, b.frame, q, b.along(b.frame, 0, 0, 1));
    return mistake_in(b, "u" + last);
  };
  EXPECT_EQ(massless(24), massless(3));
  EXPECT_NE(massless(24).find("moves no mass"), std::string::npos) << massless(24);
  const auto same = [](int links) {
    chain b(links, joints::in_plane);
    const std::string last = std::to_string(links + 1);
    const workbench::expression q = b.coordinate("q" + last), u = b.speed("u" + last);
    b.kinematic_equation(b.dot(q) - u);
    const workbench::frame_id once = b.rotated("A" + last, b.frame, q, b.along(b.frame, 0, 0, 1));
    const workbench::expression r = b.coordinate("r"), v = b.speed("v");
    b.kinematic_equation(b.dot(r) - v);
    const workbench::frame_id twice = b.rotated("B" + last, once, r, b.along(once, 0, 0, 1));
    b.rigid_body("C", b.hinge, twice, b.parameter("m"),
                 b.inertia(twice, b.parameter("I"), b.parameter("J"), b.parameter("K")));
    return mistake_in(b, "u" + last);
  };
  EXPECT_EQ(same(24), same(3));
  EXPECT_NE(same(24).find("move the same mass"), std::string::npos) << same(24);
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
