// A fast top is released with its axis at rest: it falls a little, rises again, and precesses.
#include "output.hpp"

#include <kanexpr/simulate.hpp>
#include <pictures/spinning_top.hpp>

#include <cstdio>
#include <vector>

int main(int count, char** words) {
  using namespace spinning_top;
  const output files("A spinning top", "Its axis was at rest when it was let go.", count, words);

  // The nutation speed u1 crosses zero, falling, when the top leans most.
  std::vector<double> most;
  const auto keep = [&](moment<System>& now) { most.push_back(now.x[q2]); };
  const auto run = simulate<System>({{q1, 0}, {q2, 0.5}, {q3, 0}, {u1, 0}, {u2, 0}, {u3, 180}},
                                    {{m, 0.4}, {l, 0.08}, {g, 9.81}, {A, 6e-4}, {C, 6e-4}}, {0, 3},
                                    {.relative_tolerance = 1e-12,
                                     .absolute_tolerance = 1e-13,
                                     .output_every = 0.002,
                                     .events = {when<System, u1>("leans most", crossing::falling, keep)}});
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;

  if (most.empty()) return 1;
  std::printf("it leans most with %.9f rad first, and %.9f rad %zu nutations later\n", most.front(),
              most.back(), most.size() - 1);
  const auto energy = run.trajectory.energies().total;
  std::printf("energy %.9f J at first, %.9f J in the end\n", energy.front(), energy.back());
  return files.leave<spinning_top::picture>(run.trajectory) ? 0 : 1;
}
