// A stone that is spun the wrong way begins to rattle, stops, and spins back.
#include <kanexpr/simulate.hpp>
#include <models/rattleback.hpp>
#include <parts/page.hpp>

namespace rattleback {

struct Center : offset<Center, P, -lowest> {};

using picture = kanexpr::picture<System, up<N::z>, ground<>, carried<G>, seen_from<N::x - 1.5 * N::y + N::z>,
                                 show<ellipsoid<B, Center, a, b, c>, colour<"#6b7a55">>,
                                 show<sphere<G, 0.25 * c>, colour<"#d98a2b">>>;

} // namespace rattleback

int main(int count, char** words) {
  using namespace rattleback;
  gallery::page page(
      count, words,
      {.title = "Rattleback",
       .kind = "Rolling",
       .see = "The stone is spun against its preferred direction. It begins to rattle, which takes the "
              "energy of the spin, and then spins back, because its principal axes of inertia are not "
              "those of its surface.",
       .source = "Kane & Levinson, Realistic mathematical modeling of the rattleback, International "
                 "Journal of Non-Linear Mechanics 17 (1982), pages 175-186"});
  const auto run = simulate<System>({{q1, 0},
                                     {q2, 0.5 * std::numbers::pi / 180},
                                     {q3, 0.5 * std::numbers::pi / 180},
                                     {u1, 0},
                                     {u2, 0},
                                     {u3, -5}},
                                    {{a, 0.2},
                                     {b, 0.03},
                                     {c, 0.02},
                                     {h, 0.01},
                                     {m, 1},
                                     {Ixx, 2e-4},
                                     {Iyy, 1.6e-3},
                                     {Izz, 1.7e-3},
                                     {Ixy, -2e-5},
                                     {g, 9.81},
                                     {sigma, 0}},
                                    {0, 20}, {.relative_tolerance = 1e-10, .output_every = 0.01});
  page.expect_energy(run.trajectory, 1e-6);
  double back = 0;
  for (const double spin : run.trajectory[u3]) back = std::max(back, spin);
  page.expect(back > 1, "the stone reverses its spin");
  std::printf("spin %g to %g\n", -5.0, back);
  return page.show<rattleback::picture>(run);
}
