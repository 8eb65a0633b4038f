// builds: clang++ sanitize no-exceptions
// Without -mavx a pack is returned in memory; that the flag would change this is no concern of one program.
#pragma GCC diagnostic ignored "-Wpsabi"

#include "no_heap.hpp"

#include <kanexpr/lower/pack.hpp>
#include <models/double_pendulum.hpp>
#include <models/rolling_disc.hpp>

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

namespace {

using disc = kanexpr::equations_of_motion<rolling_disc::System>;
using bars = kanexpr::equations_of_motion<double_pendulum::System>;
typedef double pack __attribute__((vector_size(32)));

disc::state disc_state() {
  using namespace rolling_disc;
  disc::state x;
  x[q1] = 0.3;
  x[q2] = -0.4;
  x[q3] = 1.1;
  x[u1] = 0.7;
  x[u2] = -2.5;
  x[u3] = 0.2;
  return x;
}

disc::parameters disc_parameters() {
  using namespace rolling_disc;
  disc::parameters p;
  p[r] = 0.45;
  p[m] = 2.2;
  p[g] = 9.81;
  return p;
}

template <class Scalar>
auto disc_rates() {
  const kanexpr::state<rolling_disc::System, Scalar> x(disc_state().cast<Scalar>());
  const kanexpr::parameter_values<rolling_disc::System, Scalar> p(disc_parameters().cast<Scalar>());
  no_heap::guard guard;
  return disc::rhs(x, p);
}

TEST(scalars, float_and_long_double_differ_by_their_rounding) {
  const auto exact = disc_rates<long double>();
  EXPECT_LT((disc_rates<float>().cast<long double>() - exact).norm(), 1e-6L * exact.norm());
  EXPECT_LT((disc_rates<double>().cast<long double>() - exact).norm(), 1e-15L * exact.norm());
  EXPECT_NE(disc_rates<double>().cast<long double>(), exact);
}

TEST(scalars, automatic_differentiation_gives_the_values_and_their_derivatives) {
  constexpr int n = disc::state::RowsAtCompileTime;
  using number = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;
  const disc::state x = disc_state();
  const disc::parameters p = disc_parameters();
  kanexpr::state<rolling_disc::System, number> seeded;
  for (int i = 0; i < n; ++i) seeded(i) = number(x(i), n, i);
  const auto rates = [&] {
    no_heap::guard guard;
    return disc::rhs(seeded, p);
  }();

  const auto expected = disc_rates<double>();
  const auto precise = x.cast<long double>().eval();
  const auto precise_parameters = p.cast<long double>().eval();
  for (int j = 0; j < n; ++j) {
    const auto step = (1e-6L * Eigen::Matrix<long double, n, 1>::Unit(j)).eval();
    const auto slope =
        ((disc::rhs(precise + step, precise_parameters) - disc::rhs(precise - step, precise_parameters)) /
         2e-6L)
            .eval();
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(rates(i).value(), expected(i), 1e-15 * expected.norm());
      EXPECT_NEAR(rates(i).derivatives()(j), static_cast<double>(slope(i)), 1e-9);
    }
  }
}

TEST(scalars, each_lane_of_a_pack_has_the_bits_of_its_own_evaluation) {
  using namespace double_pendulum;
  bars::parameters p;
  p << 1.1, 0.6, 0.4, 0.35, 0.9, 0.07, 0.02, 9.81, 0.03, 0.02;
  kanexpr::state<double_pendulum::System, pack> side_by_side;
  kanexpr::input_values<double_pendulum::System, pack> torques;
  for (int lane = 0; lane < 4; ++lane) {
    side_by_side[q1][lane] = 0.4 + lane;
    side_by_side[q2][lane] = -0.3 * lane;
    side_by_side[u1][lane] = 2.0 - lane;
    side_by_side[u2][lane] = 0.7;
    torques[T1][lane] = 0.1 * lane;
    torques[T2][lane] = 0;
  }
  constexpr auto all = bars::together(bars::mass_matrix, bars::rhs, bars::kinetic_energy);
  const auto [mass_matrix, rates, energy] = [&] {
    no_heap::guard guard;
    return all(side_by_side, p, torques);
  }();

  for (int lane = 0; lane < 4; ++lane) {
    bars::state x;
    bars::inputs r;
    for (int i = 0; i < 4; ++i) x(i) = side_by_side(i)[lane];
    for (int i = 0; i < 2; ++i) r(i) = torques(i)[lane];
    const auto [own_mass_matrix, own_rates, own_energy] = all(x, p, r);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(mass_matrix(i)[lane], own_mass_matrix(i));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(rates(i)[lane], own_rates(i));
    EXPECT_EQ(energy.value[lane], own_energy.value);
  }
}

TEST(scalars, packs_have_all_functions) {
  using math = kanexpr::lower::scalar_math<pack>;
  using kanexpr::symbolic::operation;
  const pack x{0.1, 0.2, 0.3, 0.4}, y{-1, 2, -3, 4};
  EXPECT_EQ(math::by_name<operation::sqrt>(x)[1], std::sqrt(0.2));
  EXPECT_EQ(math::by_name<operation::tan>(x)[2], std::tan(0.3));
  EXPECT_EQ(math::by_name<operation::sinh>(y)[2], std::sinh(-3.0));
  EXPECT_EQ(math::by_name<operation::cosh>(y)[1], std::cosh(2.0));
  EXPECT_EQ(math::by_name<operation::tanh>(y)[0], std::tanh(-1.0));
  EXPECT_EQ(math::by_name<operation::abs>(y)[2], 3);
  EXPECT_EQ(math::by_name<operation::sign>(y)[0], -1);
  EXPECT_EQ(math::power(x, y)[3], std::pow(0.4, 4.0));
  EXPECT_EQ(math::atan2(x, y)[0], std::atan2(0.1, -1.0));
}

TEST(scalars, the_sign_of_no_number_is_none) {
  const auto sign = [](auto x) { return kanexpr::lower::scalar_math<decltype(x)>::sign(x); };
  EXPECT_TRUE(std::isnan(sign(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(sign(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_EQ(sign(-std::numeric_limits<double>::infinity()), -1);
  EXPECT_EQ(sign(0.0), 0);
  EXPECT_EQ(sign(2.0F), 1);
}

TEST(scalars, is_finite_in_all_lanes) {
  using math = kanexpr::lower::scalar_math<pack>;
  pack x = math::from(3);
  EXPECT_TRUE(math::is_finite(x));
  x[2] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(math::is_finite(x));
  EXPECT_TRUE(kanexpr::lower::scalar_math<long double>::is_finite(1e300L));
  EXPECT_FALSE(
      kanexpr::lower::scalar_math<long double>::is_finite(std::numeric_limits<long double>::infinity()));
}

} // namespace
