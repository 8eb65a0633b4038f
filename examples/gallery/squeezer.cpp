// Andrews' squeezing mechanism: seven bodies, three loops, and a tenth of a second.
#include <kanexpr/simulate.hpp>
#include <models/andrews.hpp>
#include <parts/page.hpp>

namespace andrews {

struct Anchor : offset<Anchor, O, 0.014 * N::x + 0.072 * N::y> {};

template <class From, class To, class Colour>
using bar = show<rod<From, To, 0.0011>, Colour>;
template <class Point>
using pin = show<cylinder<N, Point, N::z, 0.0016, 0.006>, colour<"#8f979e">>;

using picture =
    kanexpr::picture<System, up<N::y>, seen_from<N::z + 0.15 * N::x + 0.15 * N::y>,
                     trace<E, colour<"#d98a2b">>, bar<O, F, colour<"#b5382f">>, bar<F, E, colour<"#3d6b99">>,
                     bar<B, E3, colour<"#5d8a4a">>, bar<B, D, colour<"#5d8a4a">>,
                     bar<D, E3, colour<"#5d8a4a">>, bar<G, E4, colour<"#7a5c99">>,
                     bar<A, G, colour<"#2f8a8a">>, bar<A, H, colour<"#2f8a8a">>,
                     bar<H, E6, colour<"#7a5c99">>, show<coil<D, Anchor, 0.0016, 12>, colour<"#7b8794">>,
                     pin<O>, pin<A>, pin<B>, pin<Anchor>, pin<F>, pin<E>, pin<G>, pin<H>>;

} // namespace andrews

int main(int count, char** words) {
  using namespace andrews;
  gallery::page page(
      count, words,
      {.title = "Andrews' squeezing mechanism",
       .kind = "Mechanisms",
       .see = "A motor turns the short crank, and six other bodies follow in three closed loops. The motion "
              "shown takes a "
              "twentieth of a second; it is a standard test of integrators for constrained systems.",
       .source = "Schiehlen (editor), Multibody Systems Handbook (1990); Hairer & Wanner, Solving Ordinary "
                 "Differential "
                 "Equations II (1996), section VII.7"});
  const auto run = simulate<System>(
      {{be, -0.0617138900142764496},
       {th, 0},
       {ga, 0.455279819163070380},
       {ph, 0.222668390165885884},
       {de, 0.487364979543842550},
       {om, -0.222668390165885884},
       {ep, 1.23054744454982119},
       {u1, 0},
       {u2, 0},
       {u3, 0},
       {u4, 0},
       {u5, 0},
       {u6, 0},
       {u7, 0}},
      {}, {0, 0.05}, {.guesses_dependent = true, .relative_tolerance = 1e-10, .output_every = 1e-4});
  page.expect_constraints(run.trajectory, 1e-9);
  // The reference of Hairer & Wanner at t = 0.03.
  const auto at = run.trajectory.at(0.03);
  page.expect(at.has_value(), "the motion reaches 0.03 s");
  if (at)
    page.expect_small("the crank's angle at 0.03 s is that of the literature",
                      std::abs(at->x[be] - 15.81077119629904), 1e-5);
  return page.show<andrews::picture>(run, {.lengths = false});
}
