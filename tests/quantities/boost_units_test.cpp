#include "quantities/pendulum.hpp"

#include <kanexpr/boost_units.hpp>
#include <kanexpr/compiled/named_values.hpp>

#include <boost/units/physical_dimensions/information.hpp>
#include <boost/units/systems/angle/degrees.hpp>
#include <boost/units/systems/si/prefixes.hpp>
#include <boost/units/systems/si/torque.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <type_traits>
#include <vector>

namespace {

using namespace pendulum_with_units;
namespace bu = boost::units;
namespace bsi = boost::units::si;

const auto length = 50. * bsi::centi * bsi::meters;
const auto acceleration = 9.81 * bsi::meters / (bsi::seconds * bsi::seconds);

TEST(boost_units, give_values_in_the_units_of_the_model) {
  const eom::parameters p{{m, 2. * bsi::kilogrammes}, {l, length}, {g, acceleration}, {c, 0.1}};
  EXPECT_EQ(p[m], 2);
  EXPECT_EQ(p[l], 0.5);
  EXPECT_EQ(p[g], 9.81);
  const eom::state x{{q, 30. * bu::degree::degrees}, {u, 2.f * bsi::radians_per_second}};
  EXPECT_NEAR(x[q], std::numbers::pi / 6, 1e-12); // Boost.Units has twelve digits of a degree
  EXPECT_EQ(x[u], 2);
  const eom::inputs r{{T, 3. * bsi::newton_meters}}; // in Boost.Units, a torque contains 1/rad
  EXPECT_EQ(r[T], 3);
  const eom::inputs same{{T, 3. * bsi::joules}};
  EXPECT_EQ(same[T], 3);
  const eom::parameters damped{{m, 2}, {l, 1}, {g, 9}, {c, 0.1 * bsi::newton_meters * bsi::seconds}};
  EXPECT_EQ(damped[c], 0.1) << "a unit that the model infers";
  const bu::quantity<bsi::dimensionless> ratio =
      boost_quantity(damped, c) / (1. * bsi::newton * bsi::meters * bsi::seconds / bsi::radians);
  EXPECT_EQ(ratio.value(), 0.1);
}

TEST(boost_units, do_not_convert_to_another_dimension) {
  using compiled::units_library;
  static_assert(!units_library<bu::quantity<bsi::length>>::converts<si::kilogram>);
  static_assert(!units_library<bu::quantity<bsi::angular_velocity>>::converts<si::radian>);
  static_assert(!units_library<bu::quantity<bu::unit<bu::information_dimension, bsi::system>>>::converts<
                si::dimensionless>);
}

TEST(boost_units, are_in_the_guide) {
#include <docs/guide/quantities/boost_units.cpp>
  EXPECT_EQ(angle.value(), 0.5);
  EXPECT_EQ(torque.value(), 3);
  EXPECT_EQ(p[m], 2.5);
  EXPECT_EQ(p[g], 9.81);
}

TEST(boost_units, give_values_in_lists) {
  const std::vector<named_value> start{{q, 90. * bu::degree::degrees}, {u, 0}, {"c", 0.1}};
  EXPECT_NEAR(start[0].value, std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(start[0].what.name(), "q");
}

TEST(boost_units, express_results) {
  const eom::state x{{q, 0.25}, {u, 2}};
  const bu::quantity<bsi::plane_angle> angle = boost_quantity(x, q);
  EXPECT_EQ(angle.value(), 0.25);
  const bu::quantity<bsi::angular_velocity> speed = boost_quantity(x, u);
  EXPECT_EQ(speed.value(), 2);
  const bu::quantity<bsi::energy> energy = boost_quantity<si::joule>(3);
  EXPECT_EQ(energy.value(), 3);
  const bu::quantity<bsi::dimensionless> ratio = boost_quantity<si::dimensionless>(4);
  EXPECT_EQ(ratio.value(), 4);
}

} // namespace
