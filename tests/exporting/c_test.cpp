// builds: g++
// The code of tests/exporting/models_in_c.cpp, compiled as C, compared with the compiled functions.
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/symbolic.hpp>
#include <models/bouncing_ball.hpp>
#include <models/cornering_car.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/motor_arm.hpp>
#include <models/rolling_disc.hpp>
#include <models/simple_pendulum.hpp>
#include <runtime/driven_wheel.hpp>
#include <runtime/loaded_arm.hpp>
#include <runtime/slewing_arm.hpp>

#include "curved.hpp"
#include "sliders.hpp"

#include <bouncing_ball.h>
#include <bouncing_ball_in_float.h>
#include <bound_pendulum.h>
#include <cornering_car.h>
#include <cornering_car_in_float.h>
#include <curved.h>
#include <curved_in_float.h>
#include <disc.h>
#include <disc_in_float.h>
#include <driven_wheel.h>
#include <driven_wheel_in_float.h>
#include <four_bar.h>
#include <four_bar_in_float.h>
#include <four_bar_in_pieces.h>
#include <four_bar_in_pieces_in_float.h>
#include <iiwa.h>
#include <iiwa_columns.h>
#include <iiwa_columns_in_float.h>
#include <iiwa_in_float.h>
#include <iiwa_in_pieces.h>
#include <iiwa_in_pieces_in_float.h>
#include <loaded_arm.h>
#include <loaded_arm_in_float.h>
#include <motor_arm.h>
#include <motor_arm_in_float.h>
#include <pendulum.h>
#include <slewing_arm.h>
#include <slewing_arm_in_float.h>
#include <sliders.h>
#include <sliders_in_float.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;

template <class Number>
auto bits(Number x) {
  if constexpr (sizeof(Number) == 8)
    return std::bit_cast<std::uint64_t>(x);
  else
    return std::bit_cast<std::uint32_t>(x);
}

/// Random arguments, the same in every run.
template <class System, class Number>
struct calls {
  state<System, Number> x;
  parameter_values<System, Number> p;
  input_values<System, Number> r;
  Eigen::Matrix<Number, equations_of_motion<System>::speeds, 1> a;

  void next() {
    for (auto& e : x.reshaped()) e = number(-2, 2);
    for (auto& e : p.reshaped()) e = number(0.5, 2);
    for (auto& e : r.reshaped()) e = number(-3, 3);
    for (auto& e : a.reshaped()) e = number(-3, 3);
  }

  /// Entries that are zero, tiny, infinite or NaN; angles in the range of the sines.
  void next_extreme() {
    next();
    using limits = std::numeric_limits<Number>;
    const Number extremes[]{-Number(0),         limits::denorm_min(), -limits::min() / 4, limits::quiet_NaN(),
                            limits::infinity(), -limits::infinity(),  limits::max()};
    const auto spoil = [&](auto&& entries, std::size_t kinds) {
      for (auto& e : entries.reshaped())
        if (random_() % 4 == 0) e = extremes[random_() % kinds];
    };
    const std::size_t kinds = random_() % 2 == 0 ? 3 : 6; // half of the calls stay finite
    spoil(x, kinds);
    x.u() = x.u().unaryExpr([&](Number e) { return random_() % 16 == 0 ? extremes[6] : e; });
    spoil(p, kinds), spoil(r, kinds);
  }

private:
  Number number(double from, double to) {
    return static_cast<Number>(std::uniform_real_distribution<double>(from, to)(random_));
  }
  std::mt19937 random_{7};
};

/// The entries, row by row.
template <class Result>
auto by_rows(const Result& result) {
  using Number = typename Result::Scalar;
  std::vector<Number> entries;
  for (Eigen::Index i = 0; i < result.rows(); ++i)
    for (Eigen::Index j = 0; j < result.cols(); ++j) entries.push_back(result(i, j));
  return entries;
}

template <class Number, class Result>
void expect_same_bits(const std::vector<Number>& written, const Result& compiled) {
  const std::vector<Number> expected = by_rows(compiled);
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_TRUE(bits(written[i]) == bits(expected[i]) || (std::isnan(written[i]) && std::isnan(expected[i])))
        << written[i] << " and " << expected[i] << " at " << i;
}

/// Compares one result, with or without a status, with that of a C function (t, x, p, r, result).
template <class Number, class Call, class Written, class Compiled>
void expect_same(Call& at, const Written& written, const Compiled& compiled) {
  for (int repetition = 0; repetition < 600; ++repetition) {
    if (repetition < 200)
      at.next();
    else
      at.next_extreme();
    std::vector<Number> found(400, std::numeric_limits<Number>::quiet_NaN());
    const unsigned long long status = written(Number(0), at.x.data(), at.p.data(), at.r.data(), found.data());
    const auto expected = compiled(at.x, at.p, at.r);
    expect_same_bits(found, expected);
    if constexpr (requires { expected.status; })
      EXPECT_EQ(status == 0, static_cast<bool>(expected.status));
    else
      EXPECT_EQ(status, 0);
  }
}

template <class Number, class System, class Udot>
void expect_same_udot(const Udot& written) {
  calls<System, Number> at;
  expect_same<Number>(at, written, equations_of_motion<System>::udot);
}

TEST(C, HasTheBitsOfTheCompiledFunctions) {
  expect_same_udot<double, iiwa::System>(iiwa_udot);
  expect_same_udot<double, four_bar::System>(four_bar_udot);
  expect_same_udot<double, rolling_disc::System>(disc_udot);
  expect_same_udot<double, slewing_arm::System>(slewing_arm_udot);
  expect_same_udot<double, bouncing_ball::System>(bouncing_ball_udot);
  expect_same_udot<double, motor_arm::System>(motor_arm_udot);
  expect_same_udot<double, loaded_arm::System>(loaded_arm_udot);
}

TEST(C, HasTheBitsOfTheCompiledFunctionsInSinglePrecision) {
  expect_same_udot<float, iiwa::System>(iiwa_in_float_udot);
  expect_same_udot<float, rolling_disc::System>(disc_in_float_udot);
  expect_same_udot<float, slewing_arm::System>(slewing_arm_in_float_udot);
  expect_same_udot<float, bouncing_ball::System>(bouncing_ball_in_float_udot);
  expect_same_udot<float, motor_arm::System>(motor_arm_in_float_udot);
  expect_same_udot<float, loaded_arm::System>(loaded_arm_in_float_udot);
}

/// Compares A, B and the status of two functions.
template <class Number, class Written>
void expect_same_linearization(const Written& in_pieces, const Written& whole) {
  constexpr std::size_t state_entries = four_bar_explicit_form_A_rows * four_bar_explicit_form_A_columns,
                        input_entries = four_bar_explicit_form_B_rows * four_bar_explicit_form_B_columns;
  calls<four_bar::System, Number> at;
  for (int repetition = 0; repetition < 600; ++repetition) {
    if (repetition < 200)
      at.next();
    else
      at.next_extreme();
    std::vector<Number> found(state_entries + input_entries, 7), expected = found;
    const auto evaluated = [&](const Written& f, std::vector<Number>& into) {
      return f(0, at.x.data(), at.p.data(), at.r.data(), into.data(), into.data() + state_entries);
    };
    ASSERT_EQ(evaluated(in_pieces, found), evaluated(whole, expected));
    for (std::size_t i = 0; i < found.size(); ++i)
      ASSERT_TRUE(bits(found[i]) == bits(expected[i]) || (std::isnan(found[i]) && std::isnan(expected[i])));
  }
}

TEST(C, HasTheSameBitsInPieces) {
  expect_same_udot<double, four_bar::System>(four_bar_in_pieces_udot);
  expect_same_udot<float, four_bar::System>(four_bar_in_pieces_in_float_udot);
  expect_same_linearization<double>(four_bar_in_pieces_explicit_form, four_bar_explicit_form);
  expect_same_linearization<float>(four_bar_in_pieces_in_float_explicit_form,
                                   four_bar_in_float_explicit_form);
}

/// Compares A, whose columns are solved in a loop, with the interpreted one.
template <class Number, class Written>
void expect_interpreted_state_matrix(const Written& written) {
  calls<iiwa::System, Number> at;
  model m = derive<iiwa::System>();
  auto interpreted = m.function<Number>(m.get(mechanics::quantity::state_matrix));
  for (int repetition = 0; repetition < 100; ++repetition) {
    at.next();
    std::vector<Number> found(14 * 14), B(14 * 7);
    EXPECT_EQ(written(0, at.x.data(), at.p.data(), at.r.data(), found.data(), B.data()), 0);
    expect_same_bits(found, interpreted(at.x, at.p, at.r));
  }
}

TEST(C, HasTheBitsOfInterpretedColumns) {
  expect_interpreted_state_matrix<double>(iiwa_columns_explicit_form);
  expect_interpreted_state_matrix<double>(iiwa_in_pieces_explicit_form);
  expect_interpreted_state_matrix<float>(iiwa_columns_in_float_explicit_form);
  expect_interpreted_state_matrix<float>(iiwa_in_pieces_in_float_explicit_form);
}

/// Spoils one entry of A or B, the first or the last that is not a number.
template <class Number, class Written>
void expect_reports(const Written& written, const char* cause) {
  using limits = std::numeric_limits<Number>;
  using System = sliders::System;
  model m = derive<System>();
  auto state_matrix = m.function<Number>(m.get(mechanics::quantity::state_matrix));
  auto input_matrix = m.function<Number>(m.get(mechanics::quantity::input_matrix));
  auto udot = m.function<Number>(m.udot());
  const state<System, Number> x = state<System, Number>::Zero();
  const input_values<System, Number> r = input_values<System, Number>::Zero();
  const auto number = [](auto each) { return static_cast<Number>(each); };
  const Number all[]{1,
                     -2,
                     std::sqrt(limits::max()) / 2,
                     2 * std::sqrt(limits::max()),
                     limits::infinity(),
                     limits::quiet_NaN()};
  for (const Number value : all)
    for (Eigen::Index spoiled = 0; spoiled < 4; ++spoiled) {
      parameter_values<System, Number> p = parameter_values<System, Number>::Constant(number(3));
      p(spoiled) = value;
      const bool is_finite = std::isfinite(value * value);
      std::vector<Number> found(24, number(0));
      const unsigned long long status =
          written(number(0), x.data(), p.data(), r.data(), found.data(), found.data() + 16);
      EXPECT_EQ(std::ranges::count_if(found, [](Number e) { return !std::isfinite(e); }), is_finite ? 0 : 1);
      EXPECT_EQ(status, is_finite ? 0 : 1) << value << " in parameter " << spoiled;
      const auto [A, B] = linearization<System>::explicit_form(x, p, r);
      EXPECT_EQ(A.status && B.status, is_finite);
      state_matrix(x, p, r), input_matrix(x, p, r), udot(x, p, r);
      const kanexpr::status interpreted =
          state_matrix.status() ? input_matrix.status() : state_matrix.status();
      EXPECT_EQ(interpreted.cause(), is_finite ? "" : cause) << value << " in parameter " << spoiled;
      EXPECT_TRUE(udot.status());
    }
}

TEST(C, ReportsLinearizationsThatAreNotFinite) {
  static_assert(sliders_udot_checks == 0 && sliders_explicit_form_checks == 1 &&
                sliders_implicit_form_checks == 1 && sliders_jacobian_checks == 1);
  expect_reports<double>(sliders_explicit_form, sliders_explicit_form_causes[0]);
  expect_reports<double>(sliders_jacobian, sliders_jacobian_causes[0]);
  expect_reports<float>(sliders_in_float_explicit_form, sliders_in_float_explicit_form_causes[0]);
  expect_reports<float>(sliders_in_float_jacobian, sliders_in_float_jacobian_causes[0]);
}

/// Compares rates with interpreted ones where the state variables are positive, as the force of a tendon is.
template <class Number, class System, class Udot>
void expect_interpreted_udot(const Udot& written) {
  calls<System, Number> at;
  model m = derive<System>();
  auto interpreted = m.function<Number>(m.udot());
  int finite = 0;
  for (int repetition = 0; repetition < 300; ++repetition) {
    at.next();
    at.x.z() = at.x.z().cwiseAbs();
    std::vector<Number> found(static_cast<std::size_t>(equations_of_motion<System>::speeds));
    written(Number(0), at.x.data(), at.p.data(), at.r.data(), found.data());
    const auto expected = interpreted(at.x, at.p, at.r);
    finite += expected.allFinite() ? 1 : 0;
    expect_same_bits(found, expected);
  }
  EXPECT_GT(finite, 250);
}

TEST(C, HasTheBitsOfInterpretedTyresAndMuscles) {
  expect_interpreted_udot<double, cornering_car::System>(cornering_car_udot);
  expect_interpreted_udot<float, cornering_car::System>(cornering_car_in_float_udot);
  expect_interpreted_udot<double, driven_wheel::System>(driven_wheel_udot);
  expect_interpreted_udot<float, driven_wheel::System>(driven_wheel_in_float_udot);
}

TEST(C, HasTheBitsOfFunctionsInBothPrecisions) {
  expect_same_udot<double, curved::System>(curved_udot);
  expect_same_udot<float, curved::System>(curved_in_float_udot);
  calls<curved::System, double> at;
  for (int repetition = 0; repetition < 200; ++repetition) {
    at.next();
    std::vector<double> A(4), B(2);
    curved_explicit_form(0, at.x.data(), at.p.data(), at.r.data(), A.data(), B.data());
    const auto [state_matrix, input_matrix] = linearization<curved::System>::explicit_form(at.x, at.p, at.r);
    expect_same_bits(A, state_matrix), expect_same_bits(B, input_matrix);
  }
}

TEST(C, TakesTheRatesOfTheSpeeds) {
  calls<iiwa::System, double> at;
  for (int repetition = 0; repetition < 200; ++repetition) {
    at.next();
    std::vector<double> found(7);
    EXPECT_EQ(iiwa_inverse_dynamics(0, at.x.data(), at.p.data(), at.r.data(), at.a.data(), found.data()), 0);
    expect_same_bits(found, equations_of_motion<iiwa::System>::inverse_dynamics(at.x, at.p, at.r, at.a));
  }
}

TEST(C, GivesSeveralResultsOfOneCall) {
  using eom = equations_of_motion<four_bar::System>;
  calls<four_bar::System, double> at;
  for (int repetition = 0; repetition < 200; ++repetition) {
    at.next();
    std::vector<double> M(1), f(1), A(4), B(2);
    four_bar_mass_matrix_and_forcing(0, at.x.data(), at.p.data(), at.r.data(), M.data(), f.data());
    const auto [mass, forcing] = eom::together(eom::mass_matrix, eom::forcing)(at.x, at.p, at.r);
    expect_same_bits(M, mass), expect_same_bits(f, forcing);
    four_bar_explicit_form(0, at.x.data(), at.p.data(), at.r.data(), A.data(), B.data());
    const auto [state_matrix, input_matrix] =
        linearization<four_bar::System>::explicit_form(at.x, at.p, at.r);
    expect_same_bits(A, state_matrix), expect_same_bits(B, input_matrix);
  }
}

TEST(C, NamesPlacesAndCauses) {
  static_assert(four_bar_q1 == 0 && four_bar_u3 == 5 && four_bar_states == 6 &&
                four_bar_l0 == four_bar_parameters - 1);
  static_assert(four_bar_explicit_form_A_rows == 2 && four_bar_explicit_form_B_columns == 1 &&
                four_bar_udot_rows == 3);
  static_assert(motor_arm_i == 2 && motor_arm_states == 5 && motor_arm_explicit_form_A_rows == 5);
  calls<four_bar::System, double> at;
  at.next();
  at.x.setZero(); // all bars along one line
  std::vector<double> found(3);
  const unsigned long long status = four_bar_udot(0, at.x.data(), at.p.data(), at.r.data(), found.data());
  const auto compiled = equations_of_motion<four_bar::System>::udot(at.x, at.p, at.r);
  ASSERT_NE(status, 0);
  EXPECT_EQ(four_bar_udot_causes[std::countr_zero(status)], compiled.status.cause());
  at.next();
  at.p(0) = std::numeric_limits<double>::quiet_NaN();
  const unsigned long long last = four_bar_udot(0, at.x.data(), at.p.data(), at.r.data(), found.data());
  EXPECT_NE(last & 1ull << (four_bar_udot_checks - 1), 0) << "not finite";
}

TEST(C, BindsParameters) {
  using eom = equations_of_motion<simple_pendulum::System>;
  static_assert(bound_pendulum_l == 0 && bound_pendulum_parameters == 2);
  const eom::state x{{simple_pendulum::q, 0.7}, {simple_pendulum::u, -0.3}};
  eom::parameters p{{simple_pendulum::m, 2},
                    {simple_pendulum::l, 0.5},
                    {simple_pendulum::g, 9.81},
                    {simple_pendulum::c, 0.1}};
  const eom::inputs r{{simple_pendulum::T, 0.2}};
  const float state[]{0.7F, -0.3F}, parameters[]{0.5F, 0.1F}, input[]{0.2F};
  float rate[1];
  EXPECT_EQ(bound_pendulum_udot(0, state, parameters, input, rate), 0);
  EXPECT_NEAR(rate[0], eom::udot(x, p, r)(0), 2e-5);
}

TEST(C, IsCalledAsTheGuideSays) {
#include <docs/export/c/call.cpp>
  EXPECT_EQ(status, 0);
  const equations_of_motion<simple_pendulum::System>::state at{{simple_pendulum::q, 0.3},
                                                               {simple_pendulum::u, 0}};
  equations_of_motion<simple_pendulum::System>::parameters with{{simple_pendulum::m, 2},
                                                                {simple_pendulum::l, 0.5},
                                                                {simple_pendulum::g, 9.81},
                                                                {simple_pendulum::c, 0.1}};
  EXPECT_EQ(rate[0],
            equations_of_motion<simple_pendulum::System>::udot(
                at, with, equations_of_motion<simple_pendulum::System>::inputs{{simple_pendulum::T, 0}})(0));
}

TEST(C, HasNoNumberForAnglesOutOfReach) {
  calls<iiwa::System, double> at;
  at.next();
  at.x(1) = 131073;
  std::vector<double> found(7);
  iiwa_udot(0, at.x.data(), at.p.data(), at.r.data(), found.data());
  EXPECT_TRUE(std::isnan(found[0]));
}

} // namespace
