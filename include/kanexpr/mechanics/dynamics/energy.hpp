#pragma once

#include <kanexpr/mechanics/dynamics/flexible_inertia.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// Σ ½ m v·v + v·(ω×h) + ½ ω·I·ω over all links, and the kinetic energy of the flexible bodies.
constexpr expression kinetic_energy(motion& k) {
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  expression twice = m.zero();
  for (const link& l : s.links) {
    const path to_working(m, s.body_axes[l.frame], s.working_axes[l.frame]);
    const components v = k.velocity(l.station, l.frame), w = k.angular_velocity(l.frame);
    const components h = to_working.turn(l.mass.first_moment);
    expression of_link = l.mass.mass * dot(v, v);
    of_link += 2 * dot(v, cross(w, h));
    of_link += dot(w, to_working.turn(l.mass.inertia) * w);
    twice += of_link;
  }
  for (const flexible_part& p : s.flexible_parts) twice += twice_kinetic_energy(k, p);
  return twice / 2;
}

/// The energy of the bodies in uniform gravity, −Σ m g·x, with x measured from each body's origin point.
constexpr expression energy_of_gravity(const skeleton& s, const loads& acting) {
  const mechanism& m = *s.model;
  expression energy = m.zero();
  if (!acting.has_gravity) return energy;
  const auto add = [&](int point, expression mass) {
    for (int p = point; p != none; p = m.points[p].parent)
      for (const vector::part& offset : m.points[p].offset.parts)
        energy -= mass * dot(offset.value, express(m, acting.gravity, offset.frame));
  };
  for (const body& b : m.bodies) add(b.center, b.mass);
  for (const flexible_body& b : m.flexible_bodies) {
    add(b.reference, b.mass);
    energy -= dot(b.first_moment, express(m, acting.gravity, b.frame));
  }
  return energy;
}

/// The potential energy of gravity and of all other loads.
constexpr expression potential_energy(const skeleton& s, const loads& acting) {
  expression energy = energy_of_gravity(s, acting);
  acting.each([&](const auto& load, int) {
    if constexpr (requires { load.potential_energy(*s.model); }) energy += load.potential_energy(*s.model);
  });
  return energy;
}

/// Σ m v, in the axes of the inertial frame.
constexpr components linear_momentum(motion& k) {
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  components total(*m.g);
  for (const link& l : s.links) {
    const path to_working(m, s.body_axes[l.frame], s.working_axes[l.frame]);
    components p = l.mass.mass * k.velocity(l.station, l.frame);
    const components w = k.angular_velocity(l.frame), h = to_working.turn(l.mass.first_moment);
    p += cross(w, h);
    total += express(m, p, s.working_axes[l.frame], mechanism::inertial);
  }
  for (const flexible_part& p : s.flexible_parts)
    total += express(m, momentum(k, p).linear, p.axes, mechanism::inertial);
  return total;
}

/// The position of a point relative to its origin, in the axes of the inertial frame.
constexpr components position(const mechanism& m, int point) {
  return express(m, position_from_origin(m, point), mechanism::inertial);
}

/// Σ m x / Σ m, from the origin, in the axes of the inertial frame.
constexpr components center_of_mass(const skeleton& s) {
  const mechanism& m = *s.model;
  components moment(*m.g);
  expression mass = m.zero();
  for (const body& b : m.bodies) {
    moment += b.mass * position(m, b.center);
    mass += b.mass;
  }
  for (const flexible_body& b : m.flexible_bodies) {
    moment += b.mass * position(m, b.reference);
    moment += express(m, b.first_moment, b.frame, mechanism::inertial);
    mass += b.mass;
  }
  return {moment.x / mass, moment.y / mass, moment.z / mass};
}

/// Σ x×m v + I·ω about the origin, in the axes of the inertial frame.
constexpr components angular_momentum(motion& k) {
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  components total(*m.g);
  for (const body& b : m.bodies) {
    const int n = s.station_of_point[b.center];
    const components v = express(m, k.velocity(n), s.working_axes[s.stations[n].axes], mechanism::inertial);
    const components x = position(m, b.center), momentum = b.mass * v;
    total += cross(x, momentum);
  }
  for (const body& b : m.bodies) {
    if (b.frame == none) continue;
    const int f = s.rigid_with[b.frame];
    const components w = express(m, k.angular_velocity(f), s.working_axes[f], s.body_axes[f]);
    total += express(m, central_inertia(m, b, s.body_axes[f]) * w, s.body_axes[f], mechanism::inertial);
  }
  for (int i = 0; i < m.flexible_bodies.size(); ++i) {
    const flexible_part& p = s.flexible_parts[i];
    const flexible_momentum of_part = momentum(k, p);
    const components x = position(m, m.flexible_bodies[i].reference);
    total += cross(x, express(m, of_part.linear, p.axes, mechanism::inertial));
    const components about_reference = of_part.angular - cross(p.offset, of_part.linear);
    total += express(m, about_reference, p.axes, mechanism::inertial);
  }
  return total;
}

} // namespace kanexpr::mechanics
