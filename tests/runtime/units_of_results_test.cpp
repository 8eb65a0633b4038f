// builds: clang++
// The units of results, compared with what happens to the numbers if the units of length, mass and time
// change.
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/base_parameters.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace {

using namespace kanexpr;
using namespace kanexpr::units::si;
using mechanics::quantity;
using runtime::builder;
using runtime::frame_id;
using runtime::point_id;
using symbolic::expression;

/// The number by which the value of a quantity grows if the kilogram, the meter and the second shrink.
double growth(const units::unit& u) {
  const auto power = [&](double of, units::base_unit base) {
    return std::pow(of, u[base] / static_cast<double>(units::unit::parts));
  };
  return power(1.7, units::base_unit::kilogram) * power(0.6, units::base_unit::meter) *
         power(2.3, units::base_unit::second);
}

/// Evaluates all results in both systems of units; returns those whose units are known.
std::set<std::string> compare_results(const builder& b) {
  model m = derive(b);
  EXPECT_EQ(m.mistake(), "");
  const auto known = m.known();
  const int rates = known->coordinates, parameters = rates + known->speeds,
            inputs = parameters + known->parameters;
  Eigen::VectorXd in_si(known->symbols()), grown(known->symbols()), a(known->speeds), a_grown(known->speeds);
  for (int i = 0; i < known->symbols(); ++i) {
    const mechanics::possible_unit u = m.units().of(known->names[i].view());
    EXPECT_TRUE(u.has_value()) << known->names[i].view();
    in_si[i] = 0.4 + 0.37 * std::sin(3. * i + 1);
    grown[i] = in_si[i] * growth(u.has_value() ? *u : units::dimensionless);
  }
  for (int i = 0; i < known->speeds; ++i) {
    a[i] = 0.3 + 0.2 * std::cos(2. * i);
    a_grown[i] = a[i] * grown[rates + i] / in_si[rates + i] / 2.3;
  }
  std::set<std::string> compared;
  for (const mechanics::result_row& each : mechanics::results) {
    m = derive(b); // without the mistake in the last result
    const symbolic::matrix found = m.get(each.is);
    if (!m.mistake().empty() || found.rows * found.columns == 0 || each.takes_weights || each.takes_direction)
      continue;
    auto f = m.function(found);
    const auto at = [&](const Eigen::VectorXd& all, const Eigen::VectorXd& accelerations) {
      const Eigen::VectorXd x = all.head(parameters), p = all.segment(parameters, known->parameters),
                            r = all.tail(all.size() - inputs);
      return each.holds_speed_rates ? f(0, x, p, r, accelerations) : f(0, x, p, r);
    };
    const Eigen::MatrixXd before = at(in_si, a), after = at(grown, a_grown);
    for (int i = 0; i < found.rows; ++i)
      for (int j = 0; j < found.columns; ++j) {
        const mechanics::possible_unit u = m.unit_of(each.is, i, j);
        if (!u) continue;
        compared.insert(std::string(each.called) + (each.is == quantity::implicit_state_matrix ? " A" : ""));
        const double wanted = before(i, j) * growth(*u);
        EXPECT_NEAR(after(i, j), wanted, 1e-12 * (1 + std::abs(wanted)))
            << each.called << ' ' << i << ' ' << j << ' ' << text_of(*u).view();
      }
  }
  return compared;
}

/// A rod that hangs from a cart, with a spring, a motor, and optionally constraints.
struct crane {
  builder b{"N"};
  expression x = b.coordinate("x", meter), q = b.coordinate("q", radian), y = b.coordinate("y", meter), v{},
             u{}, w{};
  expression m = b.parameter("m", kilogram), l = b.parameter("l", meter),
             I = b.parameter("I", kilogram* pow<2>(meter)), k = b.parameter("k", newton / meter),
             g = b.parameter("g", meter / pow<2>(second)), F = b.input("F", newton);
  frame_id N = builder::inertial_frame();
  frame_id A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  point_id O = b.origin("O"), C = b.offset("C", O, b.along(N, x, y, 0)),
           P = b.offset("P", C, b.along(A, 0, l, 0));

  /// With Kane's method, w is in rad/s although y is a length.
  explicit crane(bool by_lagrange) {
    if (by_lagrange) {
      b.rates_as_speeds();
      v = b.dot(x), u = b.dot(q), w = b.dot(y);
    } else {
      v = b.speed("v"), u = b.speed("u"), w = b.speed("w");
      b.kinematic_equation(b.dot(x) - v), b.kinematic_equation(m * (b.dot(q) - u));
      b.kinematic_equation(b.dot(y) - l * w);
    }
    b.particle("Cart", C, 2 * m);
    b.rigid_body("Rod", P, A, m, b.inertia(A, I, I, I));
    b.gravity(b.along(N, 0, g, 0));
    b.force(C, b.along(N, F - k * x, 0, 0));
  }
};

TEST(units, of_all_results_agree_with_a_change_of_units) {
  const std::set<std::string> compared = compare_results(crane(false).b);
  for (const char* each : {"mass_matrix", "forcing", "mass_matrix_full", "forcing_full", "rhs", "regressor",
                           "inertial_parameters", "kinetic_energy", "explicit_form", "jacobian",
                           "implicit_form", "implicit_form A"})
    EXPECT_TRUE(compared.contains(each)) << each;
  EXPECT_TRUE(compare_results(crane(true).b).contains("coriolis"));
}

TEST(units, of_constrained_systems_agree_with_a_change_of_units) {
  crane by_kane(false), by_lagrange(true);
  by_kane.b.configuration_constraint(by_kane.y - by_kane.l * sin(by_kane.q));
  by_kane.b.velocity_constraint(by_kane.v - by_kane.l * by_kane.u);
  by_lagrange.b.configuration_constraint(by_lagrange.y * by_lagrange.y - by_lagrange.l * by_lagrange.x);
  for (crane* each : {&by_kane, &by_lagrange}) {
    const std::set<std::string> compared = compare_results(each->b);
    for (const char* result : {"mass_matrix_full", "forcing_full", "multipliers", "dependency",
                               "configuration_step", "constraint_jacobian", "implicit_form", "regressor"})
      EXPECT_TRUE(compared.contains(result)) << result;
  }
}

TEST(units, of_base_parameters_are_those_of_their_columns) {
  crane s(false);
  model m = derive(s.b);
  const Eigen::VectorXd p = Eigen::VectorXd::Constant(5, 0.7);
  const base_parameters base = find_base_parameters(m, p);
  ASSERT_TRUE(base) << base.cause();
  ASSERT_EQ(base.units.size(), base.names.size());
  std::string listed;
  for (std::size_t i = 0; i < base.names.size(); ++i)
    listed += base.names[i] + " [" + std::string(text_of(base.units[i]).view()) + "]\n";
  EXPECT_EQ(listed, "m of Cart + m of Rod [kg]\nm*x of Rod [kg m]\nm*y of Rod [kg m]\nizz of Rod [kg m²]\n");
}

} // namespace
