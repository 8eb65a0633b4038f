// builds: clang++
// Operating points of a pendulum with a motor, compared with closed forms, and mistakes in the options.
#include "models/simple_pendulum.hpp"

#include <kanexpr/operating_point.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>

namespace {

using namespace simple_pendulum;
using eom = kanexpr::equations_of_motion<System>;
using operating_point = kanexpr::operating_point<System>;
using testing::StartsWith;

static_assert(std::is_same_v<decltype(std::declval<operating_point>().cause()), std::string>);

constexpr double pi = std::numbers::pi;

kanexpr::parameter_values<System> some_parameters() { return Eigen::Vector4d(2, 0.5, 9.81, 0.1); }
constexpr double mgl = 2 * 0.5 * 9.81;

TEST(operating_point, hangs_or_stands_under_a_torque) {
  for (const double torque : {0.0, 1.7, -6.3, 9.5}) {
    const double angle = std::asin(torque / mgl);
    const operating_point hanging({{q, 0.2}}, some_parameters(), {.inputs = {{T, torque}}, .held = {T}});
    const operating_point standing({{q, 2.9}}, some_parameters(), {.inputs = {{T, torque}}, .held = {T}});
    ASSERT_TRUE(hanging) << hanging.cause();
    ASSERT_TRUE(standing) << standing.cause();
    EXPECT_NEAR(hanging.x[q], angle, 1e-14);
    EXPECT_NEAR(standing.x[q], pi - angle, 3e-14);
    EXPECT_NEAR(hanging.x[u], 0, 1e-15);
    EXPECT_EQ(hanging.r[T], torque);
    EXPECT_EQ(hanging.freedom, 0);
    EXPECT_NEAR(eom::rhs(hanging.x, hanging.p, hanging.r).norm(), 0, 1e-13);
    EXPECT_LT(hanging.iterations, 12);
  }
}

TEST(operating_point, finds_the_input_that_holds_a_state) {
  const operating_point held({{q, 2.3}}, some_parameters(), {.held = {q}});
  ASSERT_TRUE(held) << held.cause();
  EXPECT_EQ(held.x[q], 2.3);
  EXPECT_NEAR(held.r[T], mgl * std::sin(2.3), 1e-14);
  // the input changes before the state does
  const operating_point free({{q, 2.3}, {u, 0.3}}, some_parameters());
  ASSERT_TRUE(free) << free.cause();
  EXPECT_NEAR(free.x[q], 2.3, 1e-14);
  EXPECT_NEAR(free.r[T], held.r[T], 1e-13);
  EXPECT_EQ(free.freedom, 1);
}

TEST(operating_point, finds_freed_parameters) {
  const operating_point longer({{q, 0.7}}, some_parameters(),
                               {.inputs = {{"T", 4.1}}, .held = {q, T}, .freed = {l}});
  ASSERT_TRUE(longer) << longer.cause();
  EXPECT_NEAR(longer.p[l], 4.1 / (2 * 9.81 * std::sin(0.7)), 1e-14);
  EXPECT_EQ(longer.p[m], 2);
}

TEST(operating_point, may_have_given_rates) {
  // at a constant speed the motor also overcomes the friction
  const operating_point turning({{q, 1}}, some_parameters(), {.held = {q}, .rates = {{dot(q), 3}}});
  ASSERT_TRUE(turning) << turning.cause();
  EXPECT_NEAR(turning.x[u], 3, 1e-15);
  EXPECT_NEAR(turning.r[T], mgl * std::sin(1) + 0.1 * 3, 1e-14);
  const operating_point speeding({{q, 1}, {u, 3}}, some_parameters(),
                                 {.held = {q, u}, .changing = {q}, .rates = {{dot(u), 5}}});
  ASSERT_TRUE(speeding) << speeding.cause();
  EXPECT_NEAR(speeding.r[T], mgl * std::sin(1) + 0.1 * 3 + 2 * 0.5 * 0.5 * 5, 1e-14);
}

TEST(operating_point, is_linearized_about) {
  const operating_point held({{q, 2.3}}, some_parameters(), {.held = {q}});
  const auto [A, B] = kanexpr::linearization<System>::explicit_form(held.x, held.p, held.r);
  EXPECT_NEAR(A(1, 0), -9.81 / 0.5 * std::cos(2.3), 1e-13);
  EXPECT_NEAR(B(1, 0), 1 / (2 * 0.5 * 0.5), 1e-15);
}

TEST(operating_point, does_not_exist_if_the_motor_is_too_strong) {
  const operating_point none({{q, 0.5}}, some_parameters(), {.inputs = {{T, 12}}, .held = {T}});
  EXPECT_FALSE(none);
  EXPECT_THAT(none.cause(),
              StartsWith("no operating point: the rate of speed u is 4.38 where the search ended ("));
  EXPECT_NEAR(none.x[q], pi / 2, 1e-2); // the nearest to one
  ASSERT_EQ(none.residuals().size(), 2U);
  EXPECT_EQ(none.residuals()[1].name, "the rate of speed u");
  EXPECT_NEAR(none.residuals()[1].value, (12 - mgl) / (2 * 0.5 * 0.5), 1e-3);
}

TEST(operating_point, does_not_exist_without_unknowns) {
  const operating_point none({{q, 0.5}}, some_parameters(), {.held = {q, u, T}});
  EXPECT_EQ(none.cause(), "no operating point: the rate of speed u is -9.41 where the search ended");
  EXPECT_TRUE(operating_point({{q, 0}}, some_parameters(), {.held = {q, u, T}}));
}

TEST(operating_point, reports_mistakes_in_the_options) {
  const auto cause = [](const kanexpr::operating_point_options<System>& options) {
    return operating_point({{q, 0.5}}, some_parameters(), options).cause();
  };
  EXPECT_EQ(cause({.held = {"Q"}}), "Q is listed as held, but the system System does not have it");
  EXPECT_EQ(cause({.held = {q, u, q}}), "coordinate q is listed twice as held");
  EXPECT_EQ(cause({.held = {q, T}, .freed = {l, T}}), "input T is both held and freed");
  EXPECT_EQ(cause({.changing = {l}}), "parameter l is listed as changing, but it is not part of the state");
  EXPECT_EQ(cause({.rates = {{u, 3}}}), "u is given as a rate, but it is not a rate of the system System");
  EXPECT_EQ(cause({.rates = {{dot(q), 3}, {"q'", 3}}}), "the rate of coordinate q is given twice");
  EXPECT_EQ(cause({.rates = {{dot(u), std::nan("")}}}),
            "the value given for the rate of speed u is not finite");
  EXPECT_EQ(cause({.inputs = {{q, 1}}}), "coordinate q is not an entry of the input vector of System");
  EXPECT_EQ(operating_point({{q, std::nan("")}}, some_parameters()).cause(),
            "the value of coordinate q is not a number");
  EXPECT_EQ(operating_point({{q, 0.5}}).cause(), "parameter m has no value");
  EXPECT_EQ(operating_point({{q, 0.5}}, {{m, 0}, {l, 1}, {g, 1}, {c, 0}}).cause(),
            "at the guess: the mass matrix is singular at this state: its elimination fails at the speed u");
}

TEST(operating_point, rejects_invalid_options) {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto cause = [](const kanexpr::operating_point_options<System>& options) {
    return operating_point({{q, 0.2}}, some_parameters(), options).cause();
  };
  for (const double tolerance : {0.0, -1.0})
    EXPECT_EQ(cause({.tolerance = tolerance}), "the tolerance must be positive");
  for (const double tolerance : {infinite, std::nan("")})
    EXPECT_EQ(cause({.tolerance = tolerance}), "the tolerance is not finite");
  EXPECT_EQ(cause({.most_iterations = 0}), "the maximum number of iterations must be positive");
  EXPECT_EQ(cause({.t = infinite}), "the time is not finite");
}

} // namespace
