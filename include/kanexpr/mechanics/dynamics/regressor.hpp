#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/generalized_force.hpp>
#include <kanexpr/mechanics/dynamics/inertia_moment.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertial_parameter.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

/// Inverse dynamics as a linear function of the inertial parameters of the bodies. Each parameter is treated
/// separately; the result does not depend on the masses and inertias that the model specifies.
#include <utility>

namespace kanexpr::mechanics {

/// The point of a body about which its inertial parameters are given: the last point fixed in the body on the
/// chain from the mass center toward the ground, which is the joint of the body; the mass center if there is
/// no such point.
constexpr int reference_point(const skeleton& s, const body& b) {
  const mechanism& m = *s.model;
  symbolic::differentiation along_time = time_derivative(m, s.coordinate_rates);
  const auto is_fixed = [&](const point& p) {
    if (p.parent == none || p.has_declared_velocity()) return false;
    for (const vector::part& part : p.offset.parts) {
      if (s.rigid_with[part.frame] != s.rigid_with[b.frame]) return false;
      for (int i = 0; i < 3; ++i)
        if (!along_time.of(part.value[i]).is_zero()) return false;
    }
    return true;
  };
  int at = b.center;
  while (b.frame != none && is_fixed(m.points[at])) at = m.points[at].parent;
  return at;
}

/// The inertial parameters of all bodies, with the values given in the model.
constexpr sequence<expression> inertial_values(const skeleton& s) {
  const mechanism& m = *s.model;
  sequence<expression> all;
  for (const body& b : m.bodies) {
    all.push(b.mass);
    if (b.frame == none) continue;
    const int at = reference_point(s, b);
    rigid_mass mass(*m.g);
    mass.mass = b.mass;
    mass.inertia = central_inertia(m, b, b.frame);
    mass = shifted(mass, express(m, position_from(m, at, b.center), b.frame));
    if (b.about == at) mass.inertia = inertia_in(m, b.inertia, b.frame);
    for (int i = 0; i < 3; ++i) all.push(mass.first_moment[i]);
    for (const expression& e : {mass.inertia.xx, mass.inertia.yy, mass.inertia.zz, mass.inertia.xy,
                                mass.inertia.yz, mass.inertia.zx})
      all.push(e);
  }
  return all;
}

/// Reports a flexible body, which has no constant inertial parameters.
constexpr sentence check_rigidity(const mechanism& m) {
  if (m.flexible_bodies.empty()) return {};
  return sentence({"the inertial parameters and the regressor require rigid bodies; ",
                   m.flexible_bodies[0].called.view(), " is flexible"});
}

/// Reports a mass or inertia that changes, because the resulting forces are not linear in it.
constexpr sentence check_regressor(const skeleton& s, motion& k) {
  for (const body& b : s.model->bodies)
    if (generalized_forces(s).add_change_of_mass(k, b))
      return sentence(
          {"the regressor requires constant masses and inertias; those of ", b.called.view(), " change"});
  return {};
}

/// The generalized forces for all speeds per unit of each inertial parameter in a motion on accelerated
/// ground, with a column for each parameter: Σ v_r·R + ω_r·T with the partial velocities of the bodies, which
/// all parameters of a body share.
constexpr symbolic::matrix regressor_of_all(const skeleton& s, motion& k) {
  const mechanism& m = *s.model;
  sequence<symbolic::differentiation> by_speed;
  for (const expression& u : m.speeds) {
    symbolic::differentiation d(*m.g);
    d.set_rate(u, m.one());
    by_speed.push(std::move(d));
  }
  const auto partial = [&](int speed, const components& v) -> components {
    symbolic::differentiation& d = by_speed[speed];
    return {d.of(v.x), d.of(v.y), d.of(v.z)};
  };
  int columns = 0;
  for (const body& b : m.bodies) columns += inertial_parameters_of(b);
  symbolic::matrix y(*m.g, m.speeds.size(), columns);
  int first = 0;
  for (const body& b : m.bodies) {
    const int n = s.station_of_point[reference_point(s, b)];
    const int f = b.frame == none ? s.stations[n].axes : s.rigid_with[b.frame];
    const int axes = b.frame == none ? s.working_axes[f] : b.frame;
    const auto in_axes = [&](const components& v) { return express(m, v, s.working_axes[f], axes); };
    const components v = in_axes(k.velocity(n, f)), a = in_axes(k.acceleration(n, f));
    for (int r = 0; r < y.rows; ++r) y(r, first) = dot(partial(r, v), a);
    if (b.frame != none) {
      const components w = in_axes(k.angular_velocity(f)), alpha = in_axes(k.angular_acceleration(f));
      const matrix3 u = acceleration_matrix(w, alpha);
      for (int i = 0; i < 3; ++i) {
        const components force{u(0, i), u(1, i), u(2, i)}, moment = cross(unit(*m.g, i), a);
        for (int r = 0; r < y.rows; ++r) {
          y(r, first + 1 + i) = dot(partial(r, v), force);
          y(r, first + 1 + i) += dot(partial(r, w), moment);
        }
      }
      for (int i = 0; i < 6; ++i) {
        symmetric one(*m.g);
        (i < 3 ? one(i, i) : one(i - 3, (i - 2) % 3)) = m.one();
        const components moment = inertia_moment(one, w, alpha, u);
        for (int r = 0; r < y.rows; ++r) y(r, first + 4 + i) = dot(partial(r, w), moment);
      }
    }
    first += inertial_parameters_of(b);
  }
  return y;
}

} // namespace kanexpr::mechanics
