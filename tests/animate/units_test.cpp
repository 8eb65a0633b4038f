// builds: clang++ all
// The units of a model on pages.
#include "animate/samples.hpp"
#include "units/pendulum_on_cart.hpp"

#include <kanexpr/animate.hpp>
#include <kanexpr/animate/picture_of.hpp>
#include <kanexpr/kanexpr.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace pendulum_on_cart;
using names = std::vector<std::string>;

tests::samples<System> motion() {
  tests::samples<System> run;
  run.p[m] = 1, run.p[l] = 0.5, run.p[g] = 9.81, run.p[k] = 3;
  for (const double t : {0.0, 1.0}) {
    tests::sample<System> one;
    one.t = t;
    one.x[q] = 0.3 * t;
    one.r[F] = 1;
    run.all.push_back(one);
  }
  return run;
}

names units_of_columns(const animation& a) {
  names all;
  for (const animation::column& c : a.columns) all.push_back(c.name + " [" + c.unit + "]");
  return all;
}

using shown = picture<System, up<-1 * N::x>, show<rod<C, P, 0.02>>, show_forces<>, show_velocities<>,
                      show<arrow<P, angular_velocity_of<A>>, named<"turning">>,
                      show<arrow<P, position_of<P, C>>, named<"rod">, unit<"metres">>, plot_energies<>,
                      plot<"height", dot(position_of<P, O>, N::x)>, plot<"pull", k * s, "newton">,
                      in_unit<"metres", s>>;

TEST(units, of_a_model_are_those_of_its_page) {
  const animation a = animated<shown>(motion());
  ASSERT_TRUE(a) << a.cause();
  EXPECT_EQ(units_of_columns(a),
            (names{"s [metres]", "q [rad]", "v [m/s]", "u [rad/s]", "F [N]", "kinetic energy [J]",
                   "potential energy [J]", "total energy [J]", "height [m]", "pull [newton]"}));
  names arrows;
  for (const animation::shape& each : a.shapes)
    if (each.kind == "arrow") arrows.push_back(each.name + " [" + each.unit + "]");
  EXPECT_EQ(arrows,
            (names{"force at C [N]", "weight of Cart [N]", "weight of Bob [N]", "velocity of Cart [m/s]",
                   "velocity of Bob [m/s]", "turning [rad/s]", "rod [metres]"}));
}

TEST(units, of_a_model_are_those_of_its_default_page) {
  const animation a = animated<picture_of<System>>(motion());
  ASSERT_TRUE(a) << a.cause();
  EXPECT_EQ(units_of_columns(a), (names{"s [m]", "q [rad]", "v [m/s]", "u [rad/s]", "F [N]"}));
}

} // namespace
