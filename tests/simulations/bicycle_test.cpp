// builds: clang++ all
// The motion of a bicycle after a push, compared with its linearized equations.
#include "oracles.hpp"

#include <kanexpr/simulate.hpp>

#include <models/bicycle.hpp>

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

// The product of any row and Π (A − λⱼ) over all other eigenvalues is a left eigenvector (Cayley-Hamilton).
Eigen::RowVector4cd left_eigenvector(const Eigen::Matrix4d& a,
                                     const std::vector<std::complex<double>>& values, std::size_t which) {
  Eigen::RowVector4cd row(1, 1, 1, 1);
  for (std::size_t j = 0; j < values.size(); ++j)
    if (j != which) row = (row * a.cast<std::complex<double>>() - values[j] * row).eval();
  return row.normalized();
}

// Along an eigenvector the motion is exp(λ t). The slow and fast, growing and decaying modes are those of
// Meijaard, Papadopoulos, Ruina & Schwab (2007).
TEST(bicycle, moves_in_the_modes_of_its_linearization) {
  const oracle::bicycle benchmark = oracle::load_bicycle();
  for (const int v : {3, 5, 7}) {
    const auto run = pushed(v, 1e-6, 3);
    ASSERT_TRUE(run) << run.cause();
    const auto& rates = benchmark.eigenvalues.at(v);
    ASSERT_EQ(rates.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::RowVector4cd along = left_eigenvector(benchmark.A.at(v), rates, i);
      const auto amplitude = [&](const state<BoundSystem>& x) { return (along * small_motion(x)).value(); };
      const std::complex<double> start = amplitude(run.trajectory[0].x);
      for (const auto& s : run.trajectory)
        EXPECT_LT(std::abs(amplitude(s.x) - start * std::exp(rates[i] * s.t)),
                  1e-6 * std::abs(start) * std::max(1.0, std::exp(rates[i].real() * s.t)))
            << v << ' ' << rates[i] << ' ' << s.t;
    }
  }
}

double largest_lean(const simulation<BoundSystem>& run, double from, double to) {
  double largest = 0;
  for (const auto& s : run.trajectory)
    if (s.t >= from && s.t <= to) largest = std::max(largest, std::abs(s.x[bicycle::q2]));
  return largest;
}

TEST(bicycle, recovers_from_a_push_only_at_some_speeds) {
  const auto stable = pushed(4.6, 0.1, 10), unstable = pushed(3.5, 0.1, 2);
  ASSERT_TRUE(stable) << stable.cause();
  ASSERT_TRUE(unstable) << unstable.cause();
  EXPECT_LT(largest_lean(stable, 8, 10), 0.1 * largest_lean(stable, 0, 2));
  EXPECT_GT(largest_lean(unstable, 1, 2), 1.5 * largest_lean(unstable, 0, 1));
  EXPECT_LT(std::ranges::max(stable.trajectory.constraint_residuals()), 1e-12);
}

} // namespace
