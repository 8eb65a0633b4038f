// Does a controller whose gains were computed for one bicycle keep others upright, of which mass and inertia
// of frame, rider and fork are up to a fifth more or less? Each is pushed to the side at some speed, and so
// is the bicycle that the controller knows.
#include <controllers/balanced_bicycle.hpp>
#include <kanexpr/ensemble.hpp>
#include <kanexpr/simulate/csv.hpp>
#include <kanexpr/simulate/progress.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace {

using namespace balanced_bicycle;

// What the bodies have beside that which the controller knows, in parts of it.
constexpr parameter<"frame_mass"> frame_mass;
constexpr parameter<"frame_inertia"> frame_inertia;
constexpr parameter<"fork_mass"> fork_mass;
constexpr parameter<"fork_inertia"> fork_inertia;
struct MoreFrame : rigid_body<MoreFrame, Frame_mc, Frame, frame_mass * mframe,
                              inertia<LevelFrame, frame_inertia * Iframe11, frame_inertia * Iframe22,
                                      frame_inertia * Iframe33, 0, 0, frame_inertia * Iframe31>> {};
struct MoreFork : rigid_body<MoreFork, Fork_mc, Fork, fork_mass * mfork,
                             inertia<LevelFork, fork_inertia * Ifork11, fork_inertia * Ifork22,
                                     fork_inertia * Ifork33, 0, 0, fork_inertia * Ifork31>> {};
struct Uncertain : extended<Driven, bodies<MoreFrame, MoreFork>> {};

// Below the slowest speed of the controller's table it goes on with the gains of that.
constexpr double crawl = 1, hardest = 4, fallen = 1, last = 10; // m/s, rad/s, rad, s
const std::vector<named_value> as_known{
    {frame_mass, 0}, {frame_inertia, 0}, {fork_mass, 0}, {fork_inertia, 0}};

runs uncertain(std::size_t count) {
  const distribution part = uniform(-0.2, 0.2);
  return latin_hypercube(count,
                         {{u3, uniform(crawl / rear_radius, fastest / rear_radius)},
                          {u2, uniform(0, hardest)},
                          {frame_mass, part},
                          {frame_inertia, part},
                          {fork_mass, part},
                          {fork_inertia, part}},
                         2007);
}

// The same speeds and pushes.
runs known(const table& of) {
  table both;
  for (const char* name : {"u3", "u2"})
    if (!both.add(name, {of[name].begin(), of[name].end()})) std::abort();
  return runs_of(both);
}

ensemble_results push(const runs& all, const std::vector<named_value>& parameters) {
  // The torques are those of each instant, not held for a period as on a board.
  const auto keep_speed = [](const run_values& run, simulation_options<Uncertain>& options) {
    options.inputs = [v = rear_radius * run[u3]](double, const state<Uncertain>& x) {
      const input_values<Driven> r = torques<double>(state<Driven>(x), v);
      return input_values<Uncertain>{{T, r[T]}, {D, r[D]}};
    };
  };
  return ensemble<Uncertain, integrator::explicit_runge_kutta>(
             {.runs = all,
              .state = {{q1, 0}, {q2, 0}, {q5, 0}, {u5, 0}},
              .parameters = parameters,
              .span = {0, last},
              .simulation = {.relative_tolerance = 1e-6,
                             .events = {when<Uncertain, q2 * q2 - fallen * fallen>("fall", crossing::rising,
                                                                                   after_event::stop)}},
              .for_each_run = keep_speed})
      .run({.progress = progress_bar()});
}

} // namespace

// uncertain_bicycle [BICYCLES [FILE]]: shares of those that stay up, by speed and push, go to a file.
int main(int count, char** words) {
  const auto others = push(uncertain(count > 1 ? std::strtoul(words[1], nullptr, 10) : 200), {});
  if (!others) return std::fprintf(stderr, "%s\n", others.cause().c_str()), 1;
  const auto as_told = push(known(others.runs), as_known);
  if (!as_told) return std::fprintf(stderr, "%s\n", as_told.cause().c_str()), 1;
  std::printf("of %zu and %zu bicycles %zu and %zu could not be followed to the end\n", others.done,
              as_told.done, others.failed, as_told.failed);

  constexpr std::size_t bins = 20;
  const histogram speeds(crawl, fastest, bins), pushes(0, hardest, bins);
  std::vector<double> all(bins * bins), up(bins * bins), up_as_told(bins * bins);
  std::size_t both = 0, told_alone = 0, other_alone = 0;
  for (std::size_t i = 0; i < others.done; ++i) {
    const auto bin = [](double part) { return std::min(static_cast<std::size_t>(part * bins), bins - 1); };
    const double v = rear_radius * others.runs["u3"][i];
    const std::size_t at = bin((v - crawl) / (fastest - crawl)) * bins + bin(others.runs["u2"][i] / hardest);
    const bool is_up = others.runs["end"][i] < 1, is_told_up = as_told.runs["end"][i] < 1;
    ++all[at], up[at] += is_up, up_as_told[at] += is_told_up;
    both += is_up && is_told_up, told_alone += !is_up && is_told_up, other_alone += is_up && !is_told_up;
  }
  const auto percent = [&](std::size_t some) {
    return 100 * static_cast<double>(some) / static_cast<double>(others.done);
  };
  std::printf("of all pushes %.1f %% leave both upright, %.1f %% only the bicycle that the controller knows, "
              "%.1f %% only the other\n",
              percent(both), percent(told_alone), percent(other_alone));

  if (count < 3) return 0;
  std::vector<double> v, strength, share, border; // the border of the bicycle that the controller knows
  for (std::size_t i = 0; i < bins; ++i) {
    const auto from = static_cast<std::ptrdiff_t>(i * bins), to = from + static_cast<std::ptrdiff_t>(bins);
    const double here = std::accumulate(all.begin() + from, all.begin() + to, 0.0);
    const double told_here = std::accumulate(up_as_told.begin() + from, up_as_told.begin() + to, 0.0);
    for (std::size_t k = 0; k < bins; ++k) {
      v.push_back((speeds.edge(i) + speeds.edge(i + 1)) / 2);
      strength.push_back((pushes.edge(k) + pushes.edge(k + 1)) / 2);
      share.push_back(up[i * bins + k] / all[i * bins + k]);
      border.push_back(hardest * told_here / here);
    }
  }
  table shares;
  if (!shares.add("v", v) || !shares.add("push", strength) || !shares.add("share", share) ||
      !shares.add("border", border))
    return 1;
  if (const outcome left = write_csv(shares, words[2]); !left)
    return std::fprintf(stderr, "%s\n", left.cause().c_str()), 1;
}
