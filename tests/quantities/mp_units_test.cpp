// builds: g++
// With mp-units if CMake finds it, otherwise with the part of it in mp_units/.
#include "quantities/pendulum.hpp"

#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/mp_units.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace {

using namespace pendulum_with_units;
namespace mp = mp_units;
namespace msi = mp_units::si;

TEST(mp_units, give_values_in_the_units_of_the_model) {
  const eom::parameters p{{m, 2500 * msi::gram},
                          {l, 50. * msi::centi<msi::metre>},
                          {g, 9.81 * (msi::metre / mp::pow<2>(msi::second))},
                          {c, 0.1}};
  EXPECT_EQ(p[m], 2.5);
  EXPECT_EQ(p[l], 0.5);
  EXPECT_EQ(p[g], 9.81);
  const eom::state x{{q, 30 * msi::degree}, {u, 2.F * (msi::radian / msi::second)}};
  EXPECT_DOUBLE_EQ(x[q], std::numbers::pi / 6);
  EXPECT_EQ(x[u], 2);
  const eom::inputs r{{T, 3 * (msi::newton * msi::metre)}};
  EXPECT_EQ(r[T], 3);
}

template <kanexpr::units::unit in, class Quantity>
constexpr bool converts(const Quantity&) {
  return compiled::units_library<Quantity>::template converts<in>;
}

TEST(mp_units, do_not_convert_to_another_dimension) {
  static_assert(converts<si::kilogram>(2 * msi::gram) && !converts<si::meter>(2 * msi::gram));
  static_assert(converts<si::dimensionless>(2 * msi::degree) && converts<si::radian>(2 * msi::degree));
  static_assert(!converts<si::radian>(2 * (msi::radian / msi::second)));
}

TEST(mp_units, are_in_the_guide) {
#include <docs/guide/quantities/mp_units.cpp>
  EXPECT_DOUBLE_EQ(angle.numerical_value_in(msi::degree), 30);
  EXPECT_EQ(p[c], 0.1);
  EXPECT_EQ(rate.numerical_value_in(msi::radian / mp_units::pow<2>(msi::second)), eom::udot(x, p, r)(0));
  EXPECT_EQ(torque.numerical_value_in(msi::newton * msi::metre), 3);
  EXPECT_EQ(p[m], 2.5);
  EXPECT_EQ(p[l], 0.5);
}

TEST(mp_units, give_values_in_lists) {
  const std::vector<named_value> start{{q, 90 * msi::degree}, {u, 0}, {"c", 0.1}};
  EXPECT_DOUBLE_EQ(start[0].value, std::numbers::pi / 2);
  EXPECT_EQ(start[0].what.name(), "q");
}

TEST(mp_units, express_results) {
  const eom::state x{{q, std::numbers::pi / 4}, {u, 2}};
  const mp::quantity<msi::degree, double> angle = mp_quantity(x, q);
  EXPECT_DOUBLE_EQ(angle.numerical_value_in(msi::degree), 45);
  EXPECT_EQ(mp_quantity(x, u).numerical_value_in(msi::radian / msi::second), 2);
  const mp::quantity<msi::joule, double> energy = mp_quantity<si::joule>(3);
  EXPECT_EQ(energy.numerical_value_in(msi::newton * msi::metre), 3);
  EXPECT_EQ(mp_quantity<si::dimensionless>(4).numerical_value_in(mp::one), 4);
}

} // namespace
