// A bicycle that is pushed, beside what its linearized equations say of that.
#include "oracles.hpp"

#include <kanexpr/simulate.hpp>

#include <models/bicycle.hpp>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <array>
#include <complex>

namespace {

using namespace kanexpr;
using bicycle::BoundSystem;

constexpr double rear_radius = 0.3;

simulation<BoundSystem> pushed(double v, double push, double seconds) {
  using namespace bicycle;
  return simulate<BoundSystem>(
      {{q1, 0}, {q2, 0}, {q5, 0}, {u2, push}, {u3, v / rear_radius}, {u5, 0}}, {}, {0, seconds},
      {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-14, .output_every = 0.05});
}

// Lean, steer and their rates.
Eigen::Vector4cd small_motion(const state<BoundSystem>& x) {
  constexpr std::array places{1, 2, 4, 6};
  return x(places).cast<std::complex<double>>();
}

// Along a left eigenvector of A the motion is exp(λ t) alone: slow and fast ones, growing and dying out, as
// Meijaard, Papadopoulos, Ruina & Schwab (2007) have them.
TEST(bicycle, moves_in_the_modes_of_its_linearization) {
  const oracle::bicycle benchmark = oracle::load_bicycle();
  for (const int v : {3, 5, 7}) {
    const auto run = pushed(v, 1e-6, 3);
    ASSERT_TRUE(run) << run.cause();
    const Eigen::EigenSolver<Eigen::Matrix4d> modes(Eigen::Matrix4d(benchmark.A.at(v).transpose()));
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector4cd along = modes.eigenvectors().col(i);
      const std::complex<double> rate = modes.eigenvalues()(i);
      const auto amplitude = [&](const state<BoundSystem>& x) {
        return (along.transpose() * small_motion(x)).value();
      };
      const std::complex<double> start = amplitude(run.trajectory[0].x);
      for (const auto& s : run.trajectory)
        EXPECT_LT(std::abs(amplitude(s.x) - start * std::exp(rate * s.t)),
                  1e-6 * std::abs(start) * std::max(1.0, std::exp(rate.real() * s.t)))
            << v << ' ' << rate << ' ' << s.t;
    }
  }
}

double largest_lean(const simulation<BoundSystem>& run, double from, double to) {
  double largest = 0;
  for (const auto& s : run.trajectory)
    if (s.t >= from && s.t <= to) largest = std::max(largest, std::abs(s.x[bicycle::q2]));
  return largest;
}

TEST(bicycle, recovers_from_a_push_at_some_speeds_alone) {
  const auto stable = pushed(4.6, 0.1, 10), unstable = pushed(3.5, 0.1, 2);
  ASSERT_TRUE(stable) << stable.cause();
  ASSERT_TRUE(unstable) << unstable.cause();
  EXPECT_LT(largest_lean(stable, 8, 10), 0.1 * largest_lean(stable, 0, 2));
  EXPECT_GT(largest_lean(unstable, 1, 2), 1.5 * largest_lean(unstable, 0, 1));
  EXPECT_LT(std::ranges::max(stable.trajectory.constraint_residuals()), 1e-12);
  const std::vector<double> energy = stable.trajectory.energies().total;
  EXPECT_NEAR(energy.back(), energy.front(), 1e-6 * energy.front());
}

} // namespace
