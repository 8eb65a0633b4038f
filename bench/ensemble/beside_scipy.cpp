// What with_scipy.py compares: beside_scipy RUNS prints how many runs of 10 s are made in a second on two
// threads, by Adams' and by Dormand's and Prince's formulas, and in a line for each of the first hundred its
// two angles at the start and after a second.
#include "pendulums.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace pendulums;

template <integrator by>
void print_rate(std::size_t wanted) {
  const ensemble<System, by> study(in_full(wanted));
  const auto start = std::chrono::steady_clock::now();
  const auto found = study.run({.threads = 2});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (!found || found.failed > 0) std::exit(1);
  std::printf("%.17g ", static_cast<double>(wanted) / taken.count());
}

} // namespace

int main(int count, char** words) {
  const std::size_t wanted = count > 1 ? std::strtoul(words[1], nullptr, 10) : 1000;
  print_rate<integrator::adams>(wanted);
  print_rate<integrator::explicit_runge_kutta>(wanted);
  std::printf("\n");

  study<System> brief = in_full(100);
  brief.span.to = 1, brief.simulation.relative_tolerance = 1e-10;
  const auto early = ensemble<System>(brief).run();
  if (!early || early.failed > 0) return 1;
  const table& all = early.runs;
  for (std::size_t i = 0; i < all.rows(); ++i)
    std::printf("%.17g %.17g %.17g %.17g\n", all["q1"][i], all["q2"][i], all["q1_end"][i], all["q2_end"][i]);
}
