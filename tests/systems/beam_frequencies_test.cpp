// builds: clang++ all
// Natural frequencies of beams at rest, in rotation and under axial loads, and the equation of a tower.
#include <kanexpr/base/name.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/beams/modes.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <Eigen/Eigenvalues>
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

namespace {

using Eigen::VectorXd;
using kanexpr::model;
using kanexpr::mechanics::quantity;
using kanexpr::numeric::beams::ends;
using kanexpr::numeric::beams::shape;
using kanexpr::runtime::beam_data;
using bending = struct kanexpr::runtime::beam_data::bending;
using kanexpr::runtime::beam_id;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::modes_of_bending;
using kanexpr::runtime::point_id;
using kanexpr::runtime::section_ids;
using kanexpr::symbolic::expression;
using numbers = std::vector<double>;

constexpr double length = 1.7, stiffness = 2.5, mass_per_length = 0.8, mass = mass_per_length * length;
const double unit = std::sqrt(stiffness / (mass_per_length * std::pow(length, 4))); // of frequencies

// A polynomial times the Legendre polynomials P_0(2ξ − 1), P_1(2ξ − 1), …
std::vector<shape> polynomials_times(const numbers& factor, int count) {
  std::vector<shape> all;
  numbers before(factor.size()), now = factor;
  for (int k = 0; k < count; ++k) {
    kanexpr::base::sequence<double> coefficients;
    for (const double each : now) coefficients.push(each);
    all.push_back(shape::polynomial(coefficients));
    numbers next(now.size() + 1);
    for (std::size_t i = 0; i < now.size(); ++i) {
      next[i] -= (2 * k + 1) * now[i] / (k + 1);
      next[i + 1] += 2 * (2 * k + 1) * now[i] / (k + 1);
    }
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= k * before[i] / (k + 1);
    before = now, now = next;
  }
  return all;
}
// ξ² P_k(2ξ − 1), for a clamped root.
std::vector<shape> polynomials(int count) { return polynomials_times({0, 0, 1}, count); }

// A model with one uniform beam.
struct beam_model : builder {
  frame_id ground = inertial_frame();
  point_id o = origin("O");
  beam_id made{};
  section_ids tip{};
  int coordinates = 0;
  numbers speeds{}; // in the steady motion, by coordinate

  beam_model() : builder("N") {}

  // A coordinate whose rate is a speed.
  expression moving(double steady_speed = 0) {
    const std::string number = std::to_string(++coordinates);
    const expression q = coordinate("q" + number);
    kinematic_equation(dot(q) - speed("u" + number));
    speeds.push_back(steady_speed);
    return q;
  }
  bending plane(frame_id in, double y, double z, const std::vector<shape>& shapes, bool moves_root = false) {
    return {along(in, 0, y, z), {.stiffness = stiffness, .shapes = shapes, .moves_root = moves_root}};
  }
  void add(point_id root, frame_id in, const std::vector<bending>& planes) {
    std::vector<expression> amplitudes;
    for (const bending& each : planes)
      for (std::size_t i = 0; i < each.by.shapes.size(); ++i) amplitudes.push_back(moving());
    const beam_data data{
        .axis = along(in, 1, 0, 0), .length = length, .mass_per_length = mass_per_length, .bending = planes};
    made = beam("Beam", root, in, amplitudes, data);
    tip = section("Tip", made, 1);
  }
};

// The eigenvalues of small motions about a steady motion, in which a prescribed angle has the given rate.
Eigen::VectorXcd eigenvalues(const beam_model& of, double rotation = 0) {
  model m = kanexpr::derive(of);
  EXPECT_EQ(m.mistake(), "");
  VectorXd x = VectorXd::Zero(2 * of.coordinates);
  x.tail(of.coordinates) = Eigen::Map<const VectorXd>(of.speeds.data(), of.coordinates);
  const Eigen::Vector3d angle(0, rotation * unit, 0);
  const Eigen::MatrixXd a = m.function(m.get(quantity::state_matrix))(0.0, x, VectorXd(), angle);
  EXPECT_TRUE(a.allFinite());
  return a.eigenvalues() / unit;
}

// The squares of the frequencies of these motions, without units.
numbers squares(const beam_model& of, double rotation = 0) {
  numbers found, once;
  for (const std::complex<double>& each : eigenvalues(of, rotation)) found.push_back(-(each * each).real());
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < found.size(); i += 2)
    once.push_back(found[i]); // each belongs to two eigenvalues
  return once;
}

void expect_frequencies(const numbers& found, const numbers& expected, std::size_t rigid_motions = 0,
                        double tolerance = 1e-9) {
  ASSERT_GE(found.size(), rigid_motions + expected.size());
  for (std::size_t i = 0; i < rigid_motions; ++i) EXPECT_NEAR(found[i], 0, 1e-9);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(std::sqrt(found[rigid_motions + i]) / expected[i], 1, tolerance);
}
numbers sorted(numbers some, const numbers& others) {
  some.insert(some.end(), others.begin(), others.end());
  std::sort(some.begin(), some.end());
  return some;
}

// ---- at rest: Blevins, Formulas for Natural Frequency and Mode Shape (1979), table 8-1

enum class root { clamped, pinned, free };

void hold(beam_model& b, root by, bool has_tip_support, int shapes) {
  frame_id in = b.ground;
  point_id at = b.o;
  if (by == root::free) at = b.offset("A", b.o, b.along(b.ground, b.moving(), b.moving(), 0));
  if (by != root::clamped) in = b.rotated("B", b.ground, b.moving(), b.along(b.ground, 0, 0, 1));
  b.add(at, in, {b.plane(in, 1, 0, polynomials(shapes))});
  if (has_tip_support)
    b.configuration_constraint(b.zero_along(b.position_of(b.tip.point, b.o), b.along(b.ground, 0, 1, 0)));
}

TEST(beam_frequencies, at_rest_depend_on_the_supports) {
  struct {
    root by;
    bool has_tip_support;
    std::size_t rigid;
    numbers expected;
  } cases[]{{root::clamped, false, 0, {3.5160152685002, 22.034491564667}},
            {root::clamped, true, 0, {15.418205716980061, 49.964862031800225}},
            {root::pinned, true, 0, {M_PI * M_PI, 4 * M_PI * M_PI}},
            {root::free, false, 3, {22.373285448061324, 61.672822867920245}}};
  for (const auto& each : cases) {
    beam_model b;
    hold(b, each.by, each.has_tip_support, 11);
    expect_frequencies(squares(b), each.expected, each.rigid, 1e-8);
  }
}

// ---- in rotation: frequencies of the functional ½∫ EI w''² + ½ Ω² ∫ T w'² (− ½ Ω² ∫ ρA w² in the plane of
// the rotation) with the tension Ω² T, by Ritz's method with 16 polynomials in 50 digits. The first ones out
// of the plane without a hub agree with Wright, Smith, Thresher & Wang (1982), J. Applied Mechanics 49,
// table 2.

struct rotation {
  double hub_radius, tip_mass, rate;
  numbers out_of_plane, in_plane;
};
const rotation rotations[]{
    {0, 0, 1, {3.681646813958, 22.181011150583}, {3.5432362696731, 22.15845788096}},
    {0, 0, 3, {4.7972785323631, 23.320263674296}, {3.7435118962108, 23.12649341856}},
    {0, 0, 6, {7.36037301931, 26.809081678498}, {4.2632254201938, 26.129042470867}},
    {1, 0, 1, {3.888823501561, 22.375014263835}, {3.7580511207664, 22.352656739342}},
    {1, 0, 3, {6.0817496849981, 24.927745231135}, {5.2903382907877, 24.7465650608}},
    {1, 0, 6, {10.44386586946, 32.027243982645}, {8.5483527243129, 31.460202750838}},
    {0.25, 0.5, 2, {3.176235824831, 18.508717530492}, {2.4674833363044, 18.400343057224}},
    {0.25, 0.5, 6, {7.4713438753529, 28.191468231819}, {4.4520758420959, 27.545578248889}}};

// A beam along x on a hub that turns about z; it bends in the plane of rotation and out of it.
struct blade_model : beam_model {
  void add_blade(frame_id hub, double hub_radius, double tip_mass, const std::vector<shape>& shapes) {
    add(offset("Root", o, along(hub, hub_radius * length, 0.0, 0.0)), hub,
        {plane(hub, 1, 0, shapes), plane(hub, 0, 1, shapes)});
    if (tip_mass > 0) particle("Load", tip.point, number(tip_mass * mass));
  }
};

TEST(beam_frequencies, in_rotation_at_a_prescribed_rate) {
  for (const rotation& each : rotations) {
    blade_model b;
    const frame_id hub = b.rotated("H", b.ground, b.prescribed("theta"), b.along(b.ground, 0, 0, 1));
    b.add_blade(hub, each.hub_radius, each.tip_mass, polynomials(9));
    expect_frequencies(squares(b, each.rate), sorted(each.out_of_plane, each.in_plane), 0, 1e-8);
  }
}

// The motion of the hub couples with bending in the plane of rotation: there, b b'/(I + J) is subtracted from
// the modal mass, with b = ∫ (r + x) w and the moments of inertia I of the hub and J of the beam.
TEST(beam_frequencies, in_rotation_on_a_hub_that_turns_freely) {
  struct {
    double hub_inertia, rate;
    numbers out_of_plane, in_plane;
  } const cases[]{{1, 0, {3.5160152685002, 22.034491564667}, {4.3773416925788, 22.464028089484}},
                  {1, 2, {4.322159710407, 22.805160213781}, {4.7748160589897, 23.139990711783}},
                  {10, 2, {4.322159710407, 22.805160213781}, {3.9417226112759, 22.760164747817}}};
  for (const auto& each : cases) {
    blade_model b;
    const frame_id hub = b.rotated("H", b.ground, b.moving(each.rate * unit), b.along(b.ground, 0, 0, 1));
    const double inertia = each.hub_inertia * mass * length * length;
    b.rigid_body("Hub", b.o, hub, b.number(1.0), b.inertia(hub, inertia, inertia, inertia));
    b.add_blade(hub, 0.25, 0, polynomials(10));
    expect_frequencies(squares(b), sorted(each.out_of_plane, each.in_plane), 1, 1e-8);
  }
}

// Southwell's theorem: with one shape, the square of the frequency is linear in that of the rate. The factors
// are the quotients of ∫ T φ'² and ∫ φ² of the first mode.
TEST(beam_frequencies, in_rotation_with_one_mode_have_southwells_factors) {
  for (const double hub_radius : {0.0, 0.7})
    for (const double rate : {1.0, 5.0}) {
      blade_model b;
      const frame_id hub = b.rotated("H", b.ground, b.prescribed("theta"), b.along(b.ground, 0, 0, 1));
      b.add_blade(hub, hub_radius, 0, modes_of_bending(ends::clamped_free, 1));
      const numbers found = squares(b, rate);
      const double at_rest = std::pow(1.8751040687119611, 4),
                   factor = 1.1933363741082559 + 1.5708781899942502 * hub_radius;
      EXPECT_NEAR(found[0], at_rest + (factor - 1) * rate * rate, 1e-12 * found[0]);
      EXPECT_NEAR(found[1], at_rest + factor * rate * rate, 1e-12 * found[1]);
    }
}

// Along the axis of a rotating rod, the centrifugal force of the displacement softens it by the square of the
// rate.
TEST(beam_frequencies, of_the_extension_of_a_rotating_rod) {
  beam_model b;
  const frame_id hub = b.rotated("H", b.ground, b.prescribed("theta"), b.along(b.ground, 0, 0, 1));
  beam_data data{.axis = b.along(hub, 1, 0, 0), .length = length, .mass_per_length = mass_per_length};
  const double axial = 70;
  data.extension = {axial, {kanexpr::numeric::beams::mode_of_rod(ends::clamped_free, 1)}};
  b.beam("Rod", b.o, hub, {b.moving()}, data);
  const double at_rest = M_PI * M_PI / 4 * axial / (mass_per_length * length * length) / (unit * unit);
  EXPECT_NEAR(squares(b, 3)[0], at_rest - 9, 1e-12 * at_rest);
}

// ---- under axial loads

// A beam that stands on a clamped root in a field of gravity, in units of EI/(ρA L³); it hangs if negative.
numbers squares_under_weight(double weight) {
  beam_model b;
  b.add(b.o, b.ground, {b.plane(b.ground, 1, 0, polynomials(10))});
  b.gravity(b.along(b.ground, -weight * stiffness / (mass_per_length * std::pow(length, 3)), 0.0, 0.0));
  return squares(b);
}

// Greenhill (1881): buckling at the square of 3/2 times the first root of the Bessel function of order −1/3.
TEST(beam_frequencies, vanish_where_a_beam_buckles_under_its_weight) {
  constexpr double critical = 7.837347438943484;
  const double at_rest = squares_under_weight(0)[0];
  EXPECT_NEAR(squares_under_weight(critical)[0], 0, 1e-9 * at_rest);
  EXPECT_GT(squares_under_weight(critical * (1 - 1e-6))[0], 0);
  EXPECT_LT(squares_under_weight(critical * (1 + 1e-6))[0], 0);
  expect_frequencies(squares_under_weight(4), {2.4629672046004, 21.234328165674});
  expect_frequencies(squares_under_weight(-5), {4.494313003313, 22.993532809916});
  expect_frequencies(squares_under_weight(-50), {9.468527340978, 30.217187921967}, 0, 1e-8);
}

// Forces at the tip along the undeformed axis, in units of EI/L².
TEST(beam_frequencies, vanish_at_eulers_loads) {
  struct {
    root by;
    bool has_tip_support;
    double critical;
  } const cases[]{{root::clamped, false, M_PI * M_PI / 4},
                  {root::pinned, true, M_PI * M_PI},
                  {root::clamped, true, 20.19072855642663}};
  for (const auto& each : cases) {
    const auto lowest = [&](double load) {
      beam_model b;
      hold(b, each.by, each.has_tip_support, 10);
      b.force(b.tip.point, b.along(b.ground, -load * stiffness / (length * length), 0.0, 0.0));
      return squares(b)[0];
    };
    EXPECT_NEAR(lowest(each.critical), 0, 1e-8 * lowest(0));
    EXPECT_GT(lowest(each.critical * (1 - 1e-6)), 0);
    EXPECT_LT(lowest(each.critical * (1 + 1e-6)), 0);
  }
}

// Beck (1952), Z. Angew. Math. Phys. 3: a force that follows the slope of the tip causes flutter.
TEST(beam_frequencies, coalesce_at_becks_load) {
  const auto greatest_growth = [](double load) {
    beam_model b;
    b.add(b.o, b.ground, {b.plane(b.ground, 1, 0, polynomials(10))});
    b.force(b.tip.point, b.along(b.tip.frame, -load * stiffness / (length * length), 0.0, 0.0));
    return eigenvalues(b).real().maxCoeff();
  };
  EXPECT_LT(greatest_growth(20.0509), 1e-6);
  EXPECT_GT(greatest_growth(20.0511), 1e-3);
}

// Greenhill (1883), Proc. Institution of Mechanical Engineers: a shaft on two bearings buckles under the
// torque 2π EI/L. The torques act about the fixed axis, so the bent shaft must turn its sections correctly.
TEST(beam_frequencies, vanish_at_greenhills_torque) {
  const auto lowest = [](double torque) {
    beam_model b;
    const std::vector<shape> shapes = polynomials_times({0, 1, -1}, 10);
    b.add(b.o, b.ground, {b.plane(b.ground, 1, 0, shapes, true), b.plane(b.ground, 0, 1, shapes, true)});
    const auto about_axis = [&](double t) { return b.along(b.ground, t * stiffness / length, 0.0, 0.0); };
    b.torque(b.tip.frame, about_axis(torque));
    b.torque(b.section("Root", b.made, 0.0).frame, about_axis(-torque));
    return squares(b)[0];
  };
  EXPECT_NEAR(lowest(2 * M_PI), 0, 1e-7 * lowest(0));
  EXPECT_GT(lowest(2 * M_PI * (1 - 1e-5)), 0);
  EXPECT_LT(lowest(2 * M_PI * (1 + 1e-5)), 0);
}

// ---- the limits of rigid bars

// A chain of rigid bars with springs between them, on a hub that turns about z; it bends in the plane of the
// rotation or out of it. The first spring represents only half a bar.
numbers squares_of_bars(int count, bool in_plane, double hub_radius, double rate) {
  beam_model b;
  frame_id before = b.rotated("H", b.ground, b.prescribed("theta"), b.along(b.ground, 0, 0, 1));
  point_id joint = b.offset("Root", b.o, b.along(before, hub_radius * length, 0.0, 0.0));
  const double part = length / count, across = mass_per_length * part * part * part / 12;
  for (int i = 0; i < count; ++i) {
    const std::string name = std::to_string(i);
    const expression angle = b.moving();
    const frame_id bar =
        b.rotated("B" + name, before, angle, b.along(before, 0, in_plane ? 0 : 1, in_plane ? 1 : 0));
    b.torsional_spring(angle, b.number((i == 0 ? 2 : 1) * stiffness / part));
    b.rigid_body("Bar" + name, b.offset("C" + name, joint, b.along(bar, part / 2, 0.0, 0.0)), bar,
                 b.number(mass_per_length * part), b.inertia(bar, 0.0, across, across));
    joint = b.offset("J" + name, joint, b.along(bar, part, 0.0, 0.0));
    before = bar;
  }
  return squares(b, rate);
}

TEST(beam_frequencies, are_the_limits_of_those_of_rotating_rigid_bars) {
  const rotation& at = rotations[4];
  for (const bool in_plane : {false, true}) {
    const double expected = std::pow((in_plane ? at.in_plane : at.out_of_plane)[0], 2);
    const auto error = [&](int count) {
      return squares_of_bars(count, in_plane, at.hub_radius, at.rate)[0] / expected - 1;
    };
    // extrapolated twice, since the error is even in the length of a bar
    const double few = error(8), more = error(16), many = error(32);
    const double first = (4 * more - few) / 3, second = (4 * many - more) / 3;
    EXPECT_NEAR(more / many, 4, 0.1);
    EXPECT_NEAR(first / second, 16, 1);
    EXPECT_NEAR((16 * second - first) / 15, 0, 2e-6);
  }
}

// A beam that swings as a pendulum. By Rayleigh's principle, the first effect of its compliance is the energy
// of the bending moments m g L ξ (1 − ξ)²/4 of the rigid swing: ω² = 3g/2L − ρA g² L²/(560 EI).
TEST(beam_frequencies, tend_to_those_of_a_rigid_rod) {
  constexpr double gravity = 9.81;
  double before = 0;
  for (const double stiffer : {10.0, 100.0}) {
    beam_model b;
    const frame_id in = b.rotated("B", b.ground, b.moving(), b.along(b.ground, 0, 0, 1));
    bending plane = b.plane(in, 1, 0, polynomials(5));
    plane.by.stiffness = stiffer * stiffness;
    b.add(b.o, in, {plane});
    b.gravity(b.along(b.ground, gravity, 0, 0));
    const double square = squares(b)[0] * unit * unit;
    const double deviation = (1.5 * gravity / length - square) * 560 * stiffer * stiffness /
                             (mass_per_length * std::pow(gravity * length, 2));
    EXPECT_NEAR(deviation, 1, 3 / stiffer);
    if (before > 0) {
      EXPECT_NEAR((before - 1) / (deviation - 1), 10, 0.5);
    }
    before = deviation;
  }
}

// ---- towers, clamped at the ground, with a nacelle and a rotor

// A tower along x that bends along y by one shape, with a rigid body whose mass center is at (up, out) from
// the top; as Branlard & Geisler (2022), Wind Energy Science 7, with the equation of motion derived by hand.
struct tower {
  double mass, stiffness, softening; // ∫ ρA φ², ∫ EI φ''² and ∫ ρA ∫ φ'² of the tower, by Gauss's rule
  double slope, shortening;          // at the top: φ' and ∫ φ'²
  double up, out, body_mass, body_inertia;
  double gravity;

  // M and f in M q'' = f, for a force at the mass center of the body along y.
  std::pair<double, double> equation(double q, double rate, double thrust) const {
    const double s = std::sin(slope * q), c = std::cos(slope * q);
    // the velocity of the mass center divided by q', and its derivative
    const double x = -shortening * q - slope * (up * s + out * c), y = 1 + slope * (up * c - out * s);
    const double dx = -shortening - slope * slope * (up * c - out * s),
                 dy = -slope * slope * (up * s + out * c);
    return {mass + body_mass * (x * x + y * y) + body_inertia * slope * slope,
            thrust * y - stiffness * q + gravity * softening * q - gravity * body_mass * x -
                body_mass * (x * dx + y * dy) * rate * rate};
  }
};

TEST(tower, has_the_equation_derived_by_hand) {
  const auto integral = [](auto f, double to = 1) {
    return boost::math::quadrature::gauss<double, 15>::integrate(f, 0.0, to);
  };
  const shape deflection = shape::polynomial({0.0, 0.0, 1.4, -0.4});
  const auto shortened = [&](double to) {
    return integral([&](double x) { return std::pow(deflection.at(x).slope, 2) / length; }, to);
  };
  const tower by_hand{
      .mass = integral([&](double x) { return mass * (1 - 0.5 * x) * std::pow(deflection.at(x).value, 2); }),
      .stiffness = integral([&](double x) {
        return stiffness * (1 - 0.7 * x) * std::pow(deflection.at(x).curvature, 2) / std::pow(length, 3);
      }),
      .softening = integral([&](double x) { return mass * (1 - 0.5 * x) * shortened(x); }),
      .slope = deflection.at(1).slope / length,
      .shortening = shortened(1),
      .up = 0.2,
      .out = -0.3,
      .body_mass = 0.6,
      .body_inertia = 0.05,
      .gravity = 1.1};
  beam_model b;
  const expression q = b.moving(), thrust = b.input("F");
  const bending plane{
      b.along(b.ground, 0, 1, 0),
      {.stiffness = stiffness, .shapes = {deflection}, .profile = shape::polynomial({1.0, -0.7})}};
  const section_ids top = b.section("Top",
                                    b.beam("Tower", b.o, b.ground, {q},
                                           {.axis = b.along(b.ground, 1, 0, 0),
                                            .length = length,
                                            .mass_per_length = mass_per_length,
                                            .bending = {plane},
                                            .mass_profile = shape::polynomial({1.0, -0.5})}),
                                    1);
  const point_id center = b.offset("C", top.point, b.along(top.frame, by_hand.up, by_hand.out, 0.0));
  b.rigid_body("Nacelle", center, top.frame, b.number(by_hand.body_mass),
               b.inertia(top.frame, 0.05, 0.05, by_hand.body_inertia));
  b.gravity(b.along(b.ground, -by_hand.gravity, 0.0, 0.0));
  b.force(center, b.along(b.ground, 0, thrust, 0));
  model m = kanexpr::derive(b);
  ASSERT_EQ(m.mistake(), "");
  auto mass_matrix = m.function(m.mass_matrix()), forcing = m.function(m.forcing());
  for (const auto& [x, push] :
       {std::pair{Eigen::Vector2d(0.3, -0.7), 0.4}, std::pair{Eigen::Vector2d(-0.2, 1.9), 1.3}}) {
    const auto [expected_mass, expected_forcing] = by_hand.equation(x(0), x(1), push);
    const Eigen::Matrix<double, 1, 1> input(push);
    EXPECT_NEAR(mass_matrix(0.0, x, VectorXd(), input)(0, 0), expected_mass, 1e-12 * expected_mass);
    EXPECT_NEAR(forcing(0.0, x, VectorXd(), input)(0, 0), expected_forcing,
                1e-12 * std::abs(expected_forcing));
  }
}

// A tower by one shape function, 1 at the top, that turns a nacelle with a rotor by the slope ν q, as in
// Branlard & Geisler (2022), Wind Energy Science 7, doi:10.5194/wes-7-2351-2022. Their equation is of first
// order in ν. Gravity, which bends the tower further, is part of their stiffness.
struct sloped_tower {
  double modal_mass = 1.9, stiffness = 40, damping = 0.7; // Me, Ke, De
  double mass = 2.3, inertia = 0.4, x = -0.3, z = 0.5;    // of nacelle and rotor, in tilted axes
  double hub_x = -0.6, hub_z = 0.35, tilt = 0.15, gravity = 9.81;

  // M and f in M q'' = f, for a slope, and a thrust and a moment on the nacelle.
  Eigen::Vector2d equation(double slope, const Eigen::Vector2d& state, const Eigen::Vector2d& loads) const {
    builder b("N");
    const frame_id n = b.inertial_frame();
    const expression q = b.coordinate("q"), thrust = b.input("T"), moment = b.input("M");
    b.kinematic_equation(b.dot(q) - b.speed("u"));
    kanexpr::mechanics::flexible_data d(1);
    d.mass = 8, d.modal_mass = {modal_mass}, d.stiffness = {stiffness}, d.damping = {damping};
    d.inertia.constant(0) = d.inertia.constant(1) = 30;
    kanexpr::mechanics::flexible_node top{.called = kanexpr::base::name("top"),
                                          .position = kanexpr::mechanics::taylor_series(3, 1)};
    top.position.constant(2) = 3, top.position.linear(0, 0) = 1;
    top.orientation = {1, 0, 0, 0, 1, 0, 0, 0, 1}, top.rotation = {0, slope, 0};
    d.nodes.push(top);
    const section_ids at = b.node("Top", b.flexible_body("Tower", b.origin("O"), n, {q}, d), "top");
    const frame_id tilted = b.rotated("Tilted", at.frame, b.number(tilt), b.along(at.frame, 0, 1, 0));
    const point_id center = b.offset("G", at.point, b.along(tilted, x, 0.0, z)),
                   hub = b.offset("R", at.point, b.along(tilted, hub_x, 0.0, hub_z));
    b.rigid_body("Nacelle", center, tilted, b.number(mass), b.inertia(tilted, 0.6, inertia, 0.7));
    b.gravity(b.along(n, 0.0, 0.0, -gravity));
    b.force(hub, b.along(tilted, thrust, 0, 0));
    b.torque(tilted, b.along(tilted, 0, moment, 0));
    model m = kanexpr::derive(b);
    EXPECT_EQ(m.mistake(), "");
    return {m.function(m.mass_matrix())(0.0, state, VectorXd(), loads)(0, 0),
            m.function(m.forcing())(0.0, state, VectorXd(), loads)(0, 0)};
  }
  // The same to the first order in the slope: its value and its derivative.
  std::pair<Eigen::Vector2d, Eigen::Vector2d> expected(const Eigen::Vector2d& state,
                                                       const Eigen::Vector2d& loads) const {
    const double s = std::sin(tilt), c = std::cos(tilt);
    return {{modal_mass + mass, loads[0] * c - stiffness * state[0] - damping * state[1]},
            {2 * mass * (z * c - x * s),
             mass * gravity * (x * c + z * s) + loads[0] * (hub_z - state[0] * s) + loads[1]}};
  }
};

TEST(tower, has_the_equation_of_branlard_and_geisler_to_the_first_order_in_the_slope) {
  const sloped_tower of;
  for (const auto& [state, loads] : {std::pair{Eigen::Vector2d(0.3, -0.7), Eigen::Vector2d(1.4, -2)},
                                     std::pair{Eigen::Vector2d(-0.6, 1.9), Eigen::Vector2d(-3.1, 0.8)}}) {
    const auto [value, derivative] = of.expected(state, loads);
    const auto difference = [&](double slope) -> Eigen::Vector2d {
      return of.equation(slope, state, loads) - of.equation(-slope, state, loads);
    };
    constexpr double h = 0.02; // differences of eighth order
    const Eigen::Vector2d found =
        (672 * difference(h) - 168 * difference(2 * h) + 32 * difference(3 * h) - 3 * difference(4 * h)) /
        (840 * h);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(of.equation(0, state, loads)[i], value[i], 1e-13 * std::abs(value[i]));
      EXPECT_NEAR(found[i], derivative[i], 2e-12 * std::abs(value[i]));
    }
  }
}

} // namespace
