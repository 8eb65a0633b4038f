// A rod with a bob swings without friction, almost from the upright position.
#include <kanexpr/simulate.hpp>
#include <models/simple_pendulum.hpp>
#include <parts/page.hpp>

namespace simple_pendulum {

using picture = kanexpr::picture<System, up<-N::x>, seen_from<N::z + 0.3 * N::y - 0.2 * N::x>, trace<P>,
                                 show<cylinder<N, O, N::z, 0.05 * l, 0.2 * l>, colour<"#8f979e">>,
                                 show<rod<O, P, 0.02 * l>, colour<"#3d6b99">>,
                                 show<sphere<P, 0.09 * l>, colour<"#b5382f">>>;

} // namespace simple_pendulum

int main(int count, char** words) {
  using namespace simple_pendulum;
  gallery::page page(
      count, words,
      {.title = "Pendulum",
       .kind = "Pendulums",
       .see = "The pendulum is released 10 degrees from the upright position and lingers there at both "
              "ends of its swing. Its period is 2.4 times that of small oscillations.",
       .source = "Goldstein, Poole & Safko, Classical Mechanics, 3rd edition (2002), section 6.1"});
  const double from = 170 * std::numbers::pi / 180;
  const auto run = simulate<System>({{q, from}, {u, 0}}, {{m, 1}, {l, 1}, {g, 9.81}, {c, 0}}, {0, 10},
                                    {.inputs = {{T, 0}},
                                     .relative_tolerance = 1e-11,
                                     .output_every = 0.02,
                                     .events = {when<System, u>("turns back", crossing::rising)}});
  page.expect_energy(run.trajectory, 1e-8);
  // The period is 4 K(sin(from/2)) sqrt(l/g).
  const double period = 4 * std::comp_ellint_1(std::sin(from / 2)) / std::sqrt(9.81);
  page.expect(!run.events.empty(), "the pendulum swings back");
  if (!run.events.empty())
    page.expect_small("the period is that of the elliptic integral, " + page.rounded(period) + " s",
                      std::abs(2 * run.events.front().t - period), 1e-6);
  return page.show<simple_pendulum::picture>(run, {.at = 0.9});
}
