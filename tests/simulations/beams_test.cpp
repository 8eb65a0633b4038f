// builds: clang++ all
// Motions of beams: the spin-up of a rotating beam, a slewing arm, a free beam, and the limit of rigid bars.
#include <kanexpr/numeric/beams/modes.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/simulations/model.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using kanexpr::input_values;
using kanexpr::model;
using kanexpr::named_value;
using kanexpr::simulate;
using kanexpr::simulation;
using kanexpr::state;
using kanexpr::mechanics::quantity;
using kanexpr::numeric::beams::ends;
using kanexpr::numeric::beams::wave_number_of_bending;
using kanexpr::runtime::beam_data;
using kanexpr::runtime::builder;
using kanexpr::runtime::flexible_integrals;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::modes_of_bending;
using kanexpr::runtime::modes_of_rod;
using kanexpr::runtime::number_or_expression;
using kanexpr::runtime::point_id;
using kanexpr::symbolic::expression;

constexpr double pi = 3.141592653589793;

// A builder that names coordinates q1, q2, … and their speeds u1, u2, …
struct numbered : builder {
  std::vector<expression> q;
  frame_id ground = inertial_frame();
  point_id o = origin("O");

  numbered() : builder("N") {}
  expression moving() {
    const std::string number = std::to_string(q.size() + 1);
    q.push_back(coordinate("q" + number));
    kinematic_equation(dot(q.back()) - speed("u" + number));
    return q.back();
  }
  std::vector<expression> moving(int count) {
    std::vector<expression> all;
    for (int i = 0; i < count; ++i) all.push_back(moving());
    return all;
  }
};

// ---- the spin-up of Kane, Ryan & Banerjee (1987), J. Guidance 10(2)

struct spun_beam {
  double length, stiffness, mass_per_length, rate;
};
// Wu & Haug (1988), Int. J. Numerical Methods in Engineering 26, and Yoo, Ryan & Scott (1995), J. Sound and
// Vibration 181.
const spun_beam wu_haug{8, 6.8952e10 * 8.2189e-9, 2766.67 * 7.2986e-5, 4}, yoo{10, 7e10 * 2e-7, 1.2, 6};

// The hub turns by a given angle from rest to a constant rate.
void spin_up(double t, double rate, input_values<model>& r) {
  constexpr double duration = 15, turn = 2 * pi / duration;
  const double growth = rate / duration;
  const bool spins_up = t < duration;
  r["theta"] =
      spins_up ? growth * (t * t / 2 + (std::cos(turn * t) - 1) / (turn * turn)) : rate * (t - duration / 2);
  r["theta'"] = spins_up ? growth * (t - std::sin(turn * t) / turn) : rate;
  r["theta''"] = spins_up ? growth * (1 - std::cos(turn * t)) : 0;
}

struct hub : numbered {
  frame_id turning = rotated("H", ground, prescribed("theta"), along(ground, 0, 0, 1));
};

struct stiffened : hub {
  stiffened(const spun_beam& of, int modes) {
    beam_data data{
        .axis = along(turning, 1, 0, 0), .length = of.length, .mass_per_length = of.mass_per_length};
    data.bending = {{along(turning, 0, 1, 0), {of.stiffness, modes_of_bending(ends::clamped_free, modes)}}};
    beam("Beam", o, turning, moving(modes), data);
  }
};

// The same body without the foreshortening, by numbers: with natural modes φ whose deflection at the tip is
// 1, ∫ φ² = 1/4, ∫ φ''² = β⁴/4 and ∫ ξ φ = ±1/β². The pivot does not accelerate, so the first moment does not
// act.
struct not_stiffened : hub {
  not_stiffened(const spun_beam& of, int modes) {
    const std::vector<expression> amplitudes = moving(modes);
    const double mass = of.mass_per_length * of.length, square = of.length * of.length;
    expression spread = number(0.0), product = number(0.0);
    flexible_integrals data{.mass = mass};
    for (int k = 0; k < modes; ++k) {
      const expression amplitude = amplitudes[static_cast<std::size_t>(k)];
      const double beta = wave_number_of_bending(ends::clamped_free, k + 1),
                   first = (k % 2 == 0 ? 1 : -1) / (beta * beta);
      spread += number(mass / 4) * amplitude * amplitude;
      product -= number(mass * of.length * first) * amplitude;
      data.angular.push_back({0.0, 0.0, mass * of.length * first});
      data.modal_mass.push_back(std::vector<number_or_expression>(amplitudes.size(), 0.0));
      data.stiffness.push_back(data.modal_mass.back());
      data.modal_mass.back()[static_cast<std::size_t>(k)] = mass / 4;
      data.stiffness.back()[static_cast<std::size_t>(k)] =
          of.stiffness * std::pow(beta, 4) / (4 * of.length * square);
    }
    data.inertia = {spread, mass * square / 3, mass * square / 3 + spread, product, 0.0, 0.0};
    flexible_body("Beam", o, turning, amplitudes, data);
  }
};

// The deflection of the tip, the sum of the amplitudes, every 5 ms.
std::vector<double> deflections(const hub& of, double rate) {
  const auto count = of.q.size();
  std::vector<named_value> start;
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back(std::to_string(i));
  for (const std::string& each : names) start.push_back({"q" + each, 0}), start.push_back({"u" + each, 0});
  const simulation<model> run =
      simulate(of, start, {}, {0, 20},
               {.inputs = [=](double t, const state<model>&, input_values<model>& r) { spin_up(t, rate, r); },
                .relative_tolerance = 1e-9,
                .absolute_tolerance = 1e-11,
                .output_every = 0.005});
  EXPECT_TRUE(run) << run.cause();
  std::vector<double> all(run.trajectory.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = run.trajectory[i].x.head(static_cast<Eigen::Index>(count)).sum();
  return all;
}

// The reference: M q'' + (K + ω² (G − M)) q = −ω' b with the same number of modes, integrated by LSODA with a
// relative tolerance of 1e-10.
TEST(spin_up, ends_with_a_small_deflection) {
  struct {
    spun_beam of;
    double greatest, at_5, at_10, at_15, residual;
  } const cases[]{{wu_haug, 0.5345111711350363, -0.4231469556857602, -0.34769080747221914,
                   0.007362767668155195, 0.008296347049812679},
                  {yoo, 0.574335877116706, -0.4687745129195483, -0.3626830846271356, 0.0012742527405696553,
                   0.003633560097298846}};
  for (const auto& each : cases) {
    const std::vector<double> v = deflections(stiffened(each.of, 4), each.of.rate);
    ASSERT_EQ(v.size(), 4001u);
    EXPECT_NEAR(*std::min_element(v.begin(), v.end()), -each.greatest, 1e-7);
    EXPECT_NEAR(v[1000], each.at_5, 1e-7);
    EXPECT_NEAR(v[2000], each.at_10, 1e-7);
    EXPECT_NEAR(v[3000], each.at_15, 1e-7);
    double residual = 0;
    for (std::size_t i = 3000; i < v.size(); ++i) residual = (std::max)(residual, std::abs(v[i]));
    EXPECT_NEAR(residual, each.residual, 1e-7);
  }
}

TEST(spin_up, diverges_without_stiffening) {
  const std::vector<double> v = deflections(not_stiffened(wu_haug, 3), wu_haug.rate);
  EXPECT_NEAR(v[1000], -0.4569587165539118, 1e-7);
  EXPECT_NEAR(v[2000], -6.830918732668856, 1e-6);
  EXPECT_NEAR(v[4000] / -804954796745.5217, 1, 1e-7);
}

// ---- a slewing arm: a motor turns a hub with an arm from rest to rest

struct arm {
  static constexpr double length = 1.5, stiffness = 40, mass_per_length = 0.7, hub_inertia = 0.4;
};

struct slewing : numbered {
  expression motor = input("T");
  frame_id hub = rotated("H", ground, moving(), along(ground, 0, 0, 1));

  slewing() {
    constexpr double i = arm::hub_inertia;
    rigid_body("Hub", o, hub, number(1.0), inertia(hub, i, i, i));
    torque(hub, along(ground, 0, 0, motor));
  }
};

struct slewing_beam : slewing {
  point_id tip{};
  explicit slewing_beam(int modes) {
    beam_data data{
        .axis = along(hub, 1, 0, 0), .length = arm::length, .mass_per_length = arm::mass_per_length};
    data.bending = {{along(hub, 0, 1, 0), {arm::stiffness, modes_of_bending(ends::clamped_free, modes)}}};
    tip = section("Tip", beam("Arm", o, hub, moving(modes), data), 1).point;
  }
};

// Rigid bars with springs between them; the first spring represents only half a bar.
struct slewing_bars : slewing {
  point_id tip{};
  explicit slewing_bars(int bars) {
    const double length = arm::length / bars, mass = arm::mass_per_length * length,
                 across = mass * length * length / 12;
    frame_id before = hub;
    point_id joint = o;
    for (int i = 0; i < bars; ++i) {
      const std::string name = std::to_string(i);
      const expression angle = moving();
      const frame_id bar = rotated("B" + name, before, angle, along(before, 0, 0, 1));
      torsional_spring(angle, number((i == 0 ? 2 : 1) * arm::stiffness / length));
      rigid_body("Bar" + name, offset("C" + name, joint, along(bar, length / 2, 0.0, 0.0)), bar, number(mass),
                 inertia(bar, 0.0, across, across));
      joint = offset("J" + name, joint, along(bar, length, 0.0, 0.0));
      before = bar;
    }
    tip = joint;
  }
};

// The value of a result at the end of a motion.
Eigen::VectorXd value_at_end(model m, const kanexpr::symbolic::matrix& result, const simulation<model>& run,
                             const Eigen::VectorXd& inputs = {}) {
  return m.function(result)(run.time, run.state, Eigen::VectorXd(), inputs).col(0);
}

// The torque changes its sign halfway.
TEST(slewing_arm, keeps_the_balance_of_momentum_and_energy) {
  constexpr double torque = 3, half = 0.6;
  const slewing_beam built(3);
  model m = kanexpr::derive(built);
  const kanexpr::symbolic::matrix momentum = m.get(quantity::angular_momentum);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(8);
  double work = 0;
  for (const double sign : {1.0, -1.0}) {
    const simulation<model> run = simulate(
        m, x, {}, {0, half},
        {.inputs = {{"T", sign * torque}}, .relative_tolerance = 1e-11, .absolute_tolerance = 1e-13});
    ASSERT_TRUE(run) << run.cause();
    work += sign * torque * (run.state["q1"] - x(0));
    const double energy = value_at_end(m, m.get(quantity::kinetic_energy), run)(0) +
                          value_at_end(m, m.get(quantity::potential_energy), run)(0);
    EXPECT_NEAR(energy, work, 1e-10 * torque);
    EXPECT_NEAR(value_at_end(m, momentum, run)(2), sign > 0 ? torque * half : 0, 1e-10 * torque);
    EXPECT_GT(run.state.tail(3).norm(), 1e-3);
    x = run.state;
  }
}

// The angle of the hub and the deflection of the tip after a slew by the torque T sin 2πt/s.
template <class Arm>
Eigen::Vector2d end_of_slew(int parts) {
  Arm built(parts);
  model m = kanexpr::derive(built);
  kanexpr::symbolic::matrix wanted(built.graph(), 2, 1);
  wanted(0, 0) = built.q[0];
  wanted(1, 0) = built.dot(built.position_of(built.tip, built.o), built.along(built.hub, 0, 1, 0));
  const simulation<model> run =
      simulate(m, Eigen::VectorXd(Eigen::VectorXd::Zero(2 * parts + 2)), {}, {0, 1},
               {.inputs = [](double t, const state<model>&,
                             input_values<model>& r) { r["T"] = 0.75 * std::sin(2 * pi * t); },
                .relative_tolerance = 1e-9,
                .absolute_tolerance = 1e-11});
  EXPECT_TRUE(run) << run.cause();
  return value_at_end(m, wanted, run, Eigen::VectorXd::Zero(1));
}

// The error of the bars is quadratic in their length; two numbers of bars are extrapolated.
TEST(slewing_arm, is_the_limit_of_many_rigid_bars) {
  const Eigen::Vector2d beam = end_of_slew<slewing_beam>(6), few = end_of_slew<slewing_bars>(8),
                        many = end_of_slew<slewing_bars>(16);
  const Eigen::Vector2d limit = (4 * many - few) / 3;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR((few - beam)(i) / (many - beam)(i), 4, 0.5) << i;
    EXPECT_NEAR(limit(i) / beam(i), 1, 0.003) << i;
  }
}

// ---- a free beam in space, with a body at its tip

// Follows a free motion, in which the energy and the momenta must not change.
void expect_conservation(const builder& of, const Eigen::VectorXd& x, double duration) {
  model m = kanexpr::derive(of);
  ASSERT_EQ(m.mistake(), "");
  const simulation<model> run =
      simulate(m, x, {}, {0, duration},
               {.relative_tolerance = 1e-12, .absolute_tolerance = 1e-14, .output_every = 0.1});
  ASSERT_TRUE(run) << run.cause();
  const std::vector<double> energy = run.trajectory.energies().total;
  const auto linear = run.trajectory.along(m.get(quantity::linear_momentum)),
             angular = run.trajectory.along(m.get(quantity::angular_momentum));
  for (std::size_t i = 0; i < energy.size(); ++i) {
    EXPECT_NEAR(energy[i], energy[0], 1e-10 * energy[0]);
    EXPECT_LE((linear[i] - linear[0]).norm(), 1e-10 * linear[0].norm());
    EXPECT_LE((angular[i] - angular[0]).norm(), 1e-10 * angular[0].norm());
  }
}

TEST(free_beam, conserves_momenta_and_energy) {
  numbered b;
  const std::vector<expression> q = b.moving(11);
  const frame_id own = b.body_fixed("B", b.ground, "xyz", q[3], q[4], q[5]);
  const point_id root = b.offset("A", b.o, b.along(b.ground, q[0], q[1], q[2]));
  beam_data data{.axis = b.along(own, 1, 0, 0), .length = 1.4, .mass_per_length = 0.8};
  data.bending = {{b.along(own, 0, 1, 0), {9.0, modes_of_bending(ends::free_free, 2)}},
                  {b.along(own, 0, 0, 1), {5.0, modes_of_bending(ends::free_free, 2)}}};
  for (auto& each : data.bending) each.by.moves_root = true;
  data.torsion = {.polar_inertia = 0.02, .by = {3.0, modes_of_rod(ends::free_free, 1)}};
  data.torsion->by.moves_root = true;
  const auto made = b.beam("Beam", root, own, {q.begin() + 6, q.end()}, data);
  const auto tip = b.section("Tip", made, 1);
  b.rigid_body("Load", b.offset("C", tip.point, b.along(tip.frame, 0.05, 0.1, 0.0)), tip.frame, b.number(0.1),
               b.inertia(tip.frame, 0.001, 0.002, 0.0025));
  Eigen::VectorXd x(22);
  x << 0.2, -0.1, 0.3, 0.3, 0.4, -0.2, 0.06, -0.02, 0.05, 0.01, 0.3, // positions
      0.1, 0.2, -0.3, 0.4, -0.5, 3, 0.2, 0.1, -0.3, 0.2, 0.5;        // speeds
  expect_conservation(b, x, 3);
}

// With the modes of a cantilever, on a base that is much lighter than the beam.
TEST(free_beam, conserves_momenta_and_energy_at_a_tenth_of_its_length) {
  numbered b;
  const std::vector<expression> q = b.moving(10);
  const frame_id own = b.body_fixed("B", b.ground, "xyz", q[3], q[4], q[5]);
  const point_id root = b.offset("A", b.o, b.along(b.ground, q[0], q[1], q[2]));
  b.rigid_body("Base", root, own, b.number(0.01), b.inertia(own, 0.01, 0.01, 0.01));
  beam_data data{.axis = b.along(own, 1, 0, 0), .length = 1.4, .mass_per_length = 0.8};
  data.bending = {{b.along(own, 0, 1, 0), {9.0, modes_of_bending(ends::clamped_free, 2)}},
                  {b.along(own, 0, 0, 1), {5.0, modes_of_bending(ends::clamped_free, 2)}}};
  b.beam("Beam", root, own, {q.begin() + 6, q.end()}, data);
  Eigen::VectorXd x(20);
  x << 0.2, -0.1, 0.3, 0.3, 0.4, -0.2, 0.14, -0.035, 0.1, 0.03, // positions
      0.1, 0.2, -0.3, 0.4, -0.5, 1, 0.2, 0.1, -0.3, 0.2;        // speeds
  expect_conservation(b, x, 3);
}

} // namespace
