// What a study costs beside bare loops over the same runs, and what threads and lanes gain. All that is
// compared takes many brief turns, so that other programs disturb all of it; printed are medians and, after
// them, the quartiles. Times of one thread are those of the processor, which others hardly change.
//
// speed [RUNS [TURNS]]
#include "pendulums.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace {

using namespace pendulums;

struct taken {
  double wall = 0, processor = 0; // s
};

template <class Work>
taken time_of(const Work& work) {
  const auto processor = [] {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  const double before = processor();
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), processor() - before};
}

[[noreturn]] void give_up(const std::string& cause) {
  std::fprintf(stderr, "%s\n", cause.c_str());
  std::exit(1);
}

// The same numbers, whoever formed them, have the same sum.
using sum = double;

sum of_table(const ensemble_results& found) {
  if (!found || found.failed > 0) give_up(found.cause());
  sum all = 0;
  for (double angle : found.runs["q1_end"]) all += angle;
  return all;
}

state<System> start_of(const runs& all, std::size_t run) {
  const run_values given(all, run);
  return {{q1, given[q1]}, {q2, given[q2]}, {u1, 0}, {u2, 0}};
}

sum bare_simulations(std::size_t count, std::size_t first = 0, std::size_t stride = 1) {
  const runs all = starts(count);
  const given_parameters<System> p(bars);
  const simulation_options<System> options{.inputs = given_inputs<System>(without_motors),
                                           .relative_tolerance = tolerance,
                                           .output_times = {span.to}};
  sum found = 0;
  for (std::size_t i = first; i < count; i += stride) {
    const auto ended = simulate<System>(start_of(all, i), p, span, options);
    if (!ended) give_up(ended.cause());
    found += ended.state[q1];
  }
  return found;
}

sum bare_steps(std::size_t count) {
  const int steps = in_steps(1).steps;
  const runs all = starts(count);
  const parameter_values<System> p = given_parameters<System>(bars).values;
  const input_values<System> r(0, 0);
  sum found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    state<System> x = start_of(all, i);
    double t = 0;
    for (int k = 0; k < steps; ++k)
      if (const status s = runge_kutta_4<System>{}(t, x, step, p, r); !s) give_up(std::string(s.cause()));
    found += x[q1];
  }
  return found;
}

// As fast as two threads could be that know nothing of each other.
void in_two_processes(std::size_t count) {
  pid_t children[2];
  for (std::size_t i = 0; i < 2; ++i)
    if (children[i] = fork(); children[i] == 0) {
      bare_simulations(count, i, 2);
      _exit(0);
    }
  for (pid_t each : children) waitpid(each, nullptr, 0);
}

struct spread {
  std::vector<double> all{};
  void print(const char* what, const char* unit = "") {
    std::ranges::sort(all);
    std::printf("%s\t%.4g%s\t(%.4g to %.4g)\n", what, all[all.size() / 2], unit, all[all.size() / 4],
                all[all.size() * 3 / 4]);
    std::fflush(stdout);
  }
};

} // namespace

int main(int count, char** words) {
  const std::size_t runs = count > 1 ? std::strtoul(words[1], nullptr, 10) : 16;
  const int turns = count > 2 ? std::atoi(words[2]) : 301;
  const ensemble<System> study(in_full(runs));
  const ensemble_in_steps stepped(in_steps(runs));
  const ensemble_in_steps single(in_steps<float>(runs));

  double load[3];
  if (getloadavg(load, 3) == 3) std::printf("load of the machine before\t%.1f\n", load[0]);
  std::printf("%zu runs, %d turns\n", runs, turns);

  spread overhead, speedup, of_two_loops, rate, waste;
  spread lanes, single_lanes, scalar_rate, lane_rate, over_simulate;
  sum found[5]{};
  for (int turn = 0; turn < turns; ++turn) {
    const taken bare = time_of([&] { found[0] = bare_simulations(runs); });
    const taken one = time_of([&] { found[1] = of_table(study.run({.threads = 1})); });
    const taken two = time_of([&] { found[2] = of_table(study.run({.threads = 2})); });
    const taken loops = time_of([&] { in_two_processes(runs); });
    const taken scalar = time_of([&] { found[3] = bare_steps(runs); });
    const taken side_by_side = time_of([&] { found[4] = of_table(stepped.run({.threads = 1})); });
    const taken in_single = time_of([&] { of_table(single.run({.threads = 1})); });
    const auto number = static_cast<double>(runs);
    overhead.all.push_back(100 * (one.processor / bare.processor - 1));
    speedup.all.push_back(one.wall / two.wall);
    of_two_loops.all.push_back(loops.wall / two.wall);
    waste.all.push_back(100 * (two.processor / one.processor - 1));
    rate.all.push_back(number / one.processor);
    lanes.all.push_back(scalar.processor / side_by_side.processor);
    single_lanes.all.push_back(scalar.processor / in_single.processor);
    scalar_rate.all.push_back(number / scalar.processor);
    lane_rate.all.push_back(number / side_by_side.processor);
    over_simulate.all.push_back(one.processor / side_by_side.processor);
  }
  if (!numeric::equal(found[0], found[1]) || !numeric::equal(found[1], found[2]))
    give_up("a study and a bare loop differ");
  rate.print("simulations on one thread", " runs/s");
  overhead.print("a study over a bare loop of simulate", " %");
  speedup.print("two threads beside one, in time", " times");
  of_two_loops.print("two threads beside two processes with bare loops, in time", " times as fast");
  waste.print("two threads over one, of the processor's time", " %");
  std::printf("lanes\t%zu\n", batch<>::lanes);
  scalar_rate.print("fixed steps of 1 ms, one by one", " runs/s");
  lane_rate.print("fixed steps of 1 ms, side by side", " runs/s");
  lanes.print("side by side beside one by one", " times");
  single_lanes.print("the same of single precision", " times");
  over_simulate.print("side by side beside simulations", " times");
}
