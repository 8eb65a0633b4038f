// builds: clang++ all
// Gains computed at compile time: a torque at the fork balances a bicycle.
#include "control/matrices.hpp"
#include "control/references.hpp"

#include <kanexpr/control.hpp>

#include <models/bicycle.hpp>

#include <Eigen/Eigenvalues>

namespace {

using namespace kanexpr;
using namespace bicycle;
using lin = linearization<SteeredSystem>;

// The indices of lean, steer and their rates among q1, q2, q5, u2, u3, u5.
constexpr auto regulator_at(double v) {
  const auto both = lin::explicit_form.constant(
      constant_state<SteeredSystem>(
          {{q1, 0}, {q2, 0}, {q5, 0}, {u2, 0}, {u3, v / 0.3}, {u5, 0}, {u6, v / 0.35}}),
      {}, constant_inputs<SteeredSystem>({{T, 0}}));
  return lqr(std::get<0>(both).at({1, 2, 3, 5}, {1, 2, 3, 5}), std::get<1>(both).at({1, 2, 3, 5}, {0}),
             {10, 1, 1, 0.1}, {0.01});
}

constexpr auto gains = gain_schedule<5>(2.0, 6.0, regulator_at);
static_assert(gains);

TEST(gain_schedule, of_a_bicycle_has_the_gains_of_scipy) {
  const auto agrees = [](double v, const double(&expected)[4]) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(gains(v)(0, i), expected[i], 1e-9 * std::abs(expected[i])) << v;
  };
  agrees(2, references::bicycle::gain_at_2);
  agrees(4, references::bicycle::gain_at_4);
  agrees(6, references::bicycle::gain_at_6);
}

// It also does so between the points, and below the weave speed, where an uncontrolled bicycle falls over.
TEST(gain_schedule, balances_a_bicycle) {
  for (double v = 2; v <= 6; v += 0.125) {
    lin::state x;
    x[u3] = v / 0.3, x[u6] = v / 0.35;
    const auto [a, b] = lin::explicit_form(x, lin::parameters(), lin::inputs(0.0));
    const std::array places{1, 2, 3, 5};
    const Eigen::Matrix4d open = a(places, places);
    const Eigen::Matrix4d closed = open - b(places, 0) * numeric::as_eigen(gains(v));
    if (v < 4.25) {
      EXPECT_GT(open.eigenvalues().real().maxCoeff(), 0) << v;
    }
    EXPECT_LT(closed.eigenvalues().real().maxCoeff(), -0.3) << v;
  }
}

// A double integrator whose first weight is v²: K = (v, √(2 v)).
constexpr auto feedback(double v) {
  return lqr(numeric::by_rows({{0.0, 1.0}, {0.0, 0.0}}), numeric::by_rows({{0.0}, {1.0}}), {v * v, 0.0}, {1});
}

TEST(gain_schedule, goes_straight_between_its_points_and_ends_at_its_ends) {
  constexpr auto table = gain_schedule<3>(1.0, 3.0, feedback);
  static_assert(table);
  EXPECT_NEAR(table(1)(0, 0), 1, 1e-14);
  EXPECT_NEAR(table(2)(0, 1), 2, 1e-14);
  EXPECT_NEAR(table(3)(0, 0), 3, 1e-14);
  EXPECT_NEAR(table(1.25)(0, 1), 0.75 * std::sqrt(2) + 0.25 * 2, 1e-14);
  EXPECT_NEAR(table(2.75)(0, 1), 0.25 * 2 + 0.75 * std::sqrt(6), 1e-14);
  EXPECT_NEAR(table(-7)(0, 0), 1, 1e-14);
  EXPECT_NEAR(table(1e300)(0, 0), 3, 1e-14);
  EXPECT_TRUE(std::isnan(table(std::numeric_limits<double>::quiet_NaN())(0, 0)));
}

TEST(gain_schedule, has_other_numbers) {
  constexpr auto single = in_numbers<float>(gains);
  for (const float v : {2.0f, 3.3f, 9.0f})
    EXPECT_NEAR(single(v)(0, 1), gains(double{v})(0, 1), 1e-5 * std::abs(gains(v)(0, 1)));
}

TEST(gain_schedule, takes_matrices_of_eigen_while_the_program_runs) {
  const auto table = gain_schedule<2>(0.0f, 4.0f, [](float v) { return Eigen::RowVector2f(v, 1); });
  EXPECT_EQ(table(1.0f), Eigen::RowVector2f(1, 1));
  EXPECT_EQ(in_numbers<double>(table)(1.0), Eigen::RowVector2d(1, 1));
  EXPECT_EQ(numeric::as_eigen(table(1.0f)), Eigen::RowVector2f(1, 1));
}

TEST(gain_schedule, takes_whole_numbers_as_ends) {
  constexpr auto square = [](double v) { return numeric::fixed_matrix<double, 1, 1>{{v * v}}; };
  constexpr auto table = gain_schedule<9>(2, 6, square);
  EXPECT_EQ(table(3)(0, 0), 9);
  EXPECT_EQ(gain_schedule<9>(2, 6.0, square)(3)(0, 0), 9);
}

TEST(gain_schedule, says_what_cannot_be_a_schedule) {
  const auto inverse = [](double v) { return Eigen::Matrix<double, 1, 1>(1 / v); };
  EXPECT_EQ(gain_schedule<3>(0.0, 1.0, inverse).status.cause(), "a gain of the schedule is not finite");
  EXPECT_EQ(gain_schedule<3>(2.0, 2.0, inverse).status.cause(),
            "the ends of the schedule must be finite and different");
}

TEST(gain_schedule, one_gain_has_other_numbers_too) {
  constexpr auto single = in_numbers<float>(gains.at[0]);
  EXPECT_EQ(single(0, 1), static_cast<float>(gains.at[0](0, 1)));
}

TEST(gain_schedule, says_where_there_is_no_gain) {
  constexpr auto table = gain_schedule<3>(-1.0, 1.0, feedback);
  static_assert(!table);
  EXPECT_EQ(
      table.status.cause(),
      "the system is not detectable on the imaginary axis: the state weights do not cover a motion that "
      "neither grows nor decays");
}

} // namespace
