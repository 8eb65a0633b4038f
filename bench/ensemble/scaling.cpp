// What all cores gain over one, and beside as many processes that know nothing of each other: in turns, by
// the clock.
//
// scaling [RUNS [TURNS]]
#include "pendulums.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

using namespace pendulums;
using namespace timing;

void in_processes(std::size_t number, std::size_t count) {
  std::vector<pid_t> children(number);
  for (std::size_t i = 0; i < number; ++i)
    if (children[i] = fork(); children[i] == 0) {
      bare_simulations(count, i, number);
      _exit(0);
    }
  for (pid_t each : children) waitpid(each, nullptr, 0);
}

} // namespace

int main(int count, char** words) {
  const std::size_t runs = count > 1 ? std::strtoul(words[1], nullptr, 10) : 2000;
  const int turns = count > 2 ? std::atoi(words[2]) : 7;
  const unsigned cores = std::thread::hardware_concurrency();
  const ensemble<System> study(in_full(runs));

  print_load();
  std::printf("%zu runs, %d turns, %u cores\n", runs, turns, cores);
  spread one_rate, all_rate, gain, of_loops, waste, loops_gain;
  for (int turn = 0; turn < turns; ++turn) {
    sum found[2]{};
    const taken one = time_of([&] { found[0] = of_table(study.run({.threads = 1})); });
    const taken all = time_of([&] { found[1] = of_table(study.run({.threads = cores})); });
    const taken loops = time_of([&] { in_processes(cores, runs); });
    if (!kanexpr::base::equal(found[0], found[1])) give_up("the number of threads changes what is found");
    one_rate.all.push_back(static_cast<double>(runs) / one.wall);
    all_rate.all.push_back(static_cast<double>(runs) / all.wall);
    gain.all.push_back(one.wall / all.wall / cores);
    loops_gain.all.push_back(one.wall / loops.wall / cores);
    of_loops.all.push_back(loops.wall / all.wall);
    waste.all.push_back(100 * (all.processor / one.processor - 1));
  }
  one_rate.print("one thread", " runs/s");
  all_rate.print("a thread on each core", " runs/s");
  gain.print("of what is linear", "");
  loops_gain.print("the same of a process with a bare loop on each core", "");
  of_loops.print("threads beside these processes", " times as fast");
  waste.print("threads over one thread, of the processor's time", " %");
}
