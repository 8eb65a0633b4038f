// The rows of elements for wheels with tyres: every law on every rim and ground.
#pragma once

#include "element.hpp"
#include "elements.hpp"
#include "tyre_law_functions.hpp"

#include <kanexpr/runtime/building/tyre_data.hpp>
#include <kanexpr/runtime/building/wheel_data.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <memory>
#include <optional>

namespace elements {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using kanexpr::runtime::tyre_data;
using mechanics::tyre_model;

/// A wheel that moves freely over a ground that moves itself. A random state is near the ground: the
/// coordinates are multiplied by the constants below.
struct wheel_over_ground : builder {
  static constexpr double radius = 0.3, height = 0.28, aside = 0.05, sinking = 0.03, turning = 0.5,
                          leaning = 0.4, tilting = 0.2;

  std::vector<expression> q;
  frame_id n = inertial_frame(), inclined{}, wheel_frame{}, tilted{};
  point_id hub{}, ground{};

  wheel_over_ground() : builder("N") {
    for (const char* called : {"x", "y", "z", "yaw", "lean", "spin", "tilt", "shift"})
      q.push_back(coordinate(called));
    for (const expression& each : q) {
      const expression u = speed("u" + std::to_string(mechanism().speeds.size()));
      kinematic_equation(dot(each) - u);
    }
    const frame_id yawed = rotated("Y", n, turning * q[3], along(n, 0, 0, 1));
    inclined = rotated("L", yawed, leaning * q[4], along(yawed, 1, 0, 0));
    wheel_frame = rotated("B", inclined, q[5], along(inclined, 0, 1, 0));
    tilted = rotated("G", n, tilting * q[6], along(n, 1, 0, 0));
    const point_id o = origin("O");
    hub = offset("Hub", o, along(n, q[0], aside * q[1], height + sinking * q[2]));
    ground = offset("Ground", o, along(n, 0, aside * q[7], 0));
    rigid_body("Wheel", hub, wheel_frame, number(1.3), inertia(wheel_frame, 0.2, 0.3, 0.2));
    rigid_body("Board", ground, tilted, number(2), inertia(tilted, 1.1, 1.2, 1.3));
  }
};

/// The motion of the wheel relative to the ground, in its axes, written out in numbers. Velocities are
/// derivatives of positions by complex steps.
struct motion_over_ground {
  Vector3d axis{}, velocity{}, turning{};

  explicit motion_over_ground(const VectorXd& state) {
    using complex = std::complex<double>;
    const Eigen::VectorXcd q = state.head(8) + complex(0, 1e-30) * state.segment(8, 8);
    const double tilt = wheel_over_ground::tilting;
    const Eigen::Matrix3cd to_ground = about(0, tilt * q(6)).transpose();
    const Eigen::Matrix3cd inclined =
        to_ground * about(2, wheel_over_ground::turning * q(3)) * about(0, wheel_over_ground::leaning * q(4));
    const Eigen::Matrix3cd attitude = inclined * about(1, q(5));
    const Eigen::Vector3cd center =
        to_ground * Eigen::Vector3cd(q(0), wheel_over_ground::aside * (q(1) - q(7)),
                                     wheel_over_ground::height + wheel_over_ground::sinking * q(2));
    const Matrix3d spin = attitude.imag() / 1e-30 * attitude.real().transpose();
    axis = inclined.real().col(1), velocity = center.imag() / 1e-30;
    turning << spin(2, 1), spin(0, 2), spin(1, 0);
  }

private:
  static Eigen::Matrix3cd about(int axis, std::complex<double> angle) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    Eigen::Matrix3cd m = Eigen::Matrix3cd::Identity();
    m(i, i) = m(j, j) = std::cos(angle);
    m(j, i) = std::sin(angle), m(i, j) = -m(j, i);
    return m;
  }
};

struct tyre_row {
  std::string name;
  nature is{};
  double camber = 0, trail = 0; ///< the stiffness C_γ and the pneumatic trail
  bool has_spring = false;      ///< a radial stiffness; otherwise, the load is given
  bool lags = false;            ///< has relaxation lengths
  double effective_radius = 0;  ///< 0: the loaded radius
};

/// A tyre with its law as a function of numbers.
struct tyre_with_law {
  static constexpr double standstill = 0.3, slip = 2.5, cornering = 2, friction = 0.8, along = 0.3,
                          across = 0.5;

  tyre_row row;
  tyre_model model{};
  std::shared_ptr<tyre_laws::law_function> law{};

  tyre_with_law(const tyre_row& of, tyre_model by) : row(of), model(by) {
    using namespace tyre_laws;
    const auto made = [](const auto& given) { return std::make_shared<law_function>(given, standstill); };
    switch (model) {
    case tyre_model::linear: law = made(linear(slip, cornering, row.camber, row.trail)); break;
    case tyre_model::brush: law = made(brush(friction, slip, cornering, row.trail, row.camber)); break;
    case tyre_model::magic_formula: law = made(formula(magic_formula_reference::passenger_car)); break;
    }
  }

  double stiffness() const { return model == tyre_model::magic_formula ? 1e5 : 30; }
  static constexpr double width = 0.02, damping = 0.6, given_load_per_stiffness = 0.03;

  tyre_data data(builder& b) const {
    tyre_data t = of_model();
    if (row.has_spring)
      t.radial = {stiffness(), damping, width};
    else if (model != tyre_model::linear)
      t.load = given_load_per_stiffness * stiffness();
    if (row.camber > 0) t.camber_stiffness = row.camber;
    if (row.trail > 0) t.trail = row.trail;
    if (row.effective_radius > 0) t.effective_radius = row.effective_radius;
    if (row.lags) t.relaxation = {along, across, b.state_variable("dx"), b.state_variable("dy")};
    t.standstill = standstill;
    return t;
  }

private:
  tyre_data of_model() const {
    switch (model) {
    case tyre_model::linear: return tyre_data::linear(slip, cornering);
    case tyre_model::brush: return tyre_data::brush(friction, slip, cornering);
    case tyre_model::magic_formula: break;
    }
    tyre_data::coefficients c;
    std::size_t i = 0;
    tyre_data::coefficients::each_member(c, [&](auto&... each) {
      ((each = magic_formula_reference::passenger_car.coefficients.at(i++)), ...);
    });
    return tyre_data::of_formula(c);
  }
};

/// The power of the ground on the tyre. The numbers are the state, the penetration, the normal, the direction
/// forward and the vector from the center to the contact.
inline double power_of_tyre(const tyre_with_law& t, const VectorXd& m) {
  const Eigen::Index contact = m.size() - 10;
  const double penetration = m(contact);
  const Vector3d normal = m.segment<3>(contact + 1), forward = m.segment<3>(contact + 4), arm = m.tail<3>(),
                 lateral = normal.cross(forward);
  const motion_over_ground moves(m);
  const Vector3d v = moves.velocity + moves.turning.cross(arm);
  const double approach = -v.dot(normal), camber = moves.axis.dot(normal),
               radius = (arm - arm.dot(moves.axis) * moves.axis).norm();
  Matrix3d parts; // the angular velocity is the sum of spin, turning and leaning
  parts << moves.axis, normal, forward;
  const double spin = Vector3d(parts.inverse() * moves.turning)(0);

  const double speed = v.dot(forward) + radius * spin,
               x = t.row.effective_radius > 0 ? speed - t.row.effective_radius * spin : v.dot(forward),
               y = v.dot(lateral), reference = t.model == tyre_model::brush ? speed - x : speed;
  const double elastic = tyre_with_law::width; // the width of the transition
  double load = 0;
  if (t.row.has_spring) {
    const double s = std::fmin(std::fmax((penetration + elastic) / (2 * elastic), 0), 1);
    load = t.stiffness() * one_sided(penetration + elastic, 2 * elastic) * s * s * (3 - 2 * s) *
           hunt_and_crossley(tyre_with_law::damping, approach);
  } else if (t.model != tyre_model::linear)
    load = tyre_with_law::given_load_per_stiffness * t.stiffness();
  const double passing = std::hypot(reference, tyre_with_law::standstill);
  double forward_slip = -x / passing, lateral_slip = -y / passing;
  if (t.row.lags) {
    forward_slip = m(16) / tyre_with_law::along, lateral_slip = m(17) / tyre_with_law::across;
    if (t.model != tyre_model::linear) {
      const double squared = forward_slip * forward_slip + lateral_slip * lateral_slip,
                   rest = 1 - squared / std::sqrt(squared + 1e-8), room = one_sided(rest, 0.05) + 0.025;
      forward_slip /= room, lateral_slip /= room;
    }
  }
  const auto f = t.law->at<double>({load, forward_slip, lateral_slip, camber, speed});
  const double normal_force = t.row.has_spring ? load : 0; // a given load acts only through the law
  Vector3d torque = f[2] * forward + f[3] * lateral + f[4] * normal;
  if (t.row.effective_radius > 0) torque -= f[0] * (t.row.effective_radius - radius) * moves.axis;
  return (f[0] * forward + f[1] * lateral + normal_force * normal).dot(v) + torque.dot(moves.turning);
}

using wheels_contact = std::function<kanexpr::runtime::wheel_on_ground(wheel_over_ground&)>;

inline element tyre_on(const std::string& ground, const wheels_contact& lay, const tyre_with_law& t) {
  element e{t.row.name + ", " + ground, t.row.is, {}, {}};
  e.build = [lay, t] {
    wheel_over_ground b;
    const kanexpr::runtime::wheel_on_ground wheel = lay(b);
    b.tyre(wheel, t.data(b));
    const mechanics::wheel_contact at = wheel.contact(b.mechanism());
    mechanism_with_element made{derive(b), {}, {}};
    const mechanics::mechanism& m = made.model.mechanism();
    for (const auto* list : {&m.coordinates, &m.speeds})
      for (const expression& each : *list) made.measured.push_back(each);
    made.measured.push_back(at.penetration);
    for (const components* each : {&at.normal, &at.forward, &at.arm})
      for (int i = 0; i < 3; ++i) made.measured.push_back((*each)[i]);
    if (t.row.lags && t.row.is == nature::dissipative) // the tyre is a spring
      made.stored = tyre_with_law::slip / tyre_with_law::along / 2 * (m.speeds[8] * m.speeds[8]) +
                    tyre_with_law::cornering / tyre_with_law::across / 2 * (m.speeds[9] * m.speeds[9]);
    return made;
  };
  e.power = [t](const VectorXd& m) { return power_of_tyre(t, m); };
  return e;
}

inline std::vector<element> on_wheels() {
  using n = nature;
  const auto wheel = [](wheel_over_ground& b, double tube, double conicity = 0) {
    return kanexpr::runtime::wheel_data{b.hub,    b.wheel_frame, b.along(b.inclined, 0, 1, 0),
                                        b.radius, tube,          conicity};
  };
  const auto on_plane = [wheel](double tube) -> wheels_contact {
    return [=](wheel_over_ground& b) {
      return b.wheel_on_plane(wheel(b, tube), b.ground, b.along(b.tilted, 0, 0, 1));
    };
  };
  const auto on_bumps = [wheel](double tube) -> wheels_contact {
    return [=](wheel_over_ground& b) {
      return b.wheel_on_surface(
          wheel(b, tube), b.ground, b.tilted,
          [](expression x, expression y) { return 0.02 * cos(2 * x) - 0.03 * y * y; }, 1);
    };
  };
  const wheels_contact on_rail = [wheel](wheel_over_ground& b) {
    return b.wheel_on_rail(wheel(b, 0, 0.1),
                           {b.ground, b.along(b.tilted, 1, 0.2, 0), b.along(b.tilted, 0, 0, 1), 0.25});
  };
  const auto along_rail = [on_rail](const tyre_with_law& t) {
    element e = tyre_on("conical wheel on a rail", on_rail, t);
    e.settle = [](VectorXd& x) { // where the axis of the wheel is about horizontal and across the rail
      for (const Eigen::Index angle : {3, 4, 6}) x(angle) *= 0.2;
    };
    return e;
  };
  const tyre_row leaning{"leaning linear tyre", n::driven, 0.7, 0.04},
      sprung{"linear tyre", n::dissipative, 0, 0, true},
      lagging{"linear tyre with relaxation", n::dissipative, 0, 0, true, true},
      bristles{"brush tyre", n::dissipative, 0, 0, true},
      all{"brush tyre with camber, trail and radius", n::driven, 0.7, 0.04, true, false, 0.27},
      lagging_bristles{"brush tyre with relaxation", n::driven, 0.7, 0.04, false, true},
      formula{"Magic Formula", n::driven}, sprung_formula{"Magic Formula on a spring", n::driven, 0, 0, true},
      lagging_formula{"Magic Formula with relaxation", n::driven, 0, 0, false, true, 0.27};
  const auto driven = [](tyre_row row) { return row.is = n::driven, row; }; // has no energy on uneven ground
  const tyre_model linear = tyre_model::linear, brush = tyre_model::brush, magic = tyre_model::magic_formula;
  return {tyre_on("thin wheel", on_plane(0), {leaning, linear}),
          tyre_on("thin wheel", on_plane(0), {sprung, linear}),
          tyre_on("toroidal wheel", on_plane(0.06), {lagging, linear}),
          tyre_on("toroidal wheel", on_plane(0.06), {bristles, brush}),
          tyre_on("thin wheel", on_plane(0), {all, brush}),
          tyre_on("toroidal wheel", on_plane(0.06), {lagging_bristles, brush}),
          tyre_on("thin wheel", on_plane(0), {formula, magic}),
          tyre_on("toroidal wheel", on_plane(0.06), {sprung_formula, magic}),
          tyre_on("thin wheel", on_plane(0), {lagging_formula, magic}),
          tyre_on("thin wheel on uneven ground", on_bumps(0), {driven(sprung), linear}),
          tyre_on("toroidal wheel on uneven ground", on_bumps(0.06), {all, brush}),
          along_rail({sprung, linear}),
          along_rail({bristles, brush}),
          along_rail({lagging_bristles, brush})};
}

} // namespace elements
