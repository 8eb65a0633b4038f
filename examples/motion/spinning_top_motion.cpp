// A fast top that is let go with its axis at rest: it falls a little, rises again, and goes around.
#include "output.hpp"
#include "report.hpp"

#include <kanexpr/simulate.hpp>
#include <pictures/spinning_top.hpp>

#include <cmath>
#include <vector>

int main(int count, char** words) {
  using namespace spinning_top;
  const output files("A spinning top", "Its axis was at rest when it was let go.", count, words);
  const double mass = 0.4, length = 0.08, strength = 9.81, about = 6e-4, across = 6e-4;
  const double tilt = 0.5, spin = 180;

  // The speed of nutation u1 falls through zero where the top leans most.
  std::vector<double> most;
  const auto keep = [&](moment<System>& now) { most.push_back(now.x[q2]); };
  const auto run = simulate<System>({{q1, 0}, {q2, tilt}, {q3, 0}, {u1, 0}, {u2, 0}, {u3, spin}},
                                    {{m, mass}, {l, length}, {g, strength}, {A, across}, {C, about}}, {0, 3},
                                    {.relative_tolerance = 1e-12,
                                     .absolute_tolerance = 1e-13,
                                     .output_every = 0.002,
                                     .events = {when<System, u1>("leans most", crossing::falling, keep)}});
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;

  // With y = cos θ₀ − cos θ of the greatest lean: y² + (p − 2 cos θ₀) y − sin² θ₀ = 0 (Goldstein, Classical
  // Mechanics, 5.7).
  report check("spinning_top_motion", 1e-9);
  const double about_tip = across + mass * length * length;
  const double p = std::pow(about * spin, 2) / (2 * about_tip * mass * strength * length);
  const double b = p / 2 - std::cos(tilt);
  const double greatest = std::acos(std::cos(tilt) + b - std::hypot(b, std::sin(tilt)));
  if (most.size() < 10) return 1;
  check("greatest lean of the first nutation", most.front(), greatest);
  check("and of the last", most.back(), greatest);
  const auto energy = run.trajectory.energies().total;
  check("energy", energy.back(), energy.front());
  return files.leave<spinning_top::picture>(run.trajectory) ? check.exit_code() : 1;
}
