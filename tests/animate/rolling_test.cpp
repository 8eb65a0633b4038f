// builds: clang++
#include "animate/disc_on_a_circle.hpp"

#include <kanexpr/animate/animated.hpp>

#include <gtest/gtest.h>

namespace {

using namespace rolling_disc;
using kanexpr::animate::placement;

using disc_picture =
    kanexpr::picture<System, up<3 * N::z>, ground<>, carried<Dmc>, trace<C, named<"path">>,
                     show<wheel<R, Dmc, R::y, r, r / 10>, named<"turning">>,
                     show<wheel<L, Dmc, L::y, r, r / 10>, spinning<u2 - u3 * tan(q2)>, named<"spinning">>,
                     show<box<R, Dmc, r, 0.1, 0.2>>, show<rod<C, Dmc, 0.02>>>;

constexpr tests::disc_on_a_circle closed_form;

double away(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

kanexpr::animation film(int steps, double step) {
  return kanexpr::animated<disc_picture>(tests::known_motion<System, tests::disc_on_a_circle>(
      closed_form.parameters(), closed_form, steps, step));
}

TEST(rolling_picture, travels_as_the_disc_rolls) {
  const kanexpr::animation a = film(800, 0.01);
  ASSERT_TRUE(a) << a.cause();
  ASSERT_EQ(a.times.size(), 801u);
  const auto *path = a.find("path"), *turning = a.find("turning"), *rod = a.find("rod from C to Dmc");
  for (std::size_t k = 0; k < a.times.size(); ++k) {
    const double t = a.times[k];
    EXPECT_LT(away(turning->placements[k].position, closed_form.centre(t)), 1e-11) << t;
    EXPECT_LT(away(path->placements[k].position, closed_form.contact(t)), 1e-11) << t;
    EXPECT_LT(away(rod->placements[k].position, closed_form.contact(t)), 1e-11) << t;
    EXPECT_LT(away(rod->placements[k].end, closed_form.centre(t)), 1e-11) << t;
  }
}

TEST(rolling_picture, error_of_the_way_falls_with_the_fourth_power_of_the_step) {
  const auto error = [](int steps) {
    const kanexpr::animation a = film(steps, 8.0 / steps);
    return away(a.find("turning")->placements.back().position, closed_form.centre(8));
  };
  EXPECT_NEAR(error(40) / error(80), 16, 0.2);
}

TEST(rolling_picture, takes_the_samples_alone_where_no_state_is_between_them) {
  const auto error = [](int steps) {
    tests::samples<System> run{{}, closed_form.parameters()};
    for (int i = 0; i <= steps; ++i) run.all.push_back({8.0 / steps * i, closed_form(8.0 / steps * i), {}});
    const kanexpr::animation a = kanexpr::animated<disc_picture>(run);
    return away(a.find("turning")->placements.back().position, closed_form.centre(8));
  };
  EXPECT_LT(error(80), 0.02);
  EXPECT_NEAR(error(80) / error(160), 4, 0.05);
}

TEST(rolling_picture, turns_with_the_disc) {
  const kanexpr::animation a = film(200, 0.05);
  for (std::size_t k = 0; k < a.times.size(); ++k) {
    const double t = a.times[k];
    EXPECT_LT(away(a.find("turning")->placements[k].orientation, closed_form.about_spin(t)), 1e-13) << t;
    EXPECT_LT(away(a.find("box at Dmc")->placements[k].orientation, closed_form.axes(t)), 1e-13) << t;
  }
}

TEST(rolling_picture, spin_takes_the_place_of_an_angle) {
  const kanexpr::animation a = film(200, 0.05);
  for (std::size_t k = 0; k < a.times.size(); ++k)
    EXPECT_LT(
        away(a.find("turning")->placements[k].orientation, a.find("spinning")->placements[k].orientation),
        1e-12)
        << a.times[k];
}

TEST(rolling_picture, tells_sizes_states_and_the_ground) {
  const kanexpr::animation a = film(4, 0.5);
  EXPECT_EQ(a.find("turning")->sizes, (std::vector{0.3, 0.03}));
  EXPECT_EQ(a.find("box at Dmc")->sizes, (std::vector{0.3, 0.1, 0.2}));
  ASSERT_EQ(a.columns.size(), 6u);
  EXPECT_EQ(a.columns[2].name, "q3");
  EXPECT_DOUBLE_EQ(a.columns[2].values[3], closed_form.spin * 1.5);
  EXPECT_EQ(a.up, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(a.ground, 0);
  EXPECT_TRUE(a.carried);
  EXPECT_FALSE(a.seen_from);
}

} // namespace
