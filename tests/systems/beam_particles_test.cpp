// builds: clang++ all
// Beams compared with particles at the Gauss points of their axes, which move by the same quadratic functions
// of the amplitudes. The kinetic energy of a beam is correct to the second order in the amplitudes and their
// rates, so its equations differ from those of the particles by known powers of the amplitudes.
#include "systems/jet.hpp"

#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hand_written::jet;
using hand_written::jets;
using hand_written::matrix;
using kanexpr::mechanics::method;
using kanexpr::mechanics::quantity;
using kanexpr::numeric::beams::shape;
using kanexpr::runtime::beam_data;
using kanexpr::runtime::beam_id;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::runtime::section_ids;
using kanexpr::symbolic::expression;
using place = hand_written::vector;

// The nodes and weights of an integral from 0 to b, exact for polynomials of degree 23.
std::vector<std::pair<double, double>> gauss_points(double b) {
  using rule = boost::math::quadrature::gauss<double, 12>;
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < rule::abscissa().size(); ++i)
    for (const double sign : {-1.0, 1.0})
      all.emplace_back(b / 2 * (1 + sign * rule::abscissa()[i]), b / 2 * rule::weights()[i]);
  return all;
}

// A shape c_1 ξ + c_2 ξ² + c_3 ξ³.
struct cubic {
  double c1, c2, c3;
  double value(double x) const { return x * (c1 + x * (c2 + x * c3)); }
  double slope(double x) const { return c1 + x * (2 * c2 + x * 3 * c3); }
  double curvature(double x) const { return 2 * c2 + x * 6 * c3; }
  shape given() const { return shape::polynomial({0.0, c1, c2, c3}); }
};

// The shapes of a beam along x of its frame: of the deflections v along y and w along z, of the torsion and
// of the extension. Amplitudes follow in this order, from `first` of the coordinates of the system.
struct beam_shapes {
  double length, mass_per_length, polar_inertia;
  std::vector<cubic> v, w, torsion, extension;
  std::size_t first;

  std::size_t size() const { return v.size() + w.size() + torsion.size() + extension.size(); }
  // Σ q_k f(shape k) of one deformation.
  template <class Function>
  jet sum(const jets& q, const std::vector<cubic>& of, Function f) const {
    std::size_t at = first;
    for (const std::vector<cubic>* each : {&v, &w, &torsion, &extension}) {
      if (each == &of) break;
      at += each->size();
    }
    jet total;
    for (const cubic& each : of) total += q[at++] * jet(f(each));
    return total;
  }
};

jet value(const beam_shapes& b, const jets& q, const std::vector<cubic>& of, double xi) {
  return b.sum(q, of, [&](const cubic& c) { return c.value(xi); });
}
jet slope(const beam_shapes& b, const jets& q, const std::vector<cubic>& of, double xi) {
  return b.sum(q, of, [&](const cubic& c) { return c.slope(xi) / b.length; });
}
jet curvature(const beam_shapes& b, const jets& q, const std::vector<cubic>& of, double xi) {
  return b.sum(q, of, [&](const cubic& c) { return c.curvature(xi) / (b.length * b.length); });
}

// The place of a particle of the axis, from the root in the frame of the beam.
place on_axis(const beam_shapes& b, const jets& q, double xi) {
  jet along = jet(xi * b.length) + value(b, q, b.extension, xi);
  for (const auto& [x, weight] : gauss_points(xi)) {
    const jet v = slope(b, q, b.v, x), w = slope(b, q, b.w, x);
    along -= jet(weight * b.length / 2) * (v * v + w * w);
  }
  return {along, value(b, q, b.v, xi), value(b, q, b.w, xi)};
}

matrix cross_product_matrix(const place& a) {
  matrix m;
  m << 0, -a(2), a(1), a(2), 0, -a(0), -a(1), a(0), 0;
  return m;
}

// The axes of a section, as columns in the frame of the beam, to the second order. Along the beam they turn
// with the curvature κ, so that R = E + [θ] + ∫ [θ] [κ] dx with θ = ∫ κ. The bending in κ follows from the
// tangent (1, v' − v' s', w' − w' s'), and its component along the tangent is the rate of torsion.
matrix section_axes(const beam_shapes& b, const jets& q, double xi) {
  const auto angles = [&](double x) -> place {
    return {value(b, q, b.torsion, x), -slope(b, q, b.w, x), slope(b, q, b.v, x)};
  };
  const jet stretch = slope(b, q, b.extension, xi);
  place by = angles(xi);
  by(1) += slope(b, q, b.w, xi) * stretch;
  by(2) -= slope(b, q, b.v, xi) * stretch;
  matrix r = matrix::Identity();
  for (const auto& [x, weight] : gauss_points(xi)) {
    const place rates{slope(b, q, b.torsion, x), -curvature(b, q, b.w, x), curvature(b, q, b.v, x)};
    const place now = angles(x);
    // the torsion turns the directions of bending
    by(1) += jet(weight * b.length) * (now(0) * rates(2));
    by(2) -= jet(weight * b.length) * (now(0) * rates(1));
    r += cross_product_matrix(now) * cross_product_matrix(rates) * jet(weight * b.length);
  }
  return r + cross_product_matrix(by);
}

// Masses at places in the inertial frame.
struct cloud {
  std::vector<double> masses{};
  std::vector<place> places{};

  void add(double mass, const place& at) { masses.push_back(mass), places.push_back(at); }
  // Masses on both sides of a point, whose moments ∫ x² dm along three directions are given.
  void add_pairs(const Vector3d& moments, const place& center, const matrix& axes) {
    constexpr double arm = 0.1;
    for (int i = 0; i < 3; ++i)
      for (const double sign : {-1.0, 1.0})
        add(moments(i) / (2 * arm * arm), center + axes.col(i) * jet(sign * arm));
    add(-moments.sum() / (arm * arm), center);
  }
  void add_beam(const beam_shapes& b, const jets& q, const place& root, const matrix& axes) {
    for (const auto& [xi, weight] : gauss_points(1)) {
      const double dx = weight * b.length;
      add(b.mass_per_length * (1 - 0.4 * xi) * dx, root + axes * on_axis(b, q, xi));
      const matrix twisted = axes * hand_written::turn_x(value(b, q, b.torsion, xi));
      const double half = b.polar_inertia * dx / 2; // ∫ y² dm, ∫ z² dm; ∫ x² dm is their opposite
      if (!b.torsion.empty()) add_pairs({-half, half, half}, root, twisted);
    }
  }
};

const beam_shapes first{.length = 1.3,
                        .mass_per_length = 0.9,
                        .polar_inertia = 0.05,
                        .v = {{0, 1, -0.3}, {0, -0.5, 1.2}},
                        .w = {{0, 0.7, 0.2}, {0, 1.1, -0.9}},
                        .torsion = {{1, -0.2, 0}},
                        .extension = {{0.8, 0.3, 0}},
                        .first = 6},
    second{.length = 0.8,
           .mass_per_length = 0.6,
           .polar_inertia = 0,
           .v = {{0, 1.2, -0.4}},
           .w = {{0, 0.9, 0.3}},
           .torsion = {},
           .extension = {},
           .first = 12},
    third{.length = 0.9,
          .mass_per_length = 0.5,
          .polar_inertia = 0,
          .v = {{0, 0.8, 0.1}},
          .w = {{0, 1.3, -0.2}},
          .torsion = {},
          .extension = {},
          .first = 14};
constexpr double bending_stiffness[]{2.0, 3.0}, torsional_stiffness = 1.5, axial_stiffness = 40;
constexpr double place_of_second = 0.6, tip_mass = 0.3, load_mass = 0.2;
const Vector3d load_moments{0.02, 0.03, 0.01}, free_fall{0.4, -9.81, 2};

constexpr double hub_radius = 0.2;

// A free beam; with a body at its tip; the same with its directions of bending exchanged; with a beam in its
// middle too, which carries a particle; or a turbine: on the tip of the first beam, a rotor with two other
// beams. A beam on a hub that only turns, whose root is at the center, or displaced along its axis or across
// it; and on a cart that only translates. A particle has the remaining coordinates of the base.
enum class system_of {
  one_beam,
  body_on_a_beam,
  with_directions_exchanged,
  two_beams,
  turbine,
  turning_hub,
  turning_hub_with_radius,
  turning_hub_with_offset,
  cart
};
bool is_hub(system_of what) {
  return what == system_of::turning_hub || what == system_of::turning_hub_with_radius ||
         what == system_of::turning_hub_with_offset;
}
Vector3d offset_on_hub(system_of what) {
  if (what == system_of::turning_hub_with_offset) return {hub_radius, -0.15, 0.1};
  return {what == system_of::turning_hub_with_radius ? hub_radius : 0, 0, 0};
}
int count_of(system_of what) {
  return what == system_of::turbine ? 17 : what == system_of::two_beams ? 14 : 12;
}
bool has_one_body(system_of what) {
  return what == system_of::body_on_a_beam || what == system_of::with_directions_exchanged;
}
// The coordinates of the base and of the rotor.
std::vector<int> rigid_coordinates(system_of what) {
  std::vector<int> all{0, 1, 2, 3, 4, 5};
  if (what == system_of::turbine) all.push_back(16);
  return all;
}
std::vector<int> amplitudes(system_of what) {
  std::vector<int> all;
  for (int i = 6; i < count_of(what) && i < 16; ++i) all.push_back(i);
  return all;
}

cloud particles_of(system_of what, const jets& q) {
  cloud all;
  place root{q[0], q[1], q[2]};
  if (what == system_of::cart) {
    all.add_beam(first, q, root, matrix::Identity());
    all.add(load_mass, {q[3], q[4], q[5]});
    return all;
  }
  const matrix axes = hand_written::turn_x(q[3]) * hand_written::turn_y(q[4]) * hand_written::turn_z(q[5]);
  if (is_hub(what)) {
    all.add(load_mass, root);
    const Vector3d offset = offset_on_hub(what);
    root = axes * place{jet(offset.x()), jet(offset.y()), jet(offset.z())};
  }
  all.add_beam(first, q, root, axes);
  if (what == system_of::one_beam || is_hub(what)) return all;
  const place end = root + axes * on_axis(first, q, 1);
  all.add(load_mass, end);
  all.add_pairs(load_moments, end, axes * section_axes(first, q, 1));
  if (has_one_body(what)) return all;
  if (what == system_of::turbine) {
    matrix rotor = axes * section_axes(first, q, 1) * hand_written::turn_z(q[16]);
    for (const beam_shapes& blade : {second, third}) {
      all.add_beam(blade, q, end + rotor.col(0) * jet(hub_radius), rotor);
      rotor *= hand_written::turn_z(jet(M_PI));
    }
    return all;
  }
  const place next = root + axes * on_axis(first, q, place_of_second);
  const matrix turned = axes * section_axes(first, q, place_of_second) * hand_written::turn_z(jet(0.7));
  all.add_beam(second, q, next, turned);
  all.add(tip_mass, next + turned * on_axis(second, q, 1));
  return all;
}

// M u' = f without the elastic forces.
struct equations {
  MatrixXd mass;
  VectorXd forcing;
};

equations of_particles(system_of what, const VectorXd& q, const VectorXd& u) {
  const Eigen::Index coordinates = q.size();
  const auto moved_by = [&](const VectorXd& rates) {
    jets now;
    for (Eigen::Index i = 0; i < coordinates; ++i) now.emplace_back(q(i), rates(i), 0);
    return particles_of(what, now);
  };
  std::vector<cloud> partial;
  for (Eigen::Index k = 0; k < coordinates; ++k) partial.push_back(moved_by(VectorXd::Unit(coordinates, k)));
  const cloud moving = moved_by(u);
  equations all{MatrixXd::Zero(coordinates, coordinates), VectorXd::Zero(coordinates)};
  for (std::size_t i = 0; i < moving.masses.size(); ++i) {
    MatrixXd velocity(3, coordinates);
    for (Eigen::Index k = 0; k < coordinates; ++k)
      velocity.col(k) = hand_written::rate(partial[static_cast<std::size_t>(k)].places[i]);
    const place& p = moving.places[i];
    const Vector3d bias{p(0).second, p(1).second, p(2).second};
    all.mass += moving.masses[i] * velocity.transpose() * velocity;
    all.forcing += moving.masses[i] * velocity.transpose() * (free_fall - bias);
  }
  return all;
}

// The elastic forces of a beam on its amplitudes.
void add_elastic_forces(const beam_shapes& b, const VectorXd& q, VectorXd& to) {
  auto at = static_cast<Eigen::Index>(b.first);
  const auto add = [&](const std::vector<cubic>& of, double stiffness,
                       double (cubic::*strain)(double) const) {
    const auto size = static_cast<Eigen::Index>(of.size());
    for (const auto& [xi, weight] : gauss_points(1)) {
      VectorXd strains(size);
      for (Eigen::Index k = 0; k < size; ++k) strains(k) = (of[static_cast<std::size_t>(k)].*strain)(xi);
      to.segment(at, size) -= weight * stiffness * strains.dot(q.segment(at, size)) * strains;
    }
    at += size;
  };
  const double cube = b.length * b.length * b.length;
  add(b.v, bending_stiffness[0] / cube, &cubic::curvature);
  add(b.w, bending_stiffness[1] / cube, &cubic::curvature);
  add(b.torsion, torsional_stiffness / b.length, &cubic::slope);
  add(b.extension, axial_stiffness / b.length, &cubic::slope);
}

// The same bodies in the library.
struct model_of_beams : builder {
  std::vector<expression> q;

  model_of_beams(system_of what, method by)
      : builder("N"), is_exchanged(what == system_of::with_directions_exchanged) {
    for (int i = 0; i < count_of(what); ++i) {
      q.push_back(coordinate("q" + std::to_string(i)));
      if (by == method::kane) kinematic_equation(dot(q.back()) - speed("u" + std::to_string(i)));
    }
    if (by == method::lagrange) rates_as_speeds();
    const frame_id n = inertial_frame();
    const point_id o = origin("O");
    gravity(along(n, free_fall.x(), free_fall.y(), free_fall.z()));
    const point_id moving = offset("A", o, along(n, q[0], q[1], q[2]));
    if (what == system_of::cart) {
      add("First", first, moving, n);
      particle("Load", offset("L", o, along(n, q[3], q[4], q[5])), number(load_mass));
      return;
    }
    const frame_id base = body_fixed("B", n, "xyz", q[3], q[4], q[5]);
    if (is_hub(what)) {
      const Vector3d at = offset_on_hub(what);
      add("First", first, offset("R", o, along(base, at.x(), at.y(), at.z())), base);
      particle("Load", moving, number(load_mass));
      return;
    }
    const beam_id carrier = add("First", first, moving, base);
    if (what == system_of::one_beam) return;
    const section_ids end = section("End", carrier, 1), middle = section("Middle", carrier, place_of_second);
    const Vector3d i = Vector3d::Constant(load_moments.sum()) - load_moments;
    rigid_body("Load", end.point, end.frame, number(load_mass), inertia(end.frame, i.x(), i.y(), i.z()));
    if (has_one_body(what)) return;
    if (what == system_of::turbine) {
      const frame_id rotor = rotated("R", end.frame, q[16], along(end.frame, 0, 0, 1)),
                     opposite = rotated("S", rotor, number(M_PI), along(rotor, 0, 0, 1));
      add("Second", second, offset("H", end.point, along(rotor, hub_radius, 0.0, 0.0)), rotor);
      add("Third", third, offset("I", end.point, along(opposite, hub_radius, 0.0, 0.0)), opposite);
      return;
    }
    const frame_id turned = rotated("T", middle.frame, number(0.7), along(middle.frame, 0, 0, 1));
    particle("Tip", section("P", add("Second", second, middle.point, turned), 1).point, number(tip_mass));
  }

private:
  bool is_exchanged;

  static std::vector<shape> given(const std::vector<cubic>& all) {
    std::vector<shape> shapes;
    for (const cubic& each : all) shapes.push_back(each.given());
    return shapes;
  }
  beam_id add(const std::string& called, const beam_shapes& b, point_id root, frame_id frame) {
    beam_data data{.axis = along(frame, 1, 0, 0), .length = b.length, .mass_per_length = b.mass_per_length};
    data.mass_profile = shape::polynomial({1.0, -0.4});
    data.bending = {{along(frame, 0, 1, 0), {.stiffness = bending_stiffness[0], .shapes = given(b.v)}},
                    {along(frame, 0, 0, 1), {.stiffness = bending_stiffness[1], .shapes = given(b.w)}}};
    if (!b.torsion.empty())
      data.torsion = {.polar_inertia = b.polar_inertia, .by = {torsional_stiffness, given(b.torsion)}};
    if (!b.extension.empty()) data.extension = {axial_stiffness, given(b.extension)};
    const auto from = q.begin() + static_cast<std::ptrdiff_t>(b.first);
    std::vector<expression> amplitudes(from, from + static_cast<std::ptrdiff_t>(b.size()));
    if (is_exchanged) { // the deflections along z first, which makes the directions left-handed
      std::swap(data.bending[0], data.bending[1]);
      const auto end_of_v = amplitudes.begin() + static_cast<std::ptrdiff_t>(b.v.size());
      std::rotate(amplitudes.begin(), end_of_v, end_of_v + static_cast<std::ptrdiff_t>(b.w.size()));
    }
    return beam(called, root, frame, amplitudes, data);
  }
};

// The greatest differences of five parts of the equations.
struct differences {
  double all[5];
};

differences between(system_of what, const equations& one, const equations& other) {
  const std::vector<int> rigid = rigid_coordinates(what), modal = amplitudes(what);
  const MatrixXd mass = (one.mass - other.mass).cwiseAbs();
  const VectorXd forcing = (one.forcing - other.forcing).cwiseAbs();
  return {mass(rigid, rigid).maxCoeff(), mass(rigid, modal).maxCoeff(), mass(modal, modal).maxCoeff(),
          forcing(rigid).maxCoeff(), forcing(modal).maxCoeff()};
}

class beams_of_particles : public testing::TestWithParam<system_of> {};

TEST_P(beams_of_particles, differ_from_beams_by_higher_powers_of_the_amplitudes) {
  const int count = count_of(GetParam());
  const model_of_beams built(GetParam(), method::kane);
  ASSERT_EQ(built.check().view(), "");
  kanexpr::model m = kanexpr::derive(built);
  auto mass = m.function(m.get(quantity::mass_matrix)), forcing = m.function(m.get(quantity::forcing));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(-1, 1);
  VectorXd x = VectorXd::NullaryExpr(2 * count, [&] { return draw(random); });
  constexpr double sizes[]{0.02, 0.01, 0.005};
  differences found[3];
  for (int i = 0; i < 3; ++i) {
    VectorXd now = x;
    for (const int k : amplitudes(GetParam())) now(k) *= sizes[i], now(count + k) *= sizes[i];
    equations expected = of_particles(GetParam(), now.head(count), now.tail(count));
    add_elastic_forces(first, now.head(count), expected.forcing);
    if (count > 12) add_elastic_forces(second, now.head(count), expected.forcing);
    if (count > 14) add_elastic_forces(third, now.head(count), expected.forcing);
    found[i] = between(GetParam(), {mass(now), forcing(now)}, expected);
  }
  constexpr double powers[]{3, 2, 1, 3, 2};
  const char* const parts[]{"rigid mass", "coupling", "modal mass", "rigid forcing", "modal forcing"};
  for (int part = 0; part < 5; ++part) {
    EXPECT_LT(found[2].all[part], 1e-2) << parts[part];
    if (found[0].all[part] < 1e-13) continue; // equal, as on a base that does not turn
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(std::log2(found[i].all[part] / found[i + 1].all[part]), powers[part], 0.1) << parts[part];
  }
}

TEST_P(beams_of_particles, have_the_same_equations_by_lagranges_method) {
  const int count = count_of(GetParam());
  kanexpr::model kane = kanexpr::derive(model_of_beams(GetParam(), method::kane)),
                 lagrange = kanexpr::derive(model_of_beams(GetParam(), method::lagrange));
  ASSERT_EQ(lagrange.mistake(), "");
  std::mt19937 random(6);
  std::uniform_real_distribution<double> draw(-0.3, 0.3);
  const VectorXd x = VectorXd::NullaryExpr(2 * count, [&] { return draw(random); });
  for (const quantity each : {quantity::mass_matrix, quantity::forcing}) {
    const MatrixXd expected = kane.function(kane.get(each))(x);
    const MatrixXd found = lagrange.function(lagrange.get(each))(x);
    EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(systems, beams_of_particles,
                         testing::Values(system_of::one_beam, system_of::body_on_a_beam,
                                         system_of::with_directions_exchanged, system_of::two_beams,
                                         system_of::turbine, system_of::turning_hub,
                                         system_of::turning_hub_with_radius,
                                         system_of::turning_hub_with_offset, system_of::cart));

} // namespace
