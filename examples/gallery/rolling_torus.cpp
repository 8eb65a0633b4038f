// A tire that was pushed rolls in a curve.
#include <kanexpr/simulate.hpp>
#include <models/rolling_torus.hpp>
#include <parts/page.hpp>

namespace rolling_torus {

using picture = kanexpr::picture<System, up<N::z>, ground<>, carried<G>, trace<C, colour<"#2f5d8a">>,
                                 show<wheel<B, G, B::y, R + a, 2 * a>, colour<"#8f979e">>>;

} // namespace rolling_torus

int main(int count, char** words) {
  using namespace rolling_torus;
  gallery::page page(
      count, words,
      {.title = "Rolling torus",
       .kind = "Rolling",
       .see =
           "A hoop with a thick round rim rolls like a disc, but the point of contact moves around the rim "
           "as it leans. It wobbles twice in each turn of its path.",
       .source = "Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th "
                 "edition (1905), chapter 5"});
  const auto run = simulate<System>({{q1, 0}, {q2, 0.3}, {q3, 0}, {u1, 0.6}, {u2, 7}, {u3, 0.8}},
                                    {{m, 4}, {R, 0.28}, {a, 0.05}, {g, 9.81}}, {0, 8},
                                    {.relative_tolerance = 1e-10, .output_every = 0.02});
  page.expect_energy(run.trajectory, 1e-7);
  double most = 0;
  for (const double lean : run.trajectory[q2]) most = std::max(most, std::abs(lean));
  page.expect(most < 1, "the torus never leans by more than a radian");
  return page.show<rolling_torus::picture>(run);
}
