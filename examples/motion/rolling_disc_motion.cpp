// A coin that leans rolls around in a circle. How fast it has to spin is found as an operating point; a whole
// turn later everything is as it was.
#include "output.hpp"
#include "report.hpp"

#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>
#include <pictures/rolling_disc.hpp>

#include <cmath>
#include <numbers>

int main(int count, char** words) {
  using namespace rolling_disc;
  const output files("A rolling disc", "It leans inwards and rolls around in a circle.", count, words);
  const double radius = 0.3, strength = 9.81, lean = 0.35, turning = 1.9;

  const kanexpr::operating_point<System> steady(
      {{q2, lean}, {u2, -7}, {u3, turning}}, {{r, radius}, {m, 2}, {g, strength}},
      {.held = {q1, q2, q3}, .changing = {q3}, .rates = {{dot(q1), turning}}});
  if (!steady) return std::fprintf(stderr, "%s\n", steady.cause().c_str()), 1;

  const double period = 2 * std::numbers::pi / turning;
  const auto run =
      simulate<System>(steady.x, steady.p, {0, period},
                       {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-13, .output_every = 0.01});
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;

  // The moments about the contact, along the ground and across the disc's path, are in balance.
  report check("rolling_disc_motion", 1e-8);
  const double about_lean = turning * std::cos(lean);
  const double spin = (about_lean * about_lean * std::tan(lean) / 4 - strength / radius * std::sin(lean)) /
                      (1.5 * about_lean);
  check("spin", steady.x[u2], spin);
  check("yaw after a turn", run.state[q1], 2 * std::numbers::pi);
  check("lean after a turn", run.state[q2], lean);
  check("spin after a turn", run.state[u2], spin);
  return files.leave<rolling_disc::picture>(run.trajectory) ? check.exit_code() : 1;
}
