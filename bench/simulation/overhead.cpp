// What `simulate` costs over a hand-written loop around CVODE that takes the same steps, with a sample each
// 0.01 s: the least times of both, which take turns, and the ratio.
#include "by_hand.hpp"
#include "motions.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using kanexpr::integrator;

constexpr double every = 0.01;
constexpr int turns = 201;

template <class Motion, integrator by>
auto by_simulate() {
  return kanexpr::simulate<typename Motion::System, by>(
      Motion::start(), Motion::parameters(), Motion::span,
      {.inputs = Motion::give_inputs, .output_every = every});
}

template <class Run>
double milliseconds(const Run& run) {
  const auto start = std::chrono::steady_clock::now();
  [[maybe_unused]] const auto result = run();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Prints a line of the table; false: the results are not the same.
template <class Motion, integrator by, int formulas,
          by_hand::samples kept = by_hand::samples::as_interpolated>
bool compare(const char* name) {
  const auto simulated = by_simulate<Motion, by>();
  const auto written = by_hand::run<Motion, formulas, kept>(every);
  double ours = 1e9, theirs = 1e9;
  for (int turn = 0; turn < turns; ++turn) {
    ours = std::min(ours, milliseconds(by_simulate<Motion, by>));
    theirs = std::min(theirs, milliseconds([] { return by_hand::run<Motion, formulas, kept>(every); }));
  }
  const auto& path = simulated.trajectory;
  double apart = path.size() == written.path.size() ? 0 : 1;
  for (std::size_t i = 0; i < path.size() && apart != 1; ++i)
    apart = std::max(apart, (path[i].x - written.path[i].x).cwiseAbs().maxCoeff());
  std::printf("%s\t%ld\t%.3f\t%.3f\t%.3f\t%.0e\n", name, written.steps, ours, theirs, ours / theirs, apart);
  return simulated.statistics.steps == written.steps && apart < 1e-7;
}

} // namespace

int main() {
  using by_hand::samples;
  std::printf("10 s\tsteps\tsimulate ms\tby hand ms\tratio\tdifference\n");
  const bool same[]{
      compare<motions::double_pendulum, integrator::adams, CV_ADAMS>("double pendulum, Adams"),
      compare<motions::bicycle, integrator::bdf, CV_BDF, samples::on_constraints>("bicycle, BDF"),
      compare<motions::bicycle, integrator::bdf, CV_BDF>(
          "bicycle, BDF, samples by hand not on the constraints"),
  };
  if (std::ranges::find(same, false) == std::end(same)) return 0;
  std::fprintf(stderr, "simulate and the loop do not take the same steps\n");
  return 1;
}
