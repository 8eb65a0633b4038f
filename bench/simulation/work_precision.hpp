#pragma once

#include "motions.hpp"
#include "reference.hpp"

#include <kanexpr/assemble.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

/// What each method takes for the accuracy that it reaches: for each method a block of lines with the
/// relative tolerance, evaluations, and the error of the coordinates at the end, geometric means over some
/// starts. work_precision.gp draws them.
namespace work_precision {

using namespace kanexpr;

/// One start, and where it leads.
template <class Motion>
struct way {
  state<typename Motion::System> start, end;
};

template <class Motion>
std::vector<way<Motion>> ways(int starts, int reference_steps) {
  using System = typename Motion::System;
  std::vector<way<Motion>> all;
  for (int i = 0; i < starts; ++i) {
    way<Motion> w;
    w.start = Motion::start(0.01 * i);
    input_values<System> r;
    r.setZero();
    Motion::give_inputs(0, w.start, r);
    if (!assemble<System>(w.start, Motion::parameters(), r)) std::exit(1);
    w.end = reference::end_of<Motion>(w.start, reference_steps);
    all.push_back(w);
  }
  return all;
}

template <class Motion, integrator by>
void measure(const char* motion, const char* method, const std::vector<way<Motion>>& ways) {
  using System = typename Motion::System;
  std::printf("# %s, %s\n", motion, method);
  for (double tolerance = 1e-4; tolerance > 5e-14; tolerance /= std::sqrt(10.0)) {
    double error = 0, evaluations = 0;
    bool all = true;
    for (const way<Motion>& w : ways) {
      const auto run = simulate<System, by>(w.start, Motion::parameters(), Motion::span,
                                            {.inputs = Motion::give_inputs,
                                             .relative_tolerance = tolerance,
                                             .absolute_tolerance = tolerance,
                                             .output_times = {Motion::span.to},
                                             .most_steps = 1'000'000});
      all = all && run;
      error += std::log(std::max(1e-17, (run.state.q() - w.end.q()).cwiseAbs().maxCoeff()));
      evaluations += std::log(static_cast<double>(run.statistics.rate_evaluations));
    }
    const double starts = static_cast<double>(ways.size());
    if (all)
      std::printf("%.1e\t%.0f\t%.2e\n", tolerance, std::exp(evaluations / starts), std::exp(error / starts));
  }
  std::printf("\n\n");
}

template <class Motion>
void measure_all(const char* motion, int starts, int reference_steps) {
  const auto all = ways<Motion>(starts, reference_steps);
  measure<Motion, integrator::adams>(motion, "adams", all);
  measure<Motion, integrator::explicit_runge_kutta>(motion, "explicit_runge_kutta", all);
  measure<Motion, integrator::bdf>(motion, "bdf", all);
  measure<Motion, integrator::implicit_runge_kutta>(motion, "implicit_runge_kutta", all);
  measure<Motion, integrator::differential_algebraic>(motion, "differential_algebraic", all);
}

} // namespace work_precision
