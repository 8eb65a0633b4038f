// What a study costs beside a bare loop over the same runs, and what lanes gain: in many brief turns, all on
// one thread, by the time of the processor, which other programs hardly change.
//
// speed [RUNS [TURNS]]
#include "pendulums.hpp"

namespace {

using namespace pendulums;
using namespace timing;

sum bare_steps(std::size_t count) {
  const int steps = in_steps(1).span.steps;
  const runs all = starts(count);
  const parameter_values<System> p = given_parameters<System>(bars).values;
  const input_values<System> r(0, 0);
  sum found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    state<System> x = start_of(all, i);
    double t = 0;
    for (int k = 0; k < steps; ++k)
      if (const status s = runge_kutta_4<System>{}(t, x, step, p, r); !s) give_up(s.cause());
    found += x[q1];
  }
  return found;
}

} // namespace

int main(int count, char** words) {
  const std::size_t runs = count > 1 ? std::strtoul(words[1], nullptr, 10) : 16;
  const int turns = count > 2 ? std::atoi(words[2]) : 301;
  const ensemble<System> study(in_full(runs));
  const auto stepped = ensemble_in_steps(in_steps(runs));
  const auto single = ensemble_in_steps(in_steps<float>(runs));

  print_load();
  std::printf("%zu runs, %d turns\n", runs, turns);

  spread overhead, rate;
  spread lanes, single_lanes, scalar_rate, lane_rate, over_simulate;
  sum found[2]{};
  for (int turn = 0; turn < turns; ++turn) {
    const taken bare = time_of([&] { found[0] = bare_simulations(runs); });
    const taken one = time_of([&] { found[1] = of_table(study.run({.threads = 1})); });
    const taken scalar = time_of([&] { bare_steps(runs); });
    const taken side_by_side = time_of([&] { of_table(stepped.run({.threads = 1})); });
    const taken in_single = time_of([&] { of_table(single.run({.threads = 1})); });
    const auto number = static_cast<double>(runs);
    overhead.all.push_back(100 * (one.processor / bare.processor - 1));
    rate.all.push_back(number / one.processor);
    lanes.all.push_back(scalar.processor / side_by_side.processor);
    single_lanes.all.push_back(scalar.processor / in_single.processor);
    scalar_rate.all.push_back(number / scalar.processor);
    lane_rate.all.push_back(number / side_by_side.processor);
    over_simulate.all.push_back(one.processor / side_by_side.processor);
  }
  if (!kanexpr::base::equal(found[0], found[1])) give_up("a study and a bare loop differ");
  rate.print("simulations on one thread", " runs/s");
  overhead.print("a study over a bare loop of simulate", " %");
  std::printf("lanes\t%zu\n", batch<>::lanes);
  scalar_rate.print("fixed steps of 1 ms, one by one", " runs/s");
  lane_rate.print("fixed steps of 1 ms, side by side", " runs/s");
  lanes.print("side by side beside one by one", " times");
  single_lanes.print("the same of single precision", " times");
  over_simulate.print("side by side beside simulations", " times");
}
