// Which riderless bicycles stay upright after a push to the side? A map over the forward speed and the push,
// a rate of lean, computed from the nonlinear equations, with the critical speeds of the linearized ones.
#include <bicycle_modes.hpp>
#include <kanexpr/ensemble.hpp>
#include <kanexpr/simulations/progress.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace bicycle;

constexpr double rear_radius = 0.3, slowest = 2, fastest = 8, hardest = 1.2; // m, m/s, rad/s
constexpr double fallen = 0.8, last = 60, late = 50;                         // rad, s

// The greatest lean, during the last seconds, of a bicycle that stays upright.
double late_lean(const simulation<BoundSystem>& run) {
  double most = 0;
  for (const sample<BoundSystem>& each : run.trajectory)
    if (each.t >= late) most = std::max(most, std::abs(each.x[q2]));
  return most;
}

study<BoundSystem> pushes(std::size_t speeds, std::size_t strengths) {
  return {.runs = grid({{u3, evenly_spaced(slowest / rear_radius, fastest / rear_radius, speeds)},
                        {u2, evenly_spaced(hardest / double(strengths), hardest, strengths)}}),
          .state = {{q1, 0}, {q2, 0}, {q5, 0}, {u5, 0}},
          .span = {0, last},
          .simulation = {.relative_tolerance = 1e-7,
                         .output_every = 0.1,
                         .events = {when<BoundSystem, q2 * q2 - fallen * fallen>("fall", crossing::rising,
                                                                                 after_event::stop)}},
          .keep = {at_end<u3>("spin", "rad/s"), result("late_lean", late_lean, "rad")},
          .units = {{u3, "rad/s"}, {u2, "rad/s"}}};
}

} // namespace

// pushed_bicycle [SPEEDS [FILE]]: computes a map with this number of speeds and writes its points to FILE,
// the critical speeds to FILE.speeds.
int main(int count, char** words) {
  const std::size_t speeds = count > 1 ? std::strtoul(words[1], nullptr, 10) : 13;
  const auto found = ensemble<BoundSystem>(pushes(speeds, speeds * 2 / 3)).run({.progress = progress_bar()});
  if (!found) return std::fprintf(stderr, "%s\n", found.cause().c_str()), 1;

  const double weave = weave_speed(), capsize = capsize_speed();
  std::printf("linear: the weave grows below %.3f m/s, the capsize above %.3f m/s\n", weave, capsize);
  std::printf("%zu bicycles, of which %zu could not be followed to the end\n", found.done, found.failed);
  // For the weakest push
  const auto v = found.runs["u3"], push = found.runs["u2"], end = found.runs["end"];
  const auto leans = found.runs["late_lean"];
  double from = INFINITY, to = 0;
  for (std::size_t i = 0; i < found.done; ++i)
    if (push[i] < 1.5 * push[0] && end[i] < 1 && leans[i] < 0.01)
      from = std::min(from, v[i] * rear_radius), to = std::max(to, v[i] * rear_radius);
  std::printf("after a push of %.3f rad/s it is upright again from %.2f to %.2f m/s\n", push[0], from, to);

  if (count < 3) return 0;
  if (const outcome left = write_csv(found.runs, words[2], {.with_units = false}); !left)
    return std::fprintf(stderr, "%s\n", left.cause().c_str()), 1;
  table critical;
  if (!critical.add("weave", {weave}) || !critical.add("capsize", {capsize})) return 1;
  return write_csv(critical, std::string(words[2]) + ".speeds") ? 0 : 1;
}
