#include <models/double_pendulum.hpp>

#include <kanexpr/simulate.hpp>

#include <cstdio>

int main() {
  using namespace double_pendulum;
  using namespace kanexpr;
  const auto run = simulate<System>({{q1, 0.1}, {q2, -0.2}, {u1, 0}, {u2, 0}},
                                    {{m1, 2},
                                     {m2, 1},
                                     {d1, 0.5},
                                     {d2, 0.4},
                                     {l1, 1},
                                     {I1, 0.2},
                                     {I2, 0.1},
                                     {g, 9.81},
                                     {c1, 0.1},
                                     {c2, 0.1}},
                                    {0, 10}, {.inputs = {{T1, 0}, {T2, 0}}, .output_every = 0.1});
  if (!run) return 1;
  std::printf("%.17g %.17g\n", run.state[q1], run.trajectory[q2].back());
}
