// builds: clang++ all
// Friction with bristles, by Dahl and LuGre: closed forms, rest on a slope, and no creation of energy. Rest
// of a car on tyres.
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/simulations/model.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

namespace mechanics = kanexpr::mechanics;
using Eigen::VectorXd;
using kanexpr::derive;
using kanexpr::model;
using kanexpr::runtime::builder;
using kanexpr::runtime::contact_data;
using kanexpr::runtime::tyre_data;
using kanexpr::symbolic::expression;
using mechanics::friction_law;

constexpr double mu_static = 0.4, mu_sliding = 0.25, stribeck = 0.02, sigma0 = 2e3, sigma1 = 30, sigma2 = 0.6;

double coefficient(double v) {
  return mu_sliding + (mu_static - mu_sliding) * std::exp(-(v / stribeck) * (v / stribeck));
}
double size(double v, double e) { return v * v / std::hypot(v, e); }

friction_law lugre(builder& b, const mechanics::sequence<expression>& z) {
  return friction_law::lugre(b.number(mu_static), b.number(mu_sliding), b.number(stribeck), b.number(sigma0),
                             b.number(sigma1), b.number(sigma2), z);
}

/// A block of 2 kg on a line, pulled by an input F, with the normal force as an input or a number.
struct block : builder {
  expression x = coordinate("x"), v = speed("v"), pull = input("F");
  kanexpr::runtime::point_id o{}, p{};
  block() : builder("N") {
    kinematic_equation(dot(x) - v);
    o = origin("O");
    p = offset("P", o, along(inertial_frame(), x, 0, 0));
    particle("Block", p, number(2));
    force(p, along(inertial_frame(), pull, 0, 0));
  }
};

VectorXd three(double a, double b, double c) { return Eigen::Vector3d(a, b, c); }

// The rates of speed and bristle, written out.
TEST(bristles, follow_the_law_of_lugre) {
  for (const bool is_constant : {true, false}) {
    block b;
    const expression normal = is_constant ? b.number(7) : b.input("N");
    const expression z = b.state_variable("z");
    b.friction_along(b.straight(b.p, b.o), normal, lugre(b, {z}));
    model m = derive(b);
    ASSERT_EQ(m.mistake(), "");
    auto rhs = m.function(m.rhs());
    for (const double v : {-0.3, -0.011, -3e-5, 0.0, 2e-6, 0.0021, 0.4})
      for (const double bristle : {-3e-4, 0.0, 1e-4}) {
        const VectorXd r = is_constant ? VectorXd::Constant(1, 1.5) : VectorXd(Eigen::Vector2d(1.5, 7));
        const VectorXd found = rhs(three(0.3, v, bristle), VectorXd(), r);
        const double load = is_constant ? 7 : std::sqrt(7.0), drawn = is_constant ? 1 : load;
        const double slip = size(v, stribeck / 1000) / coefficient(v);
        const double rate = drawn * v - sigma0 * slip * bristle;
        const double force =
            load * (sigma0 * bristle + sigma1 / (1 + sigma1 * slip / 4) * rate) + 7 * sigma2 * v;
        EXPECT_NEAR(found[2], rate, 1e-13 * (1 + std::abs(rate)));
        EXPECT_NEAR(found[1], (1.5 - force) / 2, 1e-12 * (1 + std::abs(force)));
      }
  }
}

// In steady slip, the friction is that of Stribeck's curve; |v| is smooth, which changes it by (e/v)²/2.
TEST(bristles, slip_with_stribecks_friction) {
  for (const double v : {-0.5, -0.03, 0.004, 0.02}) {
    block b;
    const expression z = b.state_variable("z");
    b.friction_along(b.straight(b.p, b.o), b.number(7), lugre(b, {z}));
    model m = derive(b);
    auto rhs = m.function(m.rhs());
    const double steady = v * coefficient(v) / (sigma0 * size(v, stribeck / 1000));
    const VectorXd found = rhs(three(0.3, v, steady), VectorXd(), VectorXd::Zero(1));
    EXPECT_NEAR(found[2], 0, 1e-14);
    const double friction = 7 * (coefficient(v) * (v < 0 ? -1 : 1) + sigma2 * v);
    EXPECT_NEAR(-2 * found[1] / friction, 1, std::pow(stribeck / 1000 / v, 2));
  }
}

// Dahl: with a constant coefficient, the force of a block that is drawn along is μ N (1 − e^(−σ x/μ)),
// whatever its velocity is; after the turn at x₁, it is −μ N + (μ N + F₁) e^(−σ (x₁ − x)/μ).
TEST(bristles, follow_dahls_hysteresis) {
  constexpr double mu = 0.3, sigma = 100, load = 5;
  block b;
  const expression z = b.state_variable("z");
  b.friction_along(b.straight(b.p, b.o), b.number(load),
                   friction_law::dahl(b.number(mu), b.number(sigma), b.number(1e-9), {z}));
  model m = derive(b);
  ASSERT_EQ(m.mistake(), "");
  auto rhs = m.function(m.rhs());
  // prescribed motion: only the rate of the bristle is integrated, by the method of Runge and Kutta
  const auto rate = [&](double t, double at) {
    const double v = 0.02 * std::cos(t);
    return rhs(three(1 + 0.02 * std::sin(t), v, at), VectorXd(), VectorXd::Zero(1))(2);
  };
  double at = 0, most = 0;
  constexpr int steps = 4000;
  const double h = 1.5 * 3.14159265358979323846 / steps; // until x = −0.02
  for (int i = 0; i < steps; ++i) {
    const double t = i * h, k1 = rate(t, at), k2 = rate(t + h / 2, at + h / 2 * k1),
                 k3 = rate(t + h / 2, at + h / 2 * k2), k4 = rate(t + h, at + h * k3);
    at += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (i + 1 == steps / 3) most = load * sigma * at;
  }
  const double exact = load * mu * (1 - std::exp(-sigma * 0.02 / mu));
  EXPECT_NEAR(most, exact, 1e-8 * exact);
  const double back = -load * mu + (load * mu + exact) * std::exp(-sigma * 0.04 / mu);
  EXPECT_NEAR(load * sigma * at, back, 1e-8 * exact);
}

/// A block on a plane that is inclined by 0.2 rad, by a contact.
model resting_block(double mass, double mu_of_rest) {
  builder b("N");
  const auto n = builder::inertial_frame();
  const expression x = b.coordinate("x"), y = b.coordinate("y"), h = b.coordinate("h");
  for (const expression& q : {x, y, h})
    b.kinematic_equation(b.dot(q) - b.speed("v_" + kanexpr::symbolic::print(q)));
  const expression z1 = b.state_variable("z1"), z2 = b.state_variable("z2");
  const auto o = b.origin("O"), p = b.offset("P", o, b.along(n, x, y, h));
  b.particle("Block", p, b.number(mass));
  b.gravity(b.along(n, 9.81 * std::sin(0.2), 0, -9.81 * std::cos(0.2)));
  contact_data data{.stiffness = 1e5, .width = 1e-5};
  data.damping = 20.0;
  data.friction = friction_law::lugre(b.number(mu_of_rest), b.number(mu_of_rest), b.number(0.01),
                                      b.number(1e4), b.number(50), b.number(0.4), {z1, z2});
  b.point_on_plane(p, o, b.along(n, 0, 0, 1), data);
  return derive(b);
}

// tan 0.2 = 0.203. The block settles by about 1e-5 m and then stays where it is for an hour; with 0.19 it
// slides.
TEST(bristles, hold_a_block_on_a_slope_for_an_hour) {
  const std::initializer_list<kanexpr::named_value> dropped{
      {"x", 0}, {"y", 0}, {"h", 0}, {"v_x", 1e-3}, {"v_y", 2e-3}, {"v_h", 0}, {"z1", 0}, {"z2", 0}};
  const auto run = kanexpr::simulate<kanexpr::integrator::bdf>(
      resting_block(2, 0.3), dropped, {}, {0, 3610},
      {.relative_tolerance = 1e-9, .absolute_tolerance = 1e-13, .output_every = 10});
  ASSERT_TRUE(run) << run.cause();
  const VectorXd first = run.trajectory[1].x, last = run.state;
  EXPECT_GT(first[0], 1e-5);
  EXPECT_LT(first[0], 1e-3);
  EXPECT_LT(std::hypot(last[0] - first[0], last[1] - first[1]), 1e-10); // of 0.1 m
  EXPECT_LT(last.segment(3, 3).norm(), 1e-10);

  const auto slides =
      kanexpr::simulate<kanexpr::integrator::bdf>(resting_block(2, 0.19), dropped, {}, {0, 10});
  ASSERT_TRUE(slides) << slides.cause();
  EXPECT_GT(slides.state[0], 0.2);
}

/// A car with locked brakes on a plane that falls by 0.15 along the car and by 0.05 across it. A resistance
/// in proportion to its speeds, which cannot hold it, lets it settle soon.
struct parked_car : builder {
  static constexpr double wheelbase = 2.8, mass = 1200, standstill = 0.1, resistance = 3e4, stiffness = 8e4;
  static constexpr double slope = 0.15, sideways = 0.05;
  kanexpr::runtime::frame_id n = inertial_frame(), body{};
  kanexpr::runtime::point_id o = origin("O"), center{};

  parked_car(tyre_data of, bool lags) : builder("N") {
    std::vector<expression> q, resisting;
    for (const char* name : {"x", "y", "z", "yaw", "pitch", "roll"}) {
      q.push_back(coordinate(name));
      const expression v = speed("v_" + std::string(name));
      kinematic_equation(dot(q.back()) - v);
      resisting.push_back(-resistance * v);
    }
    body = body_fixed("Body", n, "zyx", q[3], q[4], q[5]);
    center = offset("Center", o, along(n, q[0], q[1], 0.5 + q[2]));
    rigid_body("Car", center, body, number(mass), inertia(body, 500, 1500, 1700));
    const double down = 9.81 / std::hypot(1, slope, sideways);
    gravity(along(n, slope * down, sideways * down, -down));
    force(center, along(n, resisting[0], resisting[1], resisting[2]));
    torque(body, along(body, resisting[5], resisting[4], resisting[3]));
    of.radial = {2e5, 0.5, 1e-4}, of.standstill = standstill;
    for (const double ahead : {1.2, 1.2 - wheelbase})
      for (const double left : {0.8, -0.8}) wheel(ahead, left, of, lags);
  }

private:
  void wheel(double ahead, double left, tyre_data of, bool lags) {
    const std::string place = std::to_string(++wheels_);
    const auto hub = offset("Hub" + place, center, along(body, ahead, left, -0.2));
    if (lags) of.relaxation = {0.3, 0.4, state_variable("dx" + place), state_variable("dy" + place)};
    tyre(wheel_on_plane({hub, body, along(body, 0, 1, 0), 0.3}, o, along(n, 0, 0, 1)), of);
  }
  int wheels_ = 0;
};

tyre_data with_formula() {
  return tyre_data::of_formula({.Fz0 = 3000,
                                .R0 = 0.3,
                                .pCx1 = 1.6,
                                .pDx1 = 0.9,
                                .pKx1 = 21,
                                .rBx1 = 12,
                                .rCx1 = 1.1,
                                .pCy1 = 1.3,
                                .pDy1 = 0.9,
                                .pKy1 = -15,
                                .pKy2 = 1.6,
                                .pKy4 = 2,
                                .rBy1 = 8,
                                .rCy1 = 1.1});
}

// The car settles within a second and then stays where it is. Without relaxation lengths, its tyres are
// dampers, on which it creeps.
TEST(tyres, with_relaxation_lengths_hold_a_car_on_a_slope_for_an_hour) {
  const double c = parked_car::stiffness;
  for (const tyre_data& of : {tyre_data::linear(c, c), tyre_data::brush(0.9, c, 0.7 * c), with_formula()}) {
    const auto run = kanexpr::simulate<kanexpr::integrator::bdf>(
        parked_car(of, true), VectorXd::Zero(20), {}, {0, 3610},
        {.relative_tolerance = 1e-8, .absolute_tolerance = 1e-12, .output_every = 10});
    ASSERT_TRUE(run) << run.cause();
    const VectorXd first = run.trajectory[1].x, last = run.state;
    EXPECT_GT(first[0], 1e-3);
    EXPECT_LT(first[0], 1e-2);
    EXPECT_LT((last - first).head(2).norm(), 1e-9 * parked_car::wheelbase);
    EXPECT_LT(std::abs(last[3] - first[3]), 1e-9);
  }

  const auto creeping = kanexpr::simulate<kanexpr::integrator::bdf>(
      parked_car(tyre_data::linear(c, c), false), VectorXd::Zero(12), {}, {0, 10}, {.output_every = 5});
  ASSERT_TRUE(creeping) << creeping.cause();
  const double force =
      parked_car::mass * 9.81 * parked_car::slope / std::hypot(1, parked_car::slope, parked_car::sideways);
  const double speed = force / (4 * c / parked_car::standstill + parked_car::resistance);
  EXPECT_NEAR((creeping.state[0] - creeping.trajectory[1].x[0]) / 5, speed, 0.01 * speed);
}

// The power that friction takes from the motion is never less than the rate of the energy stored in the
// bristles, at any normal force, slip and deflection. Without the factor s, this fails at the same states.
TEST(bristles, create_no_energy_at_random_states) {
  block b;
  const expression normal = b.input("N"), z = b.state_variable("z");
  b.friction_along(b.straight(b.p, b.o), normal, lugre(b, {z}));
  model m = derive(b);
  auto rhs = m.function(m.rhs());
  std::mt19937_64 source(3);
  std::uniform_real_distribution<double> exponent(-6, 1);
  std::bernoulli_distribution sign;
  const auto any = [&] { return (sign(source) ? 1 : -1) * std::pow(10, exponent(source)); };
  double worst = 0, worst_of_constant_damping = 0;
  for (int i = 0; i < 20000; ++i) {
    const double v = any(), y = 1e-3 * any(), load = i % 10 == 0 ? 0 : std::abs(any());
    const VectorXd found = rhs(three(0.3, v, y), VectorXd(), Eigen::Vector2d(0, load));
    const double taken = -2 * found[1] * v, stored = sigma0 * y * found[2];
    const double scale = std::abs(taken) + std::abs(stored) + 1e-30;
    worst = std::max(worst, (stored - taken) / scale);
    const double pull = std::sqrt(load) * (sigma0 * y + sigma1 * found[2]) + load * sigma2 * v;
    worst_of_constant_damping = std::max(worst_of_constant_damping, (stored - pull * v) / scale);
    if (load <= 0) {
      EXPECT_EQ(found[1], 0);
    }
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_GT(worst_of_constant_damping, 0.1);
}

// The same along random motions under random normal forces, for the integral of the power.
TEST(bristles, create_no_energy_in_random_motions) {
  block b;
  const expression normal = b.input("N"), z = b.state_variable("z");
  b.friction_along(b.straight(b.p, b.o), normal, lugre(b, {z}));
  model m = derive(b);
  auto rhs = m.function(m.rhs());
  std::mt19937_64 source(5);
  std::normal_distribution<double> gauss;
  for (int motion = 0; motion < 5; ++motion) {
    double a[4], w[4], c[4];
    for (int k = 0; k < 4; ++k)
      a[k] = 0.03 * gauss(source), w[k] = 20 * gauss(source), c[k] = 4 * gauss(source);
    const auto rates = [&](double t, double y) { // of the deflection, and the power
      double v = 0, root = 0;
      for (int k = 0; k < 4; ++k) v += a[k] * std::sin(w[k] * t + k), root += c[k] * std::cos(w[3 - k] * t);
      const double load = motion == 0 ? 5 : root * root;
      const VectorXd found = rhs(three(0.3, v, y), VectorXd(), Eigen::Vector2d(0, load));
      return Eigen::Vector2d(found[2], -2 * found[1] * v);
    };
    Eigen::Vector2d at(0, 0);
    double total = 0;
    constexpr double h = 2e-5;
    for (int i = 0; i < 20000; ++i) {
      const double t = i * h;
      const Eigen::Vector2d k1 = rates(t, at[0]), k2 = rates(t + h / 2, at[0] + h / 2 * k1[0]),
                            k3 = rates(t + h / 2, at[0] + h / 2 * k2[0]),
                            k4 = rates(t + h, at[0] + h * k3[0]);
      const Eigen::Vector2d step = h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      at += step;
      total += std::abs(step[1]);
      ASSERT_GE(at[1], sigma0 * at[0] * at[0] / 2 - 1e-9 * total) << motion << " at t = " << t;
    }
    EXPECT_GT(total, 1e-3);
  }
}

/// A particle that touches something by a contact, with or without friction.
template <class Touch>
model touching(bool has_friction, int bristles, const Touch& touch) {
  builder b("N");
  const auto n = builder::inertial_frame();
  mechanics::sequence<expression> q, z;
  for (const char* name : {"x", "y", "h"}) {
    q.push(b.coordinate(name));
    b.kinematic_equation(b.dot(q[q.size() - 1]) - b.speed("v_" + std::string(name)));
  }
  for (int i = 1; has_friction && i <= bristles; ++i) z.push(b.state_variable("z" + std::to_string(i)));
  const auto o = b.origin("O"), p = b.offset("P", o, b.along(n, q[0], q[1], q[2]));
  b.particle("Body", p, b.number(2));
  contact_data data{.stiffness = 3e3, .exponent = 1.5, .width = 1e-3};
  if (has_friction) data.friction = lugre(b, z);
  touch(b, p, o, data);
  return derive(b);
}

/// Compares the power of the friction with the rate of the stored energy, at random states.
template <class Touch>
void expect_no_energy(int bristles, const Eigen::Vector3d& place, const Touch& touch) {
  model with = touching(true, bristles, touch), without = touching(false, bristles, touch);
  ASSERT_EQ(with.mistake(), "");
  ASSERT_EQ(without.mistake(), "");
  auto rhs = with.function(with.rhs()), frictionless = without.function(without.rhs());
  std::mt19937_64 source(11);
  std::normal_distribution<double> gauss;
  int pulls = 0;
  for (int i = 0; i < 500; ++i) {
    VectorXd x(6 + bristles);
    for (int k = 0; k < 3; ++k) x[k] = place[k] + 0.01 * gauss(source), x[3 + k] = 0.1 * gauss(source);
    for (int k = 0; k < bristles; ++k) x[6 + k] = 3e-4 * gauss(source);
    const VectorXd found = rhs(x), free = frictionless(x.head(6));
    const Eigen::Vector3d force = 2 * (found.segment(3, 3) - free.segment(3, 3));
    const double taken = -force.dot(x.segment(3, 3)),
                 stored = sigma0 * x.tail(bristles).dot(found.tail(bristles));
    EXPECT_TRUE(found.allFinite());
    EXPECT_GE(taken, stored - 1e-11 * (std::abs(taken) + std::abs(stored)));
    if (force.norm() > 0) ++pulls;
  }
  EXPECT_GT(pulls, 100); // the others are open, where the friction is exactly zero
  EXPECT_LT(pulls, 450);
}

// The rate of a deflection may be used by other loads.
TEST(bristles, have_rates_in_other_loads) {
  const auto derived = [](bool is_written_out) {
    block b;
    const expression z = b.state_variable("z"), y = b.state_variable("y");
    b.friction_along(b.straight(b.p, b.o), b.number(7),
                     friction_law::dahl(b.number(0.3), b.number(100), b.number(0.1), {z}));
    const expression written = b.v - 100 * b.v * b.v / sqrt(b.v * b.v + 0.01) * z / 0.3;
    const expression rate = is_written_out ? written : b.dot(z);
    b.dynamics(y, 3 * rate - y);
    b.force(b.p, b.along(builder::inertial_frame(), rate, 0, 0));
    return derive(b);
  };
  model one = derived(false), other = derived(true);
  ASSERT_EQ(one.mistake(), "");
  ASSERT_EQ(other.mistake(), "");
  const VectorXd x = Eigen::Vector4d(0.4, 0.2, 1e-3, 0.3), pull = VectorXd::Constant(1, 0.6);
  const VectorXd first = one.function(one.rhs())(x, VectorXd(), pull),
                 second = other.function(other.rhs())(x, VectorXd(), pull);
  EXPECT_LT((first - second).norm(), 1e-13 * second.norm());
}

TEST(bristles, create_no_energy_in_contacts) {
  using kanexpr::runtime::point_id;
  const auto on_plane = [](double nx, double ny, double nz) {
    return [=](builder& b, point_id p, point_id o, const contact_data& data) {
      b.point_on_plane(p, o, b.along(builder::inertial_frame(), nx, ny, nz), data);
    };
  };
  expect_no_energy(2, {0, 0, 0}, on_plane(0, 0, 1));
  expect_no_energy(2, {0, 0, 0}, on_plane(0, 2, -1));
  expect_no_energy(2, {0, 0, 0}, on_plane(0.3, -0.5, 1));
  expect_no_energy(3, {0, 0.2, 0.4}, [](builder& b, point_id p, point_id o, const contact_data& data) {
    const auto n = builder::inertial_frame();
    b.sphere_on_sphere(p, n, 0.1, o, b.rotated("B", n, b.number(0.3), b.along(n, 1, 0, 0)),
                       std::sqrt(0.2) - 0.1, data);
  });
  expect_no_energy(3, {0, 0, 0}, [](builder& b, point_id p, point_id o, const contact_data& data) {
    b.point_on_surface(
        p, o, builder::inertial_frame(),
        [](const expression& x, const expression& y, const expression& z) {
          return z - 0.05 * sin(7 * x) + 0.3 * y;
        },
        data);
  });
}

// A joint with Lagrange's method, and the units of the deflection: that of y is m √N.
TEST(bristles, by_lagrange_and_with_units) {
  namespace si = kanexpr::units::si;
  const auto derived = [](bool by_lagrange) {
    builder b("N");
    const expression x = b.coordinate("x", si::meter), normal = b.input("N", si::newton);
    const expression v = by_lagrange ? b.dot(x) : b.speed("v");
    if (by_lagrange)
      b.rates_as_speeds();
    else
      b.kinematic_equation(b.dot(x) - v);
    const expression z = b.state_variable("z"), y = b.state_variable("y");
    b.particle("Block", b.offset("P", b.origin("O"), b.along(builder::inertial_frame(), x, 0, 0)),
               b.number(2));
    const auto path = b.given_length(x);
    b.friction_along(path, b.parameter("N0", si::newton), lugre(b, {z}));
    b.friction_along(path, normal, lugre(b, {y}));
    EXPECT_EQ(b.unit_of(z), si::meter);
    EXPECT_EQ(b.unit_of(y), (si::meter * kanexpr::units::pow<1, 2>(si::newton)));
    return derive(b);
  };
  model kane = derived(false), lagrange = derived(true);
  ASSERT_EQ(kane.mistake(), "");
  ASSERT_EQ(lagrange.mistake(), "");
  const VectorXd x = Eigen::Vector4d(0.4, 0.2, 1e-4, -3e-4), one = VectorXd::Constant(1, 0.6);
  const VectorXd first = kane.function(kane.rhs())(x, one, one),
                 second = lagrange.function(lagrange.rhs())(x, one, one);
  EXPECT_LT((first - second).norm(), 1e-13 * second.norm());
  EXPECT_GT(std::abs(first[1]), 0.1);
}

TEST(bristles, are_checked) {
  const auto mistake = [](const auto& make) {
    block b;
    make(b);
    return std::string(b.check().view());
  };
  const std::string law = "friction between P and O";
  EXPECT_EQ(mistake([](block& b) { b.friction_along(b.straight(b.p, b.o), b.number(1), lugre(b, {})); }),
            "the friction along a pathway has 0 bristles, expected 1");
  EXPECT_EQ(mistake([](block& b) { b.friction_along(b.straight(b.p, b.o), b.number(1), lugre(b, {b.v})); }),
            "a bristle of the " + law + " is not a state variable");
  EXPECT_EQ(mistake([](block& b) {
              const expression z = b.state_variable("z");
              b.friction_along(b.straight(b.p, b.o), b.number(1), lugre(b, {z}));
              b.dynamics(z, -z);
            }),
            "state variable z has two dynamics; write one equation, dynamics<dot(z) == rate>");
  EXPECT_EQ(mistake([](block& b) {
              const expression z = b.state_variable("z");
              b.friction_along(b.straight(b.p, b.o), b.number(1),
                               friction_law::dahl(b.number(0.3), b.number(-1), b.number(0.1), {z}));
            }),
            "the stiffness of the bristles of the " + law + " is not positive");
  EXPECT_EQ(mistake([](block& b) {
              const expression z = b.state_variable("z");
              contact_data data{.stiffness = 1e3, .width = 1e-3};
              data.friction = lugre(b, {z});
              b.point_on_plane(b.p, b.o, b.along(builder::inertial_frame(), 0, 0, 1), data);
            }),
            "the contact between P and O has 1 bristle, expected 2");
  EXPECT_EQ(
      mistake([](block& b) {
        const expression z = b.state_variable("z"), other = b.state_variable("z2"), a = b.parameter("a");
        contact_data data{.stiffness = 1e3, .width = 1e-3};
        data.friction = lugre(b, {z, other});
        b.point_on_plane(b.p, b.o, b.along(builder::inertial_frame(), a, 1, 1), data);
      }),
      "the contact between P and O has bristles, whose directions do not follow from its normal; turn N so "
      "that a component of the normal is zero");
}

} // namespace
