// How long it takes to derive u̇ of a chain of four-bar loops while the program runs, and how large it is.
#include "mechanics/loop_chain.hpp"

#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/mechanics/equations.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

struct measured {
  double seconds = 0;
  int nodes = 0, operations = 0;
};

measured derive(int loops) {
  const auto start = std::chrono::steady_clock::now();
  loop_chain b(loops);
  kanexpr::mechanics::equations e(b.system());
  kanexpr::base::sequence<int> outputs;
  for (const auto& rate : e.get(kanexpr::mechanics::quantity::udot).entries) outputs.push(rate.node());
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  const kanexpr::symbolic::cost c = kanexpr::lower::cost_of(kanexpr::lower::tape_of(b.graph(), outputs));
  return {time.count(), b.graph().size(), c.multiplications + c.additions + c.divisions};
}

} // namespace

int main(int argc, char** argv) {
  const int most = argc > 1 ? std::atoi(argv[1]) : 64;
  std::printf("loops\tms\tx\tnodes\tx\toperations\tx\n");
  measured before;
  for (int loops = 1; loops <= most; loops *= 2) {
    measured now = derive(loops);
    for (int again = 0; again < 4; ++again) now.seconds = std::min(now.seconds, derive(loops).seconds);
    std::printf("%d\t%.2f\t%.1f\t%d\t%.1f\t%d\t%.1f\n", loops, 1e3 * now.seconds,
                loops > 1 ? now.seconds / before.seconds : 0, now.nodes,
                loops > 1 ? 1.0 * now.nodes / before.nodes : 0, now.operations,
                loops > 1 ? 1.0 * now.operations / before.operations : 0);
    before = now;
  }
}
