// The control loop of a two-bar arm, which runs a thousand times a second. In each cycle, the compiled
// equations give the torques for the desired accelerations, and a step of the same length advances the
// motion.
#include "output.hpp"

#include <kanexpr/fixed_step.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <pictures/double_pendulum.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace {

using namespace double_pendulum;
using eom = equations_of_motion<System>;

constexpr double stiffness = 25, damping = 10; // for the error: a double pole at −5/s
constexpr double period = 0.001;

// The desired motion of the arm.
struct wanted {
  Eigen::Vector2d angles, rates, accelerations;
};

wanted wanted_at(double t) {
  const double s = std::sin(2 * t), c = std::cos(2 * t);
  return {{-0.8 + 0.6 * s, 0.9 + 0.5 * c}, {1.2 * c, -1.0 * s}, {-2.4 * s, -2.0 * c}};
}

// The error e must satisfy ë + damping ė + stiffness e = 0. The torques are T1 − T2 on the upper bar and T2
// on the lower one, so that M u̇ = f + [T1 − T2, T2]; the speeds are u1 = q1' and u2 = q1' + q2'.
eom::inputs torques(double t, const eom::state& x, const eom::parameters& p) {
  const wanted w = wanted_at(t);
  const Eigen::Vector2d rates(x[u1], x[u2] - x[u1]);
  const Eigen::Vector2d a = w.accelerations + damping * (w.rates - rates) + stiffness * (w.angles - x.q());
  const auto [M, f] = eom::together(eom::mass_matrix, eom::forcing)(x, p, eom::inputs::Zero());
  const Eigen::Vector2d missing = M * Eigen::Vector2d(a(0), a(0) + a(1)) - f;
  eom::inputs r;
  r[T1] = missing(0) + missing(1);
  r[T2] = missing(1);
  return r;
}

Eigen::Vector2d error_of(const sample<System>& s) { return s.x.q() - wanted_at(s.t).angles; }

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

int main(int count, char** words) {
  const output files("An arm under control", "Each joint follows a curve that it did not start on.", count,
                     words);
  eom::parameters p;
  p << 1.1, 0.6, 0.4, 0.35, 0.9, 0.07, 0.02, 9.81, 0.03, 0.02;
  eom::state x;
  x[q1] = -1.6;
  x[q2] = 0.2;

  trajectory<System> path(p);
  double t = 0, longest = 0;
  while (t < 3) {
    const auto begin = std::chrono::steady_clock::now();
    const sample<System> now{t, x, torques(t, x, p)};
    if (const status s = runge_kutta_4<System>{}(t, x, period, p, now.r); !s)
      return std::fprintf(stderr, "%s\n", s.cause().c_str()), 1;
    longest = std::max(longest, seconds_since(begin));
    path.add(now);
  }

  std::printf("%zu periods of 1 ms; the work of the longest took %.1f µs\n", path.size(), 1e6 * longest);
  for (const std::size_t i : {0, 100, 300, 500, 1000}) {
    const Eigen::Vector2d error = error_of(path[i]);
    std::printf("after %.1f s: %9.6f and %9.6f rad off the curve\n", path[i].t, error(0), error(1));
  }
  return files.leave<double_pendulum::picture>(path) ? 0 : 1;
}
