// builds: clang++
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/numeric/beams/modes.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/building/beam_data.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace {

using namespace kanexpr::units::si;
using kanexpr::derive;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;
using quantity = kanexpr::mechanics::quantity;

/// A pendulum on a cart: x points to the right, y down.
struct cart {
  builder b{"N"};
  expression x = b.coordinate("x", meter), q = b.coordinate("q"), v = b.speed("v"), u = b.speed("u");
  expression m = b.parameter("m", kilogram), l = b.parameter("l", meter),
             k = b.parameter("k", newton / meter), g = b.parameter("g"), c = b.parameter("c"),
             w = b.parameter("w"), I = b.parameter("I");
  expression F = b.input("F", newton), T = b.input("T");
  frame_id N = builder::inertial_frame(), A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  point_id O = b.origin("O"), C = b.offset("C", O, b.along(N, x, 0, 0)),
           P = b.offset("P", C, b.along(A, 0, l, 0));

  cart() {
    b.kinematic_equation(b.dot(x) - v), b.kinematic_equation(b.dot(q) - u);
    b.particle("Cart", C, m), b.particle("Bob", P, m);
    for (const expression& e : {k, g, c, w, I, F, T}) b.used_elsewhere(e);
  }
  /// The unit of a symbol as text.
  std::string unit_of(const char* symbol) const { return std::string(text_of(b.units().of(symbol)).view()); }
};

TEST(units, follow_from_others) {
  cart s;
  s.b.gravity(s.b.along(s.N, 0, s.g, 0));
  s.b.force(s.C, s.b.along(s.N, s.F - s.c * s.v, s.b.number(2), 0));
  s.b.torque(s.A, s.b.along(s.N, 0, 0, s.T * sin(s.w * s.b.time()) - s.I * s.u * s.u));
  EXPECT_EQ(std::string((s.b.check)().view()), "");
  for (const auto& [symbol, unit] : {std::pair{"x", "m"},
                                     {"q", "rad"},
                                     {"v", "m/s"},
                                     {"u", "rad/s"},
                                     {"g", "m/s²"},
                                     {"c", "N s/m"},
                                     {"w", "rad/s"},
                                     {"T", "N m"},
                                     {"I", "kg m²"}})
    EXPECT_EQ(s.unit_of(symbol), unit) << symbol;
  EXPECT_EQ(s.b.unit_of(s.l * s.u), meter * radian / second);
  EXPECT_EQ(s.b.unit_of(s.b.number(2)), std::nullopt);
}

TEST(units, are_written_as_engineers_do) {
  cart s;
  s.b.torsional_spring(s.q, s.w);
  kanexpr::mechanics::known_motion known(s.b.mechanism());
  s.b.force(s.P, s.c * kanexpr::mechanics::velocity_of_point(known.moving(), place(s.P)));
  s.b.force(s.C, s.b.along(s.N, s.g * s.u, 0, 0));
  EXPECT_EQ(std::string((s.b.check)().view()), "");
  EXPECT_EQ(s.unit_of("w"), "N m/rad");
  EXPECT_EQ(s.unit_of("c"), "N s/m");
  EXPECT_EQ(s.unit_of("g"), "N s/rad");
}

TEST(units, of_coordinates_follow_from_angles_also_in_energies) {
  builder b("N");
  const expression q = b.coordinate("q"), x = b.coordinate("x", meter);
  b.rates_as_speeds();
  const expression m = b.parameter("m", kilogram), I = b.parameter("I"), l = b.parameter("l"),
                   g = b.parameter("g"), v = b.dot(x), u = b.dot(q);
  b.lagrangian(m * v * v / 2 + I * u * u / 2 + m * l * cos(q) * u * v + m * g * l * cos(q));
  EXPECT_EQ(std::string((b.check)().view()), "");
  for (const auto& [symbol, unit] : {std::pair{"q", "rad"}, {"I", "kg m²"}, {"l", "m"}, {"g", "m/s²"}})
    EXPECT_EQ(std::string(text_of(b.units().of(symbol)).view()), unit) << symbol;
}

TEST(units, stay_open_where_nothing_determines_them) {
  cart s;
  s.b.potential_energy(s.c * s.w * s.l);
  EXPECT_EQ(std::string((s.b.check)().view()), "");
  EXPECT_EQ(s.unit_of("c"), "not determined");
  EXPECT_EQ(s.b.unit_of(s.c * s.w), newton);
  EXPECT_EQ(s.unit_of("nobody"), "not determined");
}

TEST(units, of_results_follow_from_the_speeds) {
  cart s;
  s.b.gravity(s.b.along(s.N, 0, s.g, 0));
  auto model = derive(s.b);
  const auto of = [&](quantity wanted, int row = 0, int column = 0) {
    return std::string(text_of(model.unit_of(wanted, row, column)).view());
  };
  EXPECT_EQ(of(quantity::udot), "m/s²");
  EXPECT_EQ(of(quantity::udot, 1), "rad/s²");
  EXPECT_EQ(of(quantity::mass_matrix), "kg");
  EXPECT_EQ(of(quantity::mass_matrix, 0, 1), "kg m");
  EXPECT_EQ(of(quantity::mass_matrix, 1, 1), "kg m²");
  EXPECT_EQ(of(quantity::forcing, 1), "N m");
  EXPECT_EQ(of(quantity::rhs, 3), "rad/s²");
  EXPECT_EQ(of(quantity::generalized_momenta, 1), "kg m²/s");
  EXPECT_EQ(of(quantity::kinetic_energy), "N m");
  EXPECT_EQ(of(quantity::state_matrix, 3, 0), "rad/(m s²)");
  EXPECT_EQ(of(quantity::input_matrix, 2, 0), "1/kg");
  EXPECT_EQ(of(quantity::weighted_gradient), "not determined");
  EXPECT_EQ(of(quantity::udot, 7), "not determined");
}

TEST(units, are_not_inferred_unless_one_is_stated) {
  builder b("N");
  const expression q = b.coordinate("q"), u = b.speed("u"), m = b.parameter("m");
  b.kinematic_equation(b.dot(q) - u);
  const point_id O = b.origin("O"), P = b.offset("P", O, b.along(builder::inertial_frame(), q, 0, 0));
  b.particle("Bob", P, m);
  b.force(P, b.along(builder::inertial_frame(), sin(q) + q * q, 0, 0));
  EXPECT_EQ(std::string((b.check)().view()), "");
  EXPECT_EQ(derive(b).unit_of(quantity::udot), std::nullopt);
}

TEST(units, of_amplitudes_are_lengths_and_angles) {
  using namespace kanexpr::runtime;
  using kanexpr::numeric::beams::ends;
  for (const bool has_torsion_unit : {false, true}) {
    builder b("N");
    const point_id O = b.origin("O");
    const frame_id N = builder::inertial_frame();
    std::vector<expression> q;
    for (const char* name : {"bending", "torsion", "extension"}) {
      const bool has_unit = has_torsion_unit && name[0] == 't';
      q.push_back(has_unit ? b.coordinate(name, meter) : b.coordinate(name));
    }
    const expression EI = b.parameter("EI"), GJ = b.parameter("GJ"), EA = b.parameter("EA"),
                     L = b.parameter("L"), density = b.parameter("density", kilogram / meter),
                     polar = b.parameter("polar");
    for (const char* name : {"u1", "u2", "u3"}) b.speed(name);
    for (int i = 0; i < 3; ++i)
      b.kinematic_equation(b.dot(q[static_cast<std::size_t>(i)]) - b.mechanism().speeds[i]);
    beam_data data{.axis = b.along(N, 1, 0, 0), .length = L, .mass_per_length = density};
    data.bending = {{b.along(N, 0, 1, 0), {EI, modes_of_bending(ends::clamped_free, 1)}}};
    data.torsion = {.polar_inertia = polar, .by = {GJ, modes_of_rod(ends::clamped_free, 1)}};
    data.extension = {EA, modes_of_rod(ends::clamped_free, 1)};
    b.beam("B", O, N, q, data);
    const std::string mistake((b.check)().view());
    EXPECT_EQ(mistake, has_torsion_unit ? "an amplitude of beam B is torsion [m], but must be in rad" : "");
    if (has_torsion_unit) continue;
    for (const auto& [symbol, unit] : {std::pair{"bending", "m"},
                                       {"torsion", "rad"},
                                       {"extension", "m"},
                                       {"u1", "m/s"},
                                       {"u2", "rad/s"},
                                       {"GJ", "N m²"}})
      EXPECT_EQ(std::string(text_of(b.units().of(symbol)).view()), unit) << symbol;
  }
}

// Numbers by which amplitudes are multiplied are slopes and other values of shapes, which have units.
TEST(units, of_amplitudes_fit_in_angles_of_sections) {
  using namespace kanexpr::runtime;
  using kanexpr::numeric::beams::ends;
  builder b("N");
  const frame_id N = builder::inertial_frame();
  const expression q = b.coordinate("q"), u = b.speed("u"), F = b.input("F", newton), k = b.parameter("k");
  b.kinematic_equation(b.dot(q) - u);
  beam_data data{.axis = b.along(N, 1, 0, 0), .length = 2.5, .mass_per_length = 3.0};
  data.bending = {{b.along(N, 0, 1, 0), {70.0, modes_of_bending(ends::clamped_free, 1)}}};
  const section_ids tip = b.section("Tip", b.beam("B", b.origin("O"), N, {q}, data), 1);
  const expression turned = b.dot(b.along(tip.frame, 1, 0, 0), b.along(N, 1, 0, 0));
  b.force(tip.point, b.along(N, 0, F * turned - k * q, 0));
  EXPECT_EQ(std::string((b.check)().view()), "");
  EXPECT_EQ(b.units().of("q"), meter);
  EXPECT_EQ(b.units().of("u"), meter / second);
  EXPECT_EQ(b.units().of("k"), newton / meter);
  b.force(tip.point, b.along(N, 0, F * q, 0));
  EXPECT_EQ(std::string((b.check)().view()), "the force at Tip is F*q [N m], but must be in N");
}

// Powers that are no multiples of 1/60 are rounded to compare them, but not shown.
TEST(units, of_any_power_are_compared) {
  cart s;
  const expression eighth = power(s.x / s.l, s.b.number(0.125)), h = s.b.parameter("h");
  s.b.used_elsewhere(h);
  s.b.force(s.C, s.b.along(s.N, h * power(s.x, s.b.number(2.37)), 0, 0));
  s.b.force(s.C, s.b.along(s.N, s.F * eighth * power(s.x, s.b.number(1.234)) * power(s.x, s.b.number(-1.234)),
                           0, 0));
  expression x_by_roots = power(s.x, s.b.number(0.125));
  for (int i = 1; i < 8; ++i) x_by_roots = x_by_roots * power(s.x + i * s.l, s.b.number(0.125));
  s.b.force(s.C, s.b.along(s.N, s.k * x_by_roots, 0, 0));
  EXPECT_EQ(std::string((s.b.check)().view()), "");
  EXPECT_EQ(s.unit_of("h"), "not determined");
}

/// A wrong model: the mistake and its sentence.
struct wrong {
  void (*is_made)(cart&);
  const char* sentence;
};

constexpr auto along_x = [](cart& s, expression e) { return s.b.along(s.N, e, 0, 0); };
constexpr auto about_z = [](cart& s, expression e) { return s.b.along(s.N, 0, 0, e); };
constexpr auto push = [](cart& s, expression e) { s.b.force(s.C, along_x(s, e)); };
constexpr auto turn = [](cart& s, expression e) { s.b.torque(s.A, about_z(s, e)); };

const wrong mistakes[]{
    {[](cart& s) { push(s, s.k); }, "the force at C is k [N/m], but must be in N"},
    {[](cart& s) { push(s, s.F + s.k); }, "the force at C adds k [N/m] and F [N]"},
    {[](cart& s) { push(s, s.F - s.k * s.l * s.l); }, "the force at C subtracts k*l^2 [N m] from F [N]"},
    {[](cart& s) { push(s, s.m * s.v * s.v); }, "the force at C is m*v^2 [N m], but must be in N"},
    {[](cart& s) { s.b.gravity(along_x(s, s.k)); }, "gravity is k [N/m], but must be in m/s^2"},
    {[](cart& s) { turn(s, s.F); }, "the torque on A is F [N], but must be in N m"},
    {[](cart& s) { turn(s, s.m * s.l * s.l * s.u); },
     "the torque on A is l^2*m*u [kg m^2 rad/s], but must be in N m"},
    {[](cart& s) { s.b.force_between(s.C, s.P, along_x(s, s.l)); },
     "the force between C and P is l [m], but must be in N"},
    {[](cart& s) { s.b.torque_between(s.A, s.N, about_z(s, s.m)); },
     "the torque between A and N is m [kg], but must be in N m"},
    {[](cart& s) { s.b.spring(s.O, s.P, s.F); },
     "the stiffness of the spring between O and P is F [N], but must be in N/m"},
    {[](cart& s) { s.b.spring(s.O, s.P, s.k, s.m); },
     "the natural length of the spring between O and P is m [kg], but must be in m"},
    {[](cart& s) { s.b.damper(s.O, s.P, s.k); },
     "the damping between O and P is k [N/m], but must be in N s/m"},
    {[](cart& s) { s.b.torsional_damper(s.A, s.N, s.k); },
     "the torsional damping between A and N is k [N/m], but must be in N m s/rad"},
    {[](cart& s) { s.b.torsional_spring(s.q, s.T, s.l); },
     "the torsional spring with q subtracts l [m] from q [rad]"},
    {[](cart& s) { s.b.torsional_spring(s.q, s.k); },
     "the stiffness of the torsional spring with q is k [N/m], but must be in N m/rad"},
    {[](cart& s) { s.b.force_along(s.b.straight(s.O, s.P), s.k); },
     "the force between O and P is k [N/m], but must be in N"},
    {[](cart& s) { s.b.force_along(s.b.given_length(s.q), s.F); },
     "the force with q is F [N], but must be in N m"},
    {[](cart& s) { s.b.force_along(s.b.around_sphere(s.O, s.m, s.C, s.P), s.F); },
     "the surface of the force between C and P is m [kg], but must be in m"},
    {[](cart& s) { s.b.linear_spring(s.b.through({s.O, s.C, s.P}), s.F); },
     "the stiffness of the linear spring between O and P is F [N], but must be in N/m"},
    {[](cart& s) { s.b.cubic_spring(s.b.straight(s.O, s.P), s.k, s.k); },
     "the cubic stiffness of the cubic spring between O and P is k [N/m], but must be in N/m^3"},
    {[](cart& s) { s.b.linear_damper(s.b.given_length(s.q), s.k); },
     "the damping of the linear damper with q is k [N/m], but must be in N m s/rad"},
    {[](cart& s) { s.b.stop(s.b.given_length(s.q), s.b.number(-1), s.b.number(2), s.k, s.b.number(1)); },
     "the stiffness of the stop with q is k [N/m], but must be in N m/rad"},
    {[](cart& s) { s.b.stop(s.b.given_length(s.x), s.b.number(-1), s.m, s.k, s.b.number(1)); },
     "the greatest length of the stop with x is m [kg], but must be in m"},
    {[](cart& s) {
       const expression one = s.b.number(1);
       s.b.bushing(s.A, s.P, s.N, s.O, {s.k, s.k, s.F, one, one, one});
     },
     "a stiffness of the bushing between A and N is F [N], but must be in N/m"},
    {[](cart& s) { s.b.potential_energy(s.m * s.l); },
     "potential energy 1 is l*m [kg m], but must be in N m"},
    {[](cart& s) { s.b.particle("Third", s.P, s.l); }, "the mass of Third is l [m], but must be in kg"},
    {[](cart& s) { s.b.rigid_body("Rod", s.P, s.A, s.m, s.b.inertia(s.A, s.m * s.l, s.I, s.I)); },
     "the inertia of Rod is l*m [kg m], but must be in kg m^2"},
    {[](cart& s) { s.b.offset("Q", s.P, s.b.along(s.A, 0, s.m, 0)); },
     "the offset of point Q is m [kg], but must be in m"},
    {[](cart& s) { s.b.rotated("B", s.A, s.x, s.b.along(s.A, 0, 0, 1)); },
     "the angle of frame B is x [m], but must be in rad"},
    {[](cart& s) { s.b.rotated("B", s.A, s.q + s.l, s.b.along(s.A, 0, 0, 1)); },
     "the angle of frame B adds q [rad] and l [m]"},
    {[](cart& s) { push(s, s.F * sin(s.x)); }, "the force at C contains sin(x); x [m] is not an angle"},
    {[](cart& s) { push(s, s.F * exp(-s.l)); }, "the force at C contains exp(-l); -l [m] is not a number"},
    {[](cart& s) { push(s, s.F * atan2(s.x, s.m)); }, "the force at C takes the atan2 of x [m] and m [kg]"},
    {[](cart& s) { push(s, s.F * tanh(s.v)); }, "the force at C contains tanh(v); v [m/s] is not a number"},
    {[](cart& s) { push(s, s.k * sqrt(s.x)); }, "the force at C is k*sqrt(x) [N/m^(1/2)], but must be in N"},
    {[](cart& s) { push(s, s.F * abs(s.x)); }, "the force at C is F*abs(x) [N m], but must be in N"},
    {[](cart& s) { push(s, (kanexpr::symbolic::max)(s.F, s.x)); }, "the force at C compares F [N] and x [m]"},
    {[](cart& s) { push(s, s.F * s.b.time()); }, "the force at C is F*t [kg m/s], but must be in N"},
    {[](cart& s) { push(s, s.F * power(s.x, s.w)); }, "the force at C contains x^w; x [m] is not a number"},
    {[](cart& s) { push(s, s.c * s.x), push(s, s.c * s.v); },
     "the force at C is c*v [N/s], but must be in N"},
    {[](cart& s) { push(s, s.c), turn(s, s.c); },
     "the torque on A is c [N], but must be in N m; c is in N by the force at C"},
    {[](cart& s) { push(s, s.F * (s.c + s.c * s.l)); },
     "the force at C adds c and c*l, whose units differ by a factor of m"},
    {[](cart& s) { push(s, s.F * s.b.prescribed("h", meter) / s.b.prescribed("p", second)); },
     "the force at C is F*h/p [W], but must be in N"},
    {[](cart& s) { push(s, s.m * 9.81); },
     "the force at C is 9.81*m [kg], but must be in N; the factor 9.81 has no unit"},
    {[](cart& s) { push(s, s.k * s.b.dot(s.b.prescribed("h", meter))); },
     "the force at C is k*h' [N/s], but must be in N"},
    {[](cart& s) { s.b.configuration_constraint(s.x - s.m); },
     "a configuration constraint equates x [m] and m [kg]"},
    {[](cart& s) { s.b.configuration_constraint(s.x - s.l * s.l); },
     "a configuration constraint equates x [m] and l^2 [m^2]"},
    {[](cart& s) { s.b.velocity_constraint(s.v - s.u); },
     "a velocity constraint equates v [m/s] and u [rad/s]"},
    {[](cart& s) { push(s, s.F * kanexpr::symbolic::smooth_abs(s.v, s.b.number(0.01)) / s.v); },
     "the force at C contains tanh(100*v); 100*v [m/s] is not a number; the factor 100 has no unit"},
    {[](cart& s) { push(s, s.k * power(s.x, s.b.number(2.37))); },
     "the force at C is k*x^2.37 [N m^(41/30)], but must be in N"},
    {[](cart& s) { push(s, s.b.parameter("h", pow<1, 60>(pow<1, 60>(meter))) * s.F); },
     "the unit stated for h is out of range; its powers must be multiples of 1/60 between -273 and 273"},
    {[](cart& s) { s.b.modified_rodrigues("B", s.N, s.l, s.b.number(0.0), s.b.number(0.0)); },
     "a modified Rodrigues parameter of frame B is l [m], but must be a number"},
    {[](cart& s) { s.b.acceleration_constraint(s.b.dot(s.v) - s.u); },
     "an acceleration constraint equates v' [m/s^2] and u [rad/s]"},
};

// Searching every occurrence of a shared part would take 2^60 steps.
TEST(units, that_do_not_fit_are_found_in_expressions_with_many_shared_parts) {
  cart s;
  expression e = s.v;
  for (int i = 0; i < 60; ++i) {
    const expression turned = e * cos(s.q);
    const expression bent = s.v * tanh(e / s.v);
    e = turned + bent;
  }
  push(s, e);
  const std::string mistake((s.b.check)().view());
  EXPECT_TRUE(mistake.starts_with("the force at C is ")) << mistake;
  EXPECT_TRUE(mistake.ends_with(" [m/s], but must be in N")) << mistake;
  cart other;
  expression square = cos(other.q);
  for (int i = 0; i < 60; ++i) square = square * square;
  push(other, square);
  EXPECT_TRUE(std::string((other.b.check)().view()).ends_with(", but must be in N"));
}

TEST(units, that_do_not_fit_are_one_sentence) {
  for (const wrong& each : mistakes) {
    cart s;
    each.is_made(s);
    EXPECT_EQ(std::string((s.b.check)().view()), each.sentence);
  }
  EXPECT_GE(std::size(mistakes), 30u);
}

} // namespace
