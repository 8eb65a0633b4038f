// A fast top is let go with its axis at rest.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>
#include <pictures/spinning_top.hpp>

int main(int count, char** words) {
  using namespace spinning_top;
  gallery::page page(
      count, words,
      {.title = "Spinning top",
       .kind = "Gyroscopes",
       .see = "The axis falls a little, rises again and moves on: nutation and precession. The tip of the "
              "axis draws cusps, because the axis was at rest when it was let go.",
       .source = "Goldstein, Poole & Safko, Classical Mechanics, 3rd edition (2002), section 5.7"});
  const auto run = simulate<System>({{q1, 0}, {q2, 0.5}, {q3, 0}, {u1, 0}, {u2, 0}, {u3, 130}},
                                    {{m, 0.4}, {l, 0.08}, {g, 9.81}, {A, 3e-3}, {C, 6e-4}}, {0, 4},
                                    {.relative_tolerance = 1e-11, .output_every = 0.01});
  page.expect_energy(run.trajectory, 1e-8);
  const auto spin = run.trajectory[u3];
  page.expect_constant("the spin about the axis", spin, spin.front(), 1e-9);
  double most = 0.5;
  for (const double lean : run.trajectory[q2]) most = std::max(most, lean);
  page.expect(most > 0.55 && most < 1.5, "the axis nutates without touching the table");
  return page.show<spinning_top::picture>(run);
}
