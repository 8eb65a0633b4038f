// A study on the ranks that mpirun has started: a line of each rank with its time of the processor, and one
// of the first with the time by the clock.
//
// mpirun -n RANKS on_ranks [RUNS]
#include "pendulums.hpp"

#include <kanexpr/mpi.hpp>

#include <cstdio>
#include <cstdlib>

int main(int count, char** words) {
  using namespace pendulums;
  using namespace timing;
  mpi_ranks ranks(count, words);
  const std::size_t runs = count > 1 ? std::strtoul(words[1], nullptr, 10) : 3600;
  const ensemble<System> study(in_full(runs));
  bool is_complete = false;
  const taken time = time_of([&] {
    const ensemble_results found = study.run({}, ranks);
    is_complete = static_cast<bool>(found) || !ranks.is_first();
  });
  std::printf("processor\t%.2f s\n", time.processor);
  if (ranks.is_first()) std::printf("clock\t%.2f s\n", time.wall);
  return is_complete ? 0 : 1;
}
