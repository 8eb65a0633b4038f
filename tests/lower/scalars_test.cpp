// builds: clang++ sanitize no-exceptions
// Without -mavx a pack is returned in memory; that the flag would change this is no concern of one program.
#pragma GCC diagnostic ignored "-Wpsabi"

#include "no_heap.hpp"

#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/lower/pack.hpp>
#include <kanexpr/lower/tape_in_pieces.hpp>
#include <models/double_pendulum.hpp>
#include <models/rolling_disc.hpp>

#include <unsupported/Eigen/AutoDiff>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace {

using disc = kanexpr::equations_of_motion<rolling_disc::System>;
using bars = kanexpr::equations_of_motion<double_pendulum::System>;
typedef double pack __attribute__((vector_size(32)));

using disc_jacobian_code =
    kanexpr::compiled::code<rolling_disc::System, kanexpr::mechanics::quantity::state_jacobian>;

} // namespace

/// The Jacobian by itself is in pieces; together with another result it is not.
template <>
inline constexpr kanexpr::lower::lengths kanexpr::lower::lengths_of<disc_jacobian_code>{0, 12};

namespace {

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

/// Each entry of the Jacobian of the disc in pieces, followed by the same entry as evaluated in one function.
template <class Number>
auto disc_jacobian(const kanexpr::state<rolling_disc::System, Number>& x) {
  constexpr kanexpr::function<rolling_disc::System, kanexpr::mechanics::quantity::state_jacobian> in_pieces{};
  constexpr auto whole = disc::together(in_pieces, disc::kinetic_energy);
  const disc::parameters p = disc_parameters();
  no_heap::guard guard;
  return std::pair(in_pieces(x, p), std::get<0>(whole(x, p)));
}

TEST(scalars, have_the_same_bits_in_pieces) {
  static_assert(kanexpr::lower::is_cut<disc_jacobian_code, double>);
  static_assert(kanexpr::lower::cuts_of<disc_jacobian_code>::value.pieces > 5);
  const disc::state x = disc_state();
  constexpr int n = disc::state::RowsAtCompileTime;
  const auto [own, whole] = disc_jacobian<double>(x);
  EXPECT_EQ(own, whole);
  EXPECT_TRUE(own.status);
  EXPECT_GT(own.norm(), 1);
  const auto [rough, rough_whole] =
      disc_jacobian<float>(kanexpr::state<rolling_disc::System, float>(x.cast<float>()));
  EXPECT_EQ(rough, rough_whole);

  using number = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;
  kanexpr::state<rolling_disc::System, number> seeded;
  kanexpr::state<rolling_disc::System, pack> side_by_side;
  for (int i = 0; i < n; ++i) seeded(i) = number(x(i), n, i), side_by_side(i) = x(i) + pack{0, 0.1, 0.2, 0.3};
  const auto [slopes, slopes_whole] = disc_jacobian<number>(seeded);
  const auto [lanes, lanes_whole] = disc_jacobian<pack>(side_by_side);
  for (int i = 0; i < own.size(); ++i) {
    EXPECT_EQ(slopes(i).value(), own(i));
    EXPECT_EQ(slopes(i).derivatives(), slopes_whole(i).derivatives());
    EXPECT_EQ(lanes(i)[0], own(i));
    for (int lane = 1; lane < 4; ++lane) EXPECT_EQ(lanes(i)[lane], lanes_whole(i)[lane]);
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
  EXPECT_EQ(math::by_name<operation::cbrt>(y)[2], std::cbrt(-3.0));
  EXPECT_EQ(math::by_name<operation::erf>(x)[3], std::erf(0.4));
  EXPECT_EQ(math::by_name<operation::wrap_to_pi>(y)[3], std::remainder(4.0, 2 * std::numbers::pi));
  EXPECT_EQ((math::by_name<operation::atan2>(x, y)[0]), std::atan2(0.1, -1.0));
}

template <kanexpr::symbolic::operation op, class Number>
Number function_of(const Number& x) {
  return kanexpr::lower::scalar_math<Number>::template by_name<op>(x);
}

TEST(scalars, have_functions_that_complex_numbers_lack_to_first_order) {
  using kanexpr::symbolic::operation;
  using complex = std::complex<double>;
  const double step = 1e-30, x = -0.7;
  EXPECT_DOUBLE_EQ(function_of<operation::cbrt>(complex(x, step)).real(), std::cbrt(x));
  EXPECT_NEAR(function_of<operation::cbrt>(complex(x, step)).imag() / step, 1 / (3 * std::cbrt(x * x)),
              1e-15);
  EXPECT_EQ(function_of<operation::erf>(complex(x, step)).real(), std::erf(x));
  EXPECT_NEAR(function_of<operation::erf>(complex(x, step)).imag() / step,
              2 / std::sqrt(std::numbers::pi) * std::exp(-x * x), 1e-15);
  EXPECT_EQ(function_of<operation::wrap_to_pi>(complex(4, step)),
            complex(std::remainder(4, 2 * std::numbers::pi), step));
  EXPECT_EQ(function_of<operation::abs>(complex(x, step)), complex(-x, -step));
  EXPECT_EQ(function_of<operation::sign>(complex(x, step)), complex(-1, 0));
  using math = kanexpr::lower::scalar_math<complex>;
  const complex angle = math::by_name<operation::atan2>(complex(0.3, step), complex(-0.4, 2 * step));
  EXPECT_EQ(angle.real(), std::atan2(0.3, -0.4));
  EXPECT_NEAR(angle.imag() / step, (-0.4 - 0.6) / 0.25, 1e-14);
}

template <class Number>
void expect_wrapped() {
  using kanexpr::symbolic::operation;
  constexpr Number pi = std::numbers::pi_v<Number>;
  for (const Number x : {Number(0), Number(3), Number(-3), Number(3.5), Number(-100), Number(1e6)})
    EXPECT_EQ(function_of<operation::wrap_to_pi>(x), std::remainder(x, 2 * pi));
  EXPECT_EQ(function_of<operation::wrap_to_pi>(pi), -pi);
  EXPECT_EQ(function_of<operation::wrap_to_pi>(-pi), -pi);
  EXPECT_LT(function_of<operation::wrap_to_pi>(std::nextafter(pi, Number(0))), pi);
  EXPECT_TRUE(std::signbit(function_of<operation::wrap_to_pi>(Number(-0.0))));
  EXPECT_TRUE(std::isnan(function_of<operation::wrap_to_pi>(std::numeric_limits<Number>::infinity())));
}

TEST(scalars, are_wrapped_into_a_turn_of_their_precision) {
  expect_wrapped<double>();
  expect_wrapped<float>();
  expect_wrapped<long double>();
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
