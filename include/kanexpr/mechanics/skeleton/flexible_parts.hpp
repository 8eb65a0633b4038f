#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/flexible_part.hpp>
#include <kanexpr/mechanics/skeleton/moved_by_speeds.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::mechanics {

namespace detail {

constexpr components derivative(symbolic::differentiation& d, const components& v) {
  return {d.of(v.x), d.of(v.y), d.of(v.z)};
}

constexpr symmetric derivative(symbolic::differentiation& d, const symmetric& a) {
  symmetric rate;
  rate.xx = d.of(a.xx), rate.yy = d.of(a.yy), rate.zz = d.of(a.zz);
  rate.xy = d.of(a.xy), rate.yz = d.of(a.yz), rate.zx = d.of(a.zx);
  return rate;
}

/// The derivatives of the rate of an amplitude with respect to all speeds on which it depends.
constexpr sequence<flexible_part::rate_partial> partials_of_rate(const mechanism& m, expression rate) {
  sequence<flexible_part::rate_partial> found;
  symbolic::differentiation by_speed(*m.g);
  for (int r = 0; r < m.speeds.size(); ++r) {
    by_speed.restart();
    by_speed.set_rate(m.speeds[r], m.one());
    const expression value = by_speed.of(rate);
    if (!value.is_zero()) found.push({r, value});
  }
  return found;
}

/// Finds the innermost station that is fixed in the frame of the body, from which the points of the frame are
/// measured.
constexpr void find_joint(const skeleton& s, flexible_part& part) {
  part.offset = components(*s.model->g);
  for (const station* at = &s.stations[part.station];
       at->rigid && !at->absolute && at->frame == part.frame && at->parent != none;
       at = &s.stations[part.station]) {
    part.offset += express(*s.model, at->r, at->offset_frame, part.axes);
    part.station = at->parent;
  }
}

/// Prepares one flexible body.
class flexible_part_builder {
public:
  constexpr flexible_part_builder(const skeleton& s, const flexible_body& b)
      : s_(s), m_(*s.model), b_(b), by_amplitude_(*s.model->g) {
    part_.station = s.station_of_point[b.reference];
    part_.frame = s.rigid_with[b.frame], part_.axes = b.frame;
    part_.modal_mass = b.modal_mass;
    find_joint(s, part_);
  }

  /// Chooses the integrals with the fewest terms for which the kinetic energy is positive; see
  /// `beam_expressions`.
  constexpr const flexible_part& run() {
    const definite_inertia& definite = b_.definite;
    const bool is_turned = is_turned_by_speeds(s_, part_.frame);
    const bool moves_along = definite.is_given() && is_moved_along(s_, part_, definite.axis);
    if (!definite.is_given() || !(is_turned || moves_along)) {
      form(b_.first_moment, b_.inertia, b_.angular, {});
    } else if (!part_.offset.is_zero() || is_moved_by_speeds(s_, part_.station)) {
      form(definite.first_moment, definite.inertia, definite.angular, definite.about_center);
      if (moves_along) add_rate(part_.displacements[0], definite.about_center[0]);
    } else {
      form(b_.first_moment, definite.inertia, definite.angular, definite.about_root);
    }
    return part_;
  }

private:
  constexpr void form(const components& first_moment, const symmetric& inertia,
                      const sequence<components>& angular, const sequence<axial_displacement>& along) {
    part_.mass.mass = b_.mass, part_.mass.first_moment = first_moment, part_.mass.inertia = inertia;
    part_.mass = shifted(part_.mass, part_.offset);
    sequence<symmetric> linear; // the coefficients of the displacements in J
    for (const axial_displacement& y : along) {
      rigid_mass moved(*m_.g);
      moved.first_moment = y.first_moment, moved.inertia = y.inertia;
      linear.push(shifted(moved, part_.offset).inertia);
    }
    add_amplitudes(angular, along, linear);
    for (int i = 0; i < along.size(); ++i) add_displacement(along[i], linear[i]);
    for (int i = 0; i < along.size(); ++i) {
      part_.mass.first_moment += along[i].value * along[i].first_moment;
      part_.mass.inertia =
          part_.mass.inertia + along[i].value * (linear[i] + along[i].value * along[i].squared);
    }
  }

  constexpr void differentiate_by(int k) {
    by_amplitude_.restart();
    by_amplitude_.set_rate(b_.amplitudes[k], m_.one());
  }

  constexpr void add_amplitudes(const sequence<components>& angular,
                                const sequence<axial_displacement>& along,
                                const sequence<symmetric>& linear) {
    part_.amplitudes.resize(size());
    for (int k = 0; k < size(); ++k) {
      flexible_part::amplitude& each = part_.amplitudes[k];
      differentiate_by(k);
      each.translation = derivative(by_amplitude_, part_.mass.first_moment);
      each.rotation = angular[k] + cross(part_.offset, each.translation);
      each.growth = derivative(by_amplitude_, part_.mass.inertia);
      for (int i = 0; i < along.size(); ++i) {
        each.rotation += along[i].value * along[i].angular[k];
        each.growth = each.growth + along[i].value * derivative(by_amplitude_, linear[i]);
      }
      each.rate = s_.coordinate_rates[m_.coordinates.find(b_.amplitudes[k])];
      each.partials = partials_of_rate(m_, each.rate);
    }
    for (int l = 0; l < size(); ++l) {
      differentiate_by(l);
      for (int k = 0; k < size(); ++k) {
        flexible_part::amplitude& each = part_.amplitudes[k];
        each.translation_rate.push(derivative(by_amplitude_, each.translation));
        const components arm = cross(part_.offset, each.translation);
        each.rotation_rate.push(derivative(by_amplitude_, angular[k] + arm));
      }
    }
  }

  constexpr void add_displacement(const axial_displacement& along, const symmetric& linear) {
    flexible_part::displacement y;
    y.rate = y.bias = y.mass = m_.zero();
    for (int k = 0; k < size(); ++k) {
      differentiate_by(k);
      y.gradient.push(by_amplitude_.of(along.value));
      y.rate += y.gradient[k] * part_.amplitudes[k].rate;
    }
    symbolic::differentiation along_time(*m_.g);
    for (int k = 0; k < size(); ++k) along_time.set_rate(b_.amplitudes[k], part_.amplitudes[k].rate);
    for (int k = 0; k < size(); ++k) y.bias += along_time.of(y.gradient[k]) * part_.amplitudes[k].rate;
    y.translation = along.first_moment;
    y.rotation = cross(part_.offset, along.first_moment);
    y.growth = linear + (2 * along.value) * along.squared;
    y.rotation_rate = along.angular;
    y.rotation_by_amplitude.resize(size(), components(*m_.g));
    y.coupling.resize(size(), m_.zero());
    part_.displacements.push(y);
  }

  /// Adds the rate of a displacement of the whole body to the kinetic energy.
  constexpr void add_rate(flexible_part::displacement& y, const axial_displacement& along) {
    const components& axis = b_.definite.axis;
    y.mass = b_.mass, y.coupling = along.coupling;
    y.rotation += cross(b_.definite.first_moment, axis);
    for (int k = 0; k < size(); ++k)
      y.rotation_by_amplitude[k] = cross(part_.amplitudes[k].translation, axis);
  }

  constexpr int size() const { return b_.amplitudes.size(); }

  const skeleton& s_;
  const mechanism& m_;
  const flexible_body& b_;
  symbolic::differentiation by_amplitude_;
  flexible_part part_{};
};

} // namespace detail

/// Prepares the flexible bodies of a mechanism.
constexpr void form_flexible_parts(skeleton& s) {
  for (const flexible_body& b : s.model->flexible_bodies)
    s.flexible_parts.push(detail::flexible_part_builder(s, b).run());
}

} // namespace kanexpr::mechanics
