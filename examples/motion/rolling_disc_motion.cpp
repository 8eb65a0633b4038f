// A leaning coin rolls in a circle. The required spin is found as an operating point; after one full turn,
// the state is the same as at the start.
#include "output.hpp"

#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>
#include <pictures/rolling_disc.hpp>

#include <cstdio>
#include <numbers>

int main(int count, char** words) {
  using namespace rolling_disc;
  const output files("A rolling disc", "It leans inwards and rolls around in a circle.", count, words);
  const double lean = 0.35, turning = 1.9;

  const kanexpr::operating_point<System> steady(
      {{q2, lean}, {u2, -7}, {u3, turning}}, {{r, 0.3}, {m, 2}, {g, 9.81}},
      {.held = {q1, q2, q3}, .changing = {q3}, .rates = {{dot(q1), turning}}});
  if (!steady) return std::fprintf(stderr, "%s\n", steady.cause().c_str()), 1;

  const double period = 2 * std::numbers::pi / turning;
  const auto run =
      simulate<System>(steady.x, steady.p, {0, period},
                       {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-13, .output_every = 0.01});
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;

  std::printf("it spins with %.6f rad/s\n", steady.x[u2]);
  std::printf("after a turn: yaw %.6f rad, lean %.6f rad, spin %.6f rad/s\n", run.state[q1], run.state[q2],
              run.state[u2]);
  return files.leave<rolling_disc::picture>(run.trajectory) ? 0 : 1;
}
