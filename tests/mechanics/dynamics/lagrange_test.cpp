// builds: clang++
// Lagrange's equations of random mechanisms, compared with Kane's, and Lagrangians that do not belong to any
// bodies.
#include "mechanics/random/dice.hpp"
#include "mechanics/workbench.hpp"

namespace {

using namespace workbench;

// Coordinates whose rates are the speeds, for either method, with numeric values.
struct system_of_rates : builder {
  std::vector<expression> q, u;
  std::vector<double> q_now, u_now, r_now{0.3, -0.8, 0.5};
  double t_now = 0.6;

  system_of_rates(int coordinates, bool lagrange) : builder("N") {
    for (int i = 0; i < coordinates; ++i) q.push_back(coordinate("q" + std::to_string(i)));
    if (lagrange) rates_as_speeds();
    for (const expression& each : q) {
      if (lagrange) {
        u.push_back(dot(each));
        continue;
      }
      u.push_back(speed("u" + std::to_string(u.size())));
      kinematic_equation(dot(each) - u.back());
    }
  }

  MatrixXd numbers(const kanexpr::symbolic::matrix& wanted) {
    return numbers_of(wanted, [&](const kanexpr::lower::load& l) {
      using kanexpr::symbolic::symbol_kind;
      const auto i = static_cast<std::size_t>(l.position);
      if (l.from == symbol_kind::coordinate) return q_now.at(i);
      if (l.from == symbol_kind::speed) return u_now.at(i);
      if (l.from == symbol_kind::speed_rate) return 0.3 * l.position - 1;
      if (l.from == symbol_kind::input) return r_now.at(i);
      return t_now;
    });
  }

  MatrixXd results(quantity wanted) {
    mechanics::equations e(system());
    const MatrixXd found = numbers(e.get(wanted));
    EXPECT_EQ(e.mistake().view(), "");
    return found;
  }
  std::string mistake_of_derivation() {
    EXPECT_EQ(check().view(), "");
    mechanics::equations e(system());
    e.constrain();
    return std::string(e.mistake().view());
  }
};

// Rotating and sliding joints that depend on time and on a prescribed motion, with masses that change with
// time and every kind of load.
struct chain : system_of_rates {
  static constexpr std::size_t links = 3;
  dice d;

  chain(unsigned seed, bool lagrange) : system_of_rates(2 * links, lagrange), d(seed) {
    build();
    for (std::size_t i = 0; i < 2 * links; ++i) q_now.push_back(d.between(-1, 1));
    for (std::size_t i = 0; i < 2 * links; ++i) u_now.push_back(d.between(-2, 2));
  }

  vector any(frame_id f) { return along(f, d.between(-1, 1), d.between(-1, 1), d.between(-1, 1)); }

  void build() {
    const expression driven = prescribed("theta");
    const point_id ground = origin("O");
    frame_id f = inertial_frame();
    point_id p = ground;
    for (std::size_t i = 0; i < links; ++i) {
      const std::string own = std::to_string(i);
      const expression turning = q[2 * i] + (d.chance(0.4) ? driven : number(0.7) * time());
      if (d.chance(0.3))
        f = body_fixed("F" + own, f, "zxy", turning, number(0.3) + q[2 * i + 1], driven);
      else
        f = rotated("F" + own, f, turning, any(f));
      const point_id joint = offset("J" + own, p, any(f));
      p = offset("S" + own, joint, along(f, q[2 * i + 1], driven * q[2 * i], number(d.between(-1, 1))));
      const expression mass = number(d.between(0.5, 2)) + number(0.2) * time();
      rigid_body("B" + own, offset("G" + own, p, any(f)), f, mass,
                 inertia(f, number(1) + time() * time(), number(1.3), number(d.between(0.6, 1.4)),
                         number(0.1), number(-0.2), number(0.1) * time()));
      particle("P" + own, p, number(2) * mass);
      force(p, along(f, u[2 * i] * u[0], sin(q[0]), driven));
      torque(f, any(inertial_frame()));
    }
    gravity(along(inertial_frame(), 0.3, -9.81, 2));
    potential_energy(q[0] * q[1] * q[2] + time() * cos(q[3] - driven));
    spring(p, ground, number(7), number(0.4));
    damper(p, ground, number(0.6));
  }
};

TEST(lagrange, agrees_with_kane) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    chain kane(seed, false), lagrange(seed, true);
    ASSERT_EQ(kane.check().view(), "");
    ASSERT_EQ(lagrange.check().view(), "");
    for (quantity q : {quantity::mass_matrix, quantity::forcing, quantity::rhs, quantity::active_forces,
                       quantity::inertia_forces, quantity::kinetic_energy, quantity::potential_energy}) {
      SCOPED_TRACE(static_cast<int>(q));
      expect_equal(lagrange.results(q), kane.results(q));
    }
  }
}

// A particle in a plane with a Lagrangian that does not belong to a body.
struct particle_in_plane : system_of_rates {
  expression x, y, vx, vy;
  particle_in_plane() : system_of_rates(2, true), x(q[0]), y(q[1]), vx(u[0]), vy(u[1]) {
    q_now = {0.4, -1.2};
    u_now = {0.3, 0.5};
  }
};

// −m c² √(1 − v²/c²): the momentum is γ m v, so M contains the rates.
TEST(lagrangian, of_special_relativity) {
  particle_in_plane p;
  const double m = 1.7, force = 0.8;
  p.lagrangian(p.number(force) * p.x - p.number(m) * sqrt(1 - p.vx * p.vx - p.vy * p.vy));
  const double vx = p.u_now[0], vy = p.u_now[1], gamma = 1 / std::sqrt(1 - vx * vx - vy * vy);
  // Goldstein, section 7.9: a = (F − v (v·F)) / (γ m) with c = 1
  expect_equal(p.results(quantity::udot),
               Eigen::Vector2d(force * (1 - vx * vx), -force * vx * vy) / (gamma * m));
}

// A charge in a magnetic field perpendicular to the plane: no energy, but a force perpendicular to the
// velocity.
TEST(lagrangian, with_a_potential_of_velocities) {
  particle_in_plane p;
  const double m = 1.7, field = 0.9;
  p.lagrangian(p.number(m) * (p.vx * p.vx + p.vy * p.vy) / 2 +
               p.number(field) * (p.x * p.vy - p.y * p.vx) / 2);
  expect_equal(p.results(quantity::udot), field / m * Eigen::Vector2d(p.u_now[1], -p.u_now[0]));
}

// Time occurs in L: with the factor e^(ct), L gives a damped oscillator (Caldirola 1941, Kanai 1948).
TEST(lagrangian, may_hold_time) {
  particle_in_plane p;
  const double m = 1.7, k = 3, c = 0.4;
  p.lagrangian(exp(p.number(c) * p.time()) *
               (p.number(m) * (p.vx * p.vx + p.vy * p.vy) - p.number(k) * (p.x * p.x + p.y * p.y)) / 2);
  const Eigen::Vector2d at(p.q_now[0], p.q_now[1]), v(p.u_now[0], p.u_now[1]);
  expect_equal(p.results(quantity::udot), -c * v - k / m * at);
}

// A force given by a potential needs no rate; a momentum needs one, which the input must have.
TEST(lagrangian, may_hold_inputs) {
  particle_in_plane p;
  const expression f = p.input("F"), w = p.prescribed("w");
  p.r_now = {2, 0.6, -0.3, 0.1};
  p.lagrangian((p.vx * p.vx + p.vy * p.vy) / 2 + f * p.x + w * p.vy);
  expect_equal(p.results(quantity::udot), Eigen::Vector2d(p.r_now[0], -p.r_now[2]));
}

TEST(lagrange, names_what_it_cannot_take) {
  {
    particle_in_plane p;
    const expression f = p.input("F");
    p.lagrangian(p.vx * p.vx + p.vy * p.vy + f * p.vx);
    EXPECT_EQ(p.mistake_of_derivation(),
              "a derivative of the Lagrangian with respect to a rate contains the input F, whose rate is not "
              "known; declare it prescribed and list its rates among the inputs");
  }
  {
    particle_in_plane p;
    p.particle("Chain", p.offset("End", p.origin("O"), p.along(p.inertial_frame(), p.x, p.y, p.x)),
               p.number(2) + p.x);
    EXPECT_EQ(
        p.mistake_of_derivation(),
        "the mass of Chain depends on coordinate q0; with Lagrange's method it may depend only on time");
  }
  { // axes of a carrier, about which the wheel is not axisymmetric
    particle_in_plane p;
    const frame_id wheel = p.rotated("Wheel", p.inertial_frame(), p.y, p.along(p.inertial_frame(), 0, 0, 1));
    const point_id at = p.offset("P", p.origin("O"), p.along(p.inertial_frame(), p.x, p.x, p.y));
    p.rigid_body("Block", at, wheel, p.number(1),
                 p.inertia(p.inertial_frame(), p.number(1), p.number(2), p.number(3)));
    EXPECT_EQ(
        p.mistake_of_derivation(),
        "the inertia of Block depends on coordinate q1; with Lagrange's method it may depend only on time");
  }
  { // rolling that is built into a velocity
    particle_in_plane p;
    const point_id at = p.offset("P", p.origin("O"), p.along(p.inertial_frame(), p.x, p.y, p.x));
    p.velocity(at, p.inertial_frame(), p.along(p.inertial_frame(), p.vx, p.vx, p.vx));
    p.particle("Skate", at, p.number(1));
    EXPECT_EQ(p.mistake_of_derivation(),
              "the velocity of Skate is not the rate of its position, as Lagrange's method requires");
  }
  {
    particle_in_plane p;
    const frame_id a = p.rotated("A", p.inertial_frame(), p.x, p.along(p.inertial_frame(), 0, 0, 1));
    p.angular_velocity(a, p.inertial_frame(), p.along(a, p.number(0.0), p.number(0.0), p.vy));
    p.particle("P", p.offset("P", p.origin("O"), p.along(a, p.x, p.y, p.x)), p.number(1));
    EXPECT_EQ(p.mistake_of_derivation(), "the declared angular velocity of frame A does not match its "
                                         "orientation, as Lagrange's method requires");
  }
  for (const double factor : {2.0, 1.0}) { // 2 ē ∘ ė is the angular velocity for a unit quaternion
    system_of_rates p(4, true);
    const auto& [e0, e1, e2, e3] = std::tie(p.q[0], p.q[1], p.q[2], p.q[3]);
    const auto& [v0, v1, v2, v3] = std::tie(p.u[0], p.u[1], p.u[2], p.u[3]);
    const frame_id a = p.quaternion("A", p.inertial_frame(), e0, e1, e2, e3);
    const expression k = p.number(factor);
    p.angular_velocity(a, p.inertial_frame(),
                       p.along(a, k * (e0 * v1 - e1 * v0 - e2 * v3 + e3 * v2),
                               k * (e0 * v2 - e2 * v0 - e3 * v1 + e1 * v3),
                               k * (e0 * v3 - e3 * v0 - e1 * v2 + e2 * v1)));
    p.configuration_constraint(e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3 - 1);
    p.rigid_body("B", p.origin("O"), a, p.number(1), p.inertia(a, p.number(1), p.number(2), p.number(2.5)));
    EXPECT_EQ(p.mistake_of_derivation(), factor > 1.5
                                             ? ""
                                             : "the declared angular velocity of frame A does not match its "
                                               "orientation, as Lagrange's method requires");
  }
}

} // namespace
