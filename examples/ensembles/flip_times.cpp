// When does a double pendulum without friction flip over if it is released from rest at a given pair of
// angles? Neighboring pairs give very different times: the picture is a fractal. Runs end at an event; some
// of them are compared with steps of a fixed length.
#include <kanexpr/ensemble.hpp>
#include <kanexpr/simulations/progress.hpp>
#include <kanexpr/simulations/tables/csv.hpp>
#include <models/double_pendulum.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace {

using namespace kanexpr;
using namespace double_pendulum;

constexpr double pi = std::numbers::pi;
constexpr double l = 1, m = 1, gravity = 9.81, J = m * l * l / 12; // m, kg, m/s², kg m²; the bars are uniform
const double longest = 100 * std::sqrt(l / gravity);               // s

constexpr auto theta1 = q1 + pi / 2; // zero when the bar hangs straight down
constexpr auto theta2 = theta1 + q2;

const std::vector<named_value> at_rest{{u1, 0}, {u2, 0}}, without_motors{{T1, 0}, {T2, 0}},
    bars{{m1, m}, {m2, m}, {d1, l / 2},  {d2, l / 2}, {l1, l},
         {I1, J}, {I2, J}, {g, gravity}, {c1, 0},     {c2, 0}};

// If the signs of both angles are reversed, the motion is mirrored, so the first angle can be positive.
runs pairs_of_angles(int rows) {
  const auto angle = [=](int place) { return pi * (2.0 * place + 1 - rows) / rows; };
  std::vector<double> first, second;
  for (int i = rows / 2; i < rows; ++i)
    for (int k = 0; k < rows; ++k) first.push_back(angle(i) - pi / 2), second.push_back(angle(k) - angle(i));
  table starts;
  if (!starts.add("q1", first) || !starts.add("q2", second)) std::abort();
  return runs_of(starts);
}

// A bar flips over when the cosine of half its angle crosses zero.
study<System> first_flips(int rows) {
  return {
      .runs = pairs_of_angles(rows),
      .state = at_rest,
      .parameters = bars,
      .inputs = without_motors,
      .span = {0, longest},
      .simulation = {.relative_tolerance = 1e-6,
                     .events = {when<System, cos(theta1 / 2)>("first", crossing::either, after_event::stop),
                                when<System, cos(theta2 / 2)>("second", crossing::either,
                                                              after_event::stop)}},
      .units = {{q1, "rad"}, {q2, "rad"}}};
}

// The greatest difference between the times of the first flips, up to some time, and those found by another
// method.
double apart(const table& found, double within) {
  std::vector<double> first, second, times;
  for (std::size_t i = 0; i < found.rows(); i += found.rows() / 200 + 1)
    if (found["end"][i] > 0 && found["t_end"][i] < within)
      first.push_back(found["q1"][i]), second.push_back(found["q2"][i]), times.push_back(found["t_end"][i]);
  table starts;
  if (!starts.add("q1", first) || !starts.add("q2", second)) std::abort();
  constexpr double step = 1e-3;
  const study_in_steps<runge_kutta_4<System>> told{
      .runs = runs_of(starts),
      .state = at_rest,
      .parameters = bars,
      .inputs = without_motors,
      .span = {.step = step, .steps = static_cast<int>(within / step)},
      .keep_trajectories = true};
  const auto again = ensemble_in_steps<runge_kutta_4<System>>(told).run();
  double most = again ? 0 : NAN;
  for (std::size_t i = 0; again && i < times.size(); ++i) {
    const table& path = again.trajectories[i];
    const auto a = path["q1"], b = path["q2"];
    std::size_t k = 0;
    const auto beyond = [&](std::size_t at) {
      return std::max(std::abs(a[at] + pi / 2), std::abs(a[at] + pi / 2 + b[at])) - pi;
    };
    while (k + 1 < path.rows() && beyond(k) < 0) ++k;
    const double since = beyond(k) / (beyond(k) - beyond(k - 1)); // in steps, if the motion is uniform
    most = std::max(most, std::abs(path["t"][k] - since * step - times[i]));
  }
  std::printf("%zu flips within %g s, in steps: %.1g s apart at most\n", times.size(), within, most);
  return most;
}

} // namespace

// flip_times [ROWS [FILE]]: computes a picture with this number of rows and writes its points to a file.
int main(int count, char** words) {
  const ensemble<System, integrator::explicit_runge_kutta> pendulums(
      first_flips(count > 1 ? std::atoi(words[1]) : 60));
  const auto found = pendulums.run({.reduce = {counts_of("end")}, .progress = progress_bar()});
  if (!found) return std::fprintf(stderr, "%s\n", found.cause().c_str()), 1;
  const std::uint64_t flipped = found.counts("end").count(1);
  std::printf("of %zu pendulums %zu flip over within %.1f s, %zu fail\n", found.done, std::size_t(flipped),
              longest, found.failed);

  // The energy of an upright bar: 3 cos(theta1) + cos(theta2) = 2.
  std::size_t without_energy = 0;
  for (std::size_t i = 0; i < found.done; ++i) {
    const double first = found.runs["q1"][i] + pi / 2, second = first + found.runs["q2"][i];
    without_energy += found.runs["end"][i] > 0 && 3 * std::cos(first) + std::cos(second) > 2;
  }
  std::printf("%zu of them lack the energy for that\n", without_energy);
  const bool agree = apart(found.runs, 3) < 1e-4;

  if (count > 2)
    if (const outcome left = write_csv(found.runs, words[2], {.with_units = false}); !left)
      return std::fprintf(stderr, "%s\n", left.cause().c_str()), 1;
  return without_energy == 0 && agree ? 0 : 1;
}
