// A ball that is thrown with backspin bounces, comes back and rolls to rest.
#include <kanexpr/simulate.hpp>
#include <models/bouncing_ball.hpp>
#include <parts/page.hpp>

namespace bouncing_ball {

struct Left : offset<Left, O, -0.8 * N::x> {};
struct Right : offset<Right, O, 1.6 * N::x> {};
struct Mark : offset<Mark, C, 0.6 * r * B::z> {};

using picture =
    kanexpr::picture<System, up<N::z>, seen_from<-N::y>, trace<C, colour<"#9fb4c8">>,
                     show<rod<Left, Right, 0.02 * r>, colour<"#8f979e">>,
                     show<sphere<C, r>, colour<"#b5382f">>, show<sphere<Mark, 0.45 * r>, colour<"#f2e6c8">>>;

} // namespace bouncing_ball

int main(int count, char** words) {
  using namespace bouncing_ball;
  gallery::page page(
      count, words,
      {.title = "Bouncing ball",
       .kind = "Rolling",
       .see = "The ball is thrown to the right with backspin. At the first bounces, friction reverses its "
              "direction; it comes back, bounces lower and lower, and rolls to rest.",
       .source = "Hunt & Crossley, Coefficient of restitution interpreted as damping in vibroimpact, "
                 "Journal of Applied Mechanics 42 (1975), pages 440-445"});
  const auto run = simulate<System>(
      {{x, 0}, {z, 1}, {q, 0}, {vx, 2}, {vz, 0}, {w, -75}},
      {{m, 0.05}, {r, 0.1}, {k, 2e4}, {d, 1e-4}, {v, 4}, {mu, 0.4}, {b, 0.004}, {s, 0.05}, {g, 9.81}},
      {0, 12}, {.relative_tolerance = 1e-9, .output_every = 0.01});
  const auto energy = run.trajectory.energies().total;
  double most = 0;
  for (std::size_t i = 1; i < energy.size(); ++i) most = std::max(most, energy[i] - energy[i - 1]);
  page.expect(most < 1e-7 * energy.front(), "the energy never increases");
  double farthest = 0;
  for (const double at : run.trajectory[x]) farthest = std::max(farthest, at);
  std::printf("as far as %g m, then at %g m, with %g m/s\n", farthest, run.state[x], run.state[vx]);
  page.expect(run.state[x] < farthest - 0.2, "the ball comes back");
  page.expect(std::abs(run.state[vx]) < 0.01 && std::abs(run.state[z] - 0.1) < 1e-3,
              "the ball comes to rest");
  return page.show<bouncing_ball::picture>(run, {.at = 0.6});
}
