// Does a controller whose gains were computed for one bicycle keep others upright, if the masses and inertias
// of frame, rider and fork differ by up to a fifth? Each bicycle is pushed to the side at some speed, and so
// is the nominal one.
#include <controllers/balanced_bicycle.hpp>
#include <kanexpr/ensemble.hpp>
#include <kanexpr/simulations/progress.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace {

using namespace balanced_bicycle;

// The nominal bicycle, with parameters for the masses and inertias of frame and fork.
struct Unloaded : whipple<values<WFrad == front_radius, WRrad == rear_radius, htangle == 1.2566370614359172,
                                 forkoffset == 0.03207142672761931, forklength == 0.26764450844768867,
                                 framelength == 0.9534570696121847, forkcg1 == 0.10230731158060875,
                                 forkcg3 == 0.026100592803432483, framecg1 == 0.4779288114646079,
                                 framecg3 == 0.4707271515135145, Iwr11 == 0.0603, Iwr22 == 0.12,
                                 Iwf11 == 0.1405, Iwf22 == 0.28, mwf == 3, mwr == 2, g == 9.81>> {};
struct Uncertain
    : extended<Unloaded, inputs<T, D>,
               loads<torque_between<Fork, Frame, T * Frame::x>, torque_between<WR, Frame, D * Frame::y>>> {};
const factor frame_mass{"frame_mass"}, frame_inertia{"frame_inertia"}, fork_mass{"fork_mass"},
    fork_inertia{"fork_inertia"}; // relative to the nominal bicycle

// Below the slowest speed in its table, the controller uses the gains for that speed.
constexpr double crawl = 1, hardest = 4, fallen = 1, last = 10; // m/s, rad/s, rad, s
runs uncertain(std::size_t count) {
  const distribution part = uniform(0.8, 1.2);
  return latin_hypercube(count,
                         {{u3, uniform(crawl / rear_radius, fastest / rear_radius)},
                          {u2, uniform(0, hardest)},
                          {frame_mass, part},
                          {frame_inertia, part},
                          {fork_mass, part},
                          {fork_inertia, part}},
                         2007);
}

// The same speeds and pushes, for the nominal bicycle.
runs known(const table& of) {
  table all;
  for (const char* name : {"u3", "u2"})
    if (!all.add(name, {of[name].begin(), of[name].end()})) std::abort();
  const std::vector<factor> parts{frame_mass, frame_inertia, fork_mass, fork_inertia};
  for (const factor& each : parts)
    if (!all.add(each.name, std::vector<double>(of.rows(), 1.0))) std::abort();
  return runs_of(all, parts);
}

ensemble_results push(const runs& all) {
  // The torques change continuously; they are not held for a period as on a microcontroller.
  const auto set_up = [](const run_values& run, simulation_setup<Uncertain>& one) {
    const double frame = run[frame_inertia], fork = run[fork_inertia];
    one.p[mframe] = 85 * run[frame_mass], one.p[mfork] = 4 * run[fork_mass];
    one.p[Iframe11] = 9.2 * frame, one.p[Iframe22] = 11 * frame, one.p[Iframe33] = 2.8 * frame;
    one.p[Iframe31] = -2.4 * frame;
    one.p[Ifork11] = 0.05892 * fork, one.p[Ifork22] = 0.06 * fork, one.p[Ifork33] = 0.00708 * fork;
    one.p[Ifork31] = 0.00756 * fork;
    one.options.inputs = [v = rear_radius * run[u3]](double, const state<Uncertain>& x) {
      const input_values<Driven> r = torques<double>(state<Driven>(x), v);
      return input_values<Uncertain>{{T, r[T]}, {D, r[D]}};
    };
  };
  return ensemble<Uncertain, integrator::explicit_runge_kutta>(
             {.runs = all,
              .state = {{q1, 0}, {q2, 0}, {q5, 0}, {u5, 0}},
              .span = {0, last},
              .simulation = {.relative_tolerance = 1e-6,
                             .events = {when<Uncertain, q2 * q2 - fallen * fallen>("fall", crossing::rising,
                                                                                   after_event::stop)}},
              .for_each_run = set_up})
      .run({.progress = progress_bar()});
}

} // namespace

// uncertain_bicycle [BICYCLES [FILE]]: writes the fractions that stay upright, by speed and push, to a file.
int main(int count, char** words) {
  const auto others = push(uncertain(count > 1 ? std::strtoul(words[1], nullptr, 10) : 200));
  if (!others) return std::fprintf(stderr, "%s\n", others.cause().c_str()), 1;
  const auto as_told = push(known(others.runs));
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
  std::vector<double> v, strength, share, border; // the stability limit of the nominal bicycle
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
