// builds: clang++ all
// The units of a model in tables, CSV files and the columns of studies.
#include "runtime/cart_with_units.hpp"
#include "simulations/falling_ball.hpp"
#include "units/pendulum_on_cart.hpp"

#include <kanexpr/ensemble.hpp>
#include <kanexpr/ensembles/study_columns.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/trajectory/model_trajectory.hpp>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using names = std::vector<std::string>;

template <class System>
trajectory<System> two_samples() {
  trajectory<System> path{parameter_values<System>()};
  for (const double t : {0.0, 0.5}) path.add({t, state<System>(), input_values<System>::Zero()});
  return path;
}

std::string header_of(const table& all) {
  std::ostringstream out;
  EXPECT_TRUE(write_csv(all, out));
  return out.str().substr(0, out.str().find('\n'));
}

TEST(units, are_those_of_the_columns_of_a_trajectory) {
  const table cart = two_samples<pendulum_on_cart::System>().table();
  EXPECT_EQ(cart.names(), (names{"t", "s", "q", "v", "u", "F"}));
  EXPECT_EQ(cart.units(), (names{"s", "m", "rad", "m/s", "rad/s", "N"}));
  EXPECT_EQ(header_of(cart), "t [s],s [m],q [rad],v [m/s],u [rad/s],F [N]");
  EXPECT_EQ(header_of(two_samples<falling_ball::System>().table()), "t,h,v") << "no units";
}

TEST(units, are_those_of_a_model_that_a_builder_built) {
  model m = derive(cart_with_units());
  ASSERT_EQ(m.mistake(), "");
  trajectory<model> path(m, parameter_values<model>(m));
  path.add({0, state<model>(m), input_values<model>(m)});
  EXPECT_EQ(header_of(path.table()), "t [s],s [m],q [rad],v [m/s],u [rad/s],F [N]");
}

TEST(units, are_those_of_the_columns_of_a_study) {
  using namespace pendulum_on_cart;
  study<System> varied{.runs = grid({{l, {0.5, 1}}, {factor{"push"}, {1, 2}}}),
                       .state = {{s, 0}, {q, 0.1}, {v, 0}, {u, 0}},
                       .parameters = {{m, 2}, {g, 9.81}, {k, 5}},
                       .inputs = {{F, 0}},
                       .keep_end_state = true,
                       .keep_trajectories = true,
                       .units = {{factor{"push"}, "N s"}, {q, "radian"}}};
  using columns = ensembles::study_columns<ensembles::simulation_kind<System>>;
  const study_layout all = columns::layout_of(varied);
  const auto units_of = [](const std::vector<column_label>& labels) {
    names units;
    for (const column_label& each : labels) units.push_back(each.unit);
    return units;
  };
  EXPECT_EQ(units_of(all.columns), (names{"", "", "s", "m", "N s", "m", "radian", "m/s", "rad/s"}));
  EXPECT_EQ(units_of(all.state), (names{"m", "radian", "m/s", "rad/s"}));
  EXPECT_EQ(units_of(all.samples), (names{"s", "m", "radian", "m/s", "rad/s", "N"}));
  names constants;
  for (const constant_of_runs& each : all.constants) constants.push_back(each.what.unit);
  EXPECT_EQ(constants, (names{"m", "radian", "m/s", "rad/s", "kg", "m/s²", "N/m", "N"}));
  EXPECT_TRUE(all.has_units());

  using plain = ensembles::study_columns<ensembles::simulation_kind<falling_ball::System>>;
  const study_layout none = plain::layout_of({.runs = grid({{falling_ball::m, {0.5, 1}}})});
  EXPECT_EQ(units_of(none.columns), (names{"", "", "s", ""}));
  EXPECT_FALSE(none.has_units());
}

} // namespace
