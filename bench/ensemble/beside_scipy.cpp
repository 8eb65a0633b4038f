// What with_scipy.py compares: beside_scipy RUNS prints how many runs of 10 s are made in a second on two
// threads, and in a line for each of the first hundred its two angles at the start and after a second.
#include "pendulums.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

int main(int count, char** words) {
  using namespace pendulums;
  const std::size_t wanted = count > 1 ? std::strtoul(words[1], nullptr, 10) : 1000;
  const ensemble<System> study(in_full(wanted));
  const auto start = std::chrono::steady_clock::now();
  const auto found = study.run({.threads = 2});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;

  kanexpr::study<System> brief = in_full(100);
  brief.span.to = 1, brief.simulation.relative_tolerance = 1e-10;
  const auto early = ensemble<System>(brief).run();
  if (!found || !early || found.failed + early.failed > 0) return 1;
  std::printf("%.17g\n", static_cast<double>(wanted) / taken.count());
  const table& all = early.runs;
  for (std::size_t i = 0; i < all.rows(); ++i)
    std::printf("%.17g %.17g %.17g %.17g\n", all["q1"][i], all["q2"][i], all["q1_end"][i], all["q2_end"][i]);
}
