// What the exact Jacobian of the compiled linearization saves an implicit method over one by differences, in
// motions of 10 s that start a little apart: the mean numbers of steps, of the calls of ẋ within them and for
// differences, of Jacobians, and the time. As the least change of a number decides on the size of steps, a
// single motion tells little; but for the time, a program counts the same in each run.
#include "motions.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using kanexpr::integrator;

/// Sums over the motions.
struct work {
  long steps = 0, rates = 0, for_differences = 0, jacobians = 0;
  double milliseconds = 0;
  bool done = true;
};

template <class Motion, integrator by>
work simulate(int motions, bool exact) {
  using System = typename Motion::System;
  work all;
  for (int i = 0; i < motions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto run =
        kanexpr::simulate<System, by>(Motion::start(0.1 * i / motions), Motion::parameters(), Motion::span,
                                      {.inputs = Motion::give_inputs, .analytic_jacobian = exact});
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    all.milliseconds += taken.count();
    all.done &= static_cast<bool>(run);
    all.steps += run.statistics.steps;
    all.rates += run.statistics.rate_evaluations;
    all.jacobians += run.statistics.jacobian_evaluations;
  }
  if (!exact) all.for_differences = all.jacobians * kanexpr::state<System>::SizeAtCompileTime;
  return all;
}

void print(const char* name, const char* jacobian, int motions, const work& all) {
  const auto mean = [motions](auto sum) { return static_cast<double>(sum) / motions; };
  std::printf("%s\t%s\t%.1f\t%.1f\t%.1f\t%.1f\t%.3f\n", name, jacobian, mean(all.steps),
              mean(all.rates - all.for_differences), mean(all.for_differences), mean(all.jacobians),
              mean(all.milliseconds));
}

/// Prints two lines of the table; false: the exact Jacobian costs more calls than luck explains.
template <class Motion, integrator by>
bool compare(const char* name, int motions) {
  constexpr double luck = 1.02;
  const work exact = simulate<Motion, by>(motions, true), differences = simulate<Motion, by>(motions, false);
  print(name, "exact", motions, exact);
  print(name, "differences", motions, differences);
  return exact.done && differences.done &&
         static_cast<double>(exact.rates) < luck * static_cast<double>(differences.rates);
}

} // namespace

int main() {
  std::printf("motion\tJacobian\tsteps\tẋ in steps\tẋ for differences\tJacobians\tms\n");
  const bool saves[]{
      compare<motions::bicycle, integrator::bdf>("bicycle, BDF", 100),
      compare<motions::bicycle, integrator::implicit_runge_kutta>("bicycle, Kvaerno", 100),
      compare<motions::led_pendulum, integrator::bdf>("led pendulum, BDF", 1000),
      compare<motions::led_pendulum, integrator::implicit_runge_kutta>("led pendulum, Kvaerno", 100),
  };
  if (std::ranges::find(saves, false) == std::end(saves)) return 0;
  std::fprintf(stderr, "the exact Jacobian saves no calls\n");
  return 1;
}
