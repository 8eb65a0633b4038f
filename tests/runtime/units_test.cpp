// The same mechanisms in meters, millimeters and micrometers, kilograms and nanograms: the results agree.
#include "four_bars.hpp"
#include "models/n_pendulum_cart.hpp"
#include "models/pendulum_nonminimal.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/symbolic.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace {

using Eigen::VectorXd;
using kanexpr::mechanics::equations;
using kanexpr::mechanics::quantity;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;

// The number of new units in an old one.
struct units {
  double length, mass, time;
};
const std::vector<units> binary{
    {0x1p-40, 1, 1}, {0x1p40, 1, 1}, {1, 0x1p-40, 1}, {1, 1, 0x1p20}, {0x1p-40, 0x1p40, 0x1p-20}};
const std::vector<units> decimal{{1e-3, 1, 1},     {1e-6, 1e-9, 1}, {1e-9, 1, 1},      {1e-12, 1, 1},
                                 {1e-12, 1e12, 1}, {1e12, 1, 1},    {1e6, 1e12, 1e-3}, {1, 1, 1e6}};

// A crank of 0.3, a rod of 1.1 and a slider, whose lengths and masses are numbers.
struct slider_crank : builder {
  explicit slider_crank(const units& in) : builder("N") {
    const expression turn = coordinate("turn"), swing = coordinate("swing"), way = coordinate("way");
    const expression w1 = speed("w1"), w2 = speed("w2"), v = speed("v");
    const expression zero = number(0.0), crank = number(0.3 * in.length), rod = number(1.1 * in.length);
    const frame_id n = inertial_frame(), a = rotated("A", n, turn, along(n, 0, 0, 1)),
                   b = rotated("B", n, swing, along(n, 0, 0, 1));
    const point_id o = origin("O"), pin = offset("Pin", o, along(a, crank, zero, zero)),
                   end = offset("End", pin, along(b, rod, zero, zero)),
                   slider = offset("S", o, along(n, way, zero, zero));
    particle("Pinned", pin, number(0.7 * in.mass));
    particle("Ended", end, number(0.2 * in.mass));
    particle("Slider", slider, number(1.3 * in.mass));
    gravity(along(n, zero, number(-9.81 * in.length / (in.time * in.time)), zero));
    kinematic_equation(dot(turn) - w1);
    kinematic_equation(dot(swing) - w2);
    kinematic_equation(dot(way) - v);
    configuration_constraint(crank * cos(turn) + rod * cos(swing) - way);
    configuration_constraint(crank * sin(turn) + rod * sin(swing));
  }
};

struct motion {
  std::vector<int> coordinates, speeds; // the dependent speeds
  VectorXd udot;                        // in old units
};

std::vector<int> list(const kanexpr::base::sequence<int>& all) { return {all.begin(), all.end()}; }

motion of_slider_crank(const units& in) {
  slider_crank b(in);
  EXPECT_EQ(b.check().view(), "");
  equations derived(b.system());
  derived.constrain();
  EXPECT_EQ(derived.mistake().view(), "");
  const kanexpr::symbolic::matrix udot = derived.get(quantity::udot);
  kanexpr::base::sequence<int> outputs;
  for (const expression& e : udot.entries) outputs.push(e.node());
  kanexpr::runtime::interpreted<double> f(b.graph(), udot, 3, derived.singularity_checks_of(outputs));
  const double turn = 0.8, swing = -std::asin(0.3 * std::sin(turn) / 1.1), w1 = 1.7,
               w2 = -0.3 * std::cos(turn) * w1 / (1.1 * std::cos(swing));
  VectorXd x(6);
  x << turn, swing, in.length * (0.3 * std::cos(turn) + 1.1 * std::cos(swing)), w1 / in.time, w2 / in.time,
      in.length / in.time * (-0.3 * std::sin(turn) * w1 - 1.1 * std::sin(swing) * w2);
  VectorXd found = f(x);
  EXPECT_TRUE(f.status()) << f.status().cause();
  found *= in.time * in.time;
  found(2) /= in.length;
  return {list(derived.coordinates().dependent), list(derived.speeds().dependent), found};
}

TEST(units, of_a_slider_crank_do_not_matter) {
  const motion plain = of_slider_crank({1, 1, 1});
  EXPECT_EQ(plain.speeds.size(), 2u);
  for (const units& in : binary) {
    const motion m = of_slider_crank(in);
    EXPECT_EQ(m.coordinates, plain.coordinates);
    EXPECT_EQ(m.speeds, plain.speeds);
    EXPECT_EQ(m.udot, plain.udot) << in.length << ' ' << in.mass << ' ' << in.time; // to the last bit
  }
  for (const units& in : decimal) {
    const motion m = of_slider_crank(in);
    EXPECT_EQ(m.coordinates, plain.coordinates);
    EXPECT_EQ(m.speeds, plain.speeds);
    EXPECT_LE((m.udot - plain.udot).norm(), 1e-12 * plain.udot.norm())
        << in.length << ' ' << in.mass << ' ' << in.time;
  }
}

// A repeated constraint, the second time multiplied by a number.
TEST(units, of_a_redundant_constraint_do_not_matter) {
  for (const double scale : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    slider_crank b({scale, 1, 1});
    const expression turn = b.mechanism().coordinates[0], swing = b.mechanism().coordinates[1];
    const expression rod = b.number(1.1 * scale), crank = b.number(0.3 * scale), zero = b.number(0.0);
    b.velocity_constraint(b.number(7e-5) *
                          (crank * cos(turn) * b.dot(turn) + rod * cos(swing) * b.dot(swing) + zero));
    b.velocity_constraint(b.number(3e5) *
                          (crank * cos(turn) * b.dot(turn) + rod * cos(swing) * b.dot(swing) + zero));
    equations derived(b.system());
    derived.constrain();
    EXPECT_EQ(derived.mistake().view(),
              "velocity constraint 2 follows from the preceding ones in every configuration");
  }
}

TEST(units, of_a_four_bar_do_not_matter_to_assembly_and_checks) {
  using namespace four_bar;
  four_bars plain;
  ASSERT_TRUE(kanexpr::assemble<System>(plain.x, plain.p, plain.r));
  for (const double scale : {1e-12, 1e-9, 1e-3, 1e6, 1e12}) {
    four_bars b;
    b.p[l0] *= scale, b.p[l1] *= scale, b.p[l2] *= scale, b.p[l3] *= scale;
    b.x[u1] = 1.4;
    const auto guess = b.x;
    EXPECT_FALSE(kanexpr::check_consistency<System>(guess, b.p, b.r)) << scale;
    const kanexpr::assembly done = kanexpr::assemble<System>(b.x, b.p, b.r);
    ASSERT_TRUE(done) << done.cause();
    EXPECT_LE((b.x - plain.x).norm(), 1e-13) << scale;
    EXPECT_TRUE(kanexpr::check_consistency<System>(b.x, b.p, b.r)) << scale;
    auto off = b.x;
    off[q2] += 1e-8;
    EXPECT_FALSE(kanexpr::check_consistency<System>(off, b.p, b.r)) << scale;
    off = b.x;
    off[u3] += 1e-8;
    EXPECT_FALSE(kanexpr::check_consistency<System>(off, b.p, b.r)) << scale;
    b.p[l0] *= 2; // unreachable
    const kanexpr::assembly none = kanexpr::assemble<System>(b.x, b.p, b.r);
    EXPECT_FALSE(none) << scale;
  }
}

TEST(units, of_lengths_do_not_matter_to_a_pendulum_in_two_coordinates) {
  using namespace pendulum_nonminimal;
  using eom = kanexpr::equations_of_motion<System>;
  auto model = kanexpr::derive<System>();
  for (const double scale : {1e-12, 1e-8, 1.0, 1e6, 1e12}) {
    eom::parameters p;
    p[m] = 1, p[L] = scale, p[g] = 9.81;
    eom::state x = eom::state::Zero();
    x[q1] = 0.5 * scale, x[q2] = 0.6 * scale, x[u2] = 0.3 * scale;
    EXPECT_FALSE(kanexpr::check_consistency<System>(x, p)) << scale;
    ASSERT_TRUE(kanexpr::assemble<System>(x, p)) << scale;
    EXPECT_NEAR(x[q1] / scale, 0.8, 1e-15);
    EXPECT_NEAR(x[u1] / scale, -0.225, 1e-15);
    EXPECT_TRUE(kanexpr::check_consistency<System>(x, p)) << scale;
    EXPECT_TRUE(kanexpr::check_consistency(model, VectorXd(x), p, p)) << scale;
    x[q1] *= 1 + 1e-7;
    EXPECT_FALSE(kanexpr::check_consistency<System>(x, p)) << scale;

    auto hangs = model.linearize({{m, 1}, {L, scale}, {g, 9.81}, {q1, scale}, {q2, 0}, {u1, 0}, {u2, 0}});
    EXPECT_THAT(hangs.failures(), testing::IsEmpty()) << scale;
    auto close = model.linearize(
        {{m, 1}, {L, scale}, {g, 9.81}, {q1, scale * (1 + 1e-12)}, {q2, 0}, {u1, 0}, {u2, 0}});
    EXPECT_THAT(close.failures(), testing::IsEmpty()) << scale;
    auto longer =
        model.linearize({{m, 1}, {L, scale}, {g, 9.81}, {q1, 1.0001 * scale}, {q2, 0}, {u1, 0}, {u2, 0}});
    EXPECT_EQ(longer.failures().size(), 1u) << scale;
  }
}

// A wheel of radius 2, rotated by a, drives a bead at x along a groove whose radius grows with a².
TEST(units, of_lengths_do_not_matter_beside_angles_in_one_constraint) {
  for (const double scale : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    builder b("N");
    const expression a = b.coordinate("a"), x = b.coordinate("x"), c = b.coordinate("c");
    const expression wa = b.speed("wa"), v = b.speed("v"), wc = b.speed("wc");
    const expression zero = b.number(0.0), one = b.number(1), radius = b.parameter("radius"),
                     about = b.number(scale * scale);
    const frame_id n = b.inertial_frame(), wheel = b.rotated("A", n, a, b.along(n, 0, 0, 1)),
                   other = b.rotated("C", n, c, b.along(n, 0, 0, 1));
    const point_id o = b.origin("O"), bead = b.offset("Bead", o, b.along(n, x, zero, zero));
    b.rigid_body("Wheel", o, wheel, one, b.inertia(wheel, about, about, about));
    b.rigid_body("Other", o, other, one, b.inertia(other, about, about, about));
    b.particle("Sliding", bead, one);
    b.gravity(b.along(n, b.number(scale), zero, zero));
    b.kinematic_equation(b.dot(a) - wa);
    b.kinematic_equation(b.dot(x) - v);
    b.kinematic_equation(b.dot(c) - wc);
    b.velocity_constraint(a * a * (radius * wa + v + x * wc));
    ASSERT_EQ(b.check().view(), "");
    equations derived(b.system());
    const kanexpr::symbolic::matrix udot = derived.get(quantity::udot);
    ASSERT_EQ(derived.mistake().view(), "");
    kanexpr::base::sequence<int> outputs;
    for (const expression& e : udot.entries) outputs.push(e.node());
    kanexpr::runtime::interpreted<double> f(b.graph(), udot, 3, derived.singularity_checks_of(outputs));
    VectorXd state(6);
    state << 0.5, 3 * scale, 0.2, 0, 0, 0;
    f(state, VectorXd(VectorXd::Constant(1, 2 * scale)));
    EXPECT_TRUE(f.status()) << scale << ": " << f.status().cause();
    state(0) = 0; // no constraint remains
    f(state, VectorXd(VectorXd::Constant(1, 2 * scale)));
    EXPECT_FALSE(f.status()) << scale;
  }
}

// A slab in the plane with its mass center at d along A.x: the size of symbols relative to a number is
// unknown.
std::string mistake_of_slab(double inertia, bool spins) {
  builder b("N");
  const expression x = b.coordinate("x"), y = b.coordinate("y"), turn = b.coordinate("turn");
  const expression m = b.parameter("m"), d = b.parameter("d"), zero = b.number(0.0);
  const frame_id n = b.inertial_frame(), a = b.rotated("A", n, turn, b.along(n, 0, 0, 1));
  const point_id o = b.origin("O"), p = b.offset("P", o, b.along(n, x, y, zero)),
                 center = b.offset("Center", p, b.along(a, d, zero, zero));
  const expression i = b.number(inertia);
  if (spins)
    b.rigid_body("Slab", center, a, m, b.inertia(a, i, i, i));
  else
    b.particle("Slab", center, m);
  int place = 0;
  for (const char* speed : {"u", "v", "w"})
    b.kinematic_equation(b.dot(b.mechanism().coordinates[place++]) - b.speed(speed));
  EXPECT_EQ(b.check().view(), "");
  equations derived(b.system());
  derived.get(quantity::udot);
  return std::string(derived.mistake().view());
}

TEST(units, of_a_number_beside_symbols_do_not_make_a_mass_matrix_singular) {
  for (const double inertia : {1e-24, 1e-18, 1e-9, 1.0, 1e9, 1e18, 1e24})
    EXPECT_EQ(mistake_of_slab(inertia, true), "") << inertia;
  EXPECT_EQ(
      mistake_of_slab(1, false),
      "speeds u, v and w move the same mass in any configuration: the mass matrix is numerically singular");
}

// An upright rod on a cart twice as heavy as its bob: lengths, masses and angles in one matrix.
TEST(units, do_not_matter_to_a_linearization_in_numbers) {
  using namespace n_pendulum_cart;
  auto model = kanexpr::derive<System<1>>();
  const auto number = [&](const kanexpr::symbolic::matrix& m, int i, int j) {
    return m(i, j).owner().number_at(m(i, j).node()).value();
  };
  for (const double length : {1e-12, 1e-6, 1.0, 1e6, 1e12})
    for (const double mass : {1e-12, 1.0, 1e12}) {
      auto stands = model.linearize({{m<0>, 2 * mass},
                                     {m<1>, mass},
                                     {l<0>, length},
                                     {g, 9.81 * length},
                                     {q<0>, 0},
                                     {q<1>, std::numbers::pi / 2},
                                     {u<0>, 0},
                                     {u<1>, 0},
                                     {F, 0}});
      const auto& found = stands.explicit_form();
      EXPECT_THAT(stands.failures(), testing::IsEmpty()) << length << ' ' << mass;
      EXPECT_NEAR(number(found.A, 2, 1) / length, 9.81 / 2, 1e-12) << length << ' ' << mass;
      EXPECT_NEAR(number(found.A, 3, 1), 9.81 * 1.5, 1e-12) << length << ' ' << mass;
      EXPECT_NEAR(number(found.B, 2, 0) * mass, 1.0 / 2, 1e-12) << length << ' ' << mass;
      EXPECT_NEAR(number(found.B, 3, 0) * mass * length, 1.0 / 2, 1e-12) << length << ' ' << mass;
    }
}

} // namespace
