// A block that a spring pulls sticks and slips in turn.
#include <kanexpr/simulate.hpp>
#include <models/stick_slip.hpp>
#include <parts/page.hpp>

namespace stick_slip {

struct Floor : offset<Floor, N, 1.6 * N::x - 0.12 * N::z> {};
struct Ring : offset<Ring, Block, 0.15 * N::x> {};
struct Grip : offset<Grip, Hand, 0.1 * N::z> {};

using picture =
    kanexpr::picture<System, up<N::z>, seen_from<-N::y>, show<box<N, Floor, 5, 0.5, 0.04>, colour<"#8f979e">>,
                     show<box<N, Block, 0.3, 0.2, 0.2>, colour<"#b5382f">>,
                     show<coil<Ring, Hand, 0.05, 14>, colour<"#7b8794">>,
                     show<rod<Hand, Grip, 0.02>, colour<"#3d6b99">>,
                     show<sphere<Grip, 0.05>, colour<"#3d6b99">>>;

} // namespace stick_slip

int main(int count, char** words) {
  using namespace stick_slip;
  gallery::page page(
      count, words,
      {.title = "Stick-slip",
       .kind = "Mechanisms",
       .see = "The end of the spring moves with constant velocity. The block sticks until the spring pulls "
              "more than static friction can hold, slips, and sticks again.",
       .source = "Canudas de Wit, Olsson, Astrom & Lischinsky, A new model for control of systems with "
                 "friction, IEEE Transactions on Automatic Control 40 (1995), section III.C"});
  const auto run = simulate<System, integrator::bdf>(
      {{x, 0}, {v, 0}, {bristle, 0}},
      {{m, 1},
       {k, 2},
       {l, 0.6},
       {V, 0.1},
       {Fs, 1.5},
       {Fc, 1},
       {vs, 0.001},
       {sigma0, 1e5},
       {sigma1, 316.2},
       {sigma2, 0.4}},
      {0, 30}, {.relative_tolerance = 1e-8, .absolute_tolerance = 1e-10, .output_every = 0.02});
  double slips = 0, fastest = 0; // when the block first slips
  for (const auto& sample : run.trajectory) {
    if (slips <= 0 && sample.x[v] > 0.01) slips = sample.t;
    fastest = std::max(fastest, sample.x[v]);
  }
  std::printf("slips at %g s, up to %g m/s, and rests at %g m\n", slips, fastest, run.state[x]);
  page.expect(slips > 7.4 && slips < 7.6, "the block slips when the spring pulls with 1.5 N, at 7.5 s");
  page.expect(fastest > 0.3, "it slips faster than the end of the spring moves");
  page.expect(std::abs(run.state[v]) < 1e-3, "it sticks again");
  return page.show<stick_slip::picture>(run, {.at = 9});
}
