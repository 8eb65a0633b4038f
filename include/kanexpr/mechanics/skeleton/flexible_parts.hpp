#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/flexible_part.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

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
/// measured, and moves the mass there.
constexpr void move_to_joint(const skeleton& s, flexible_part& part) {
  part.offset = components(*s.model->g);
  for (const station* at = &s.stations[part.station];
       at->rigid && !at->absolute && at->frame == part.frame && at->parent != none;
       at = &s.stations[part.station]) {
    part.offset += express(*s.model, at->r, at->offset_frame, part.axes);
    part.station = at->parent;
  }
  part.mass = shifted(part.mass, part.offset);
}

constexpr flexible_part flexible_part_of(const skeleton& s, const flexible_body& b) {
  const mechanism& m = *s.model;
  flexible_part part{
      .station = s.station_of_point[b.reference], .frame = s.rigid_with[b.frame], .axes = b.frame};
  part.mass.mass = b.mass, part.mass.first_moment = b.first_moment, part.mass.inertia = b.inertia;
  part.modal_mass = b.modal_mass;
  move_to_joint(s, part);
  symbolic::differentiation by_amplitude(*m.g);
  const int count = b.amplitudes.size();
  part.amplitudes.resize(count);
  for (int k = 0; k < count; ++k) {
    flexible_part::amplitude& each = part.amplitudes[k];
    by_amplitude.restart();
    by_amplitude.set_rate(b.amplitudes[k], m.one());
    each.translation = derivative(by_amplitude, part.mass.first_moment);
    each.rotation = b.angular[k] + cross(part.offset, each.translation);
    each.growth = derivative(by_amplitude, part.mass.inertia);
    each.rate = s.coordinate_rates[m.coordinates.find(b.amplitudes[k])];
    each.partials = partials_of_rate(m, each.rate);
  }
  for (int l = 0; l < count; ++l) {
    by_amplitude.restart();
    by_amplitude.set_rate(b.amplitudes[l], m.one());
    for (flexible_part::amplitude& each : part.amplitudes) {
      each.translation_rate.push(derivative(by_amplitude, each.translation));
      each.rotation_rate.push(derivative(by_amplitude, each.rotation));
    }
  }
  return part;
}

} // namespace detail

/// Prepares the flexible bodies of a mechanism.
constexpr void form_flexible_parts(skeleton& s) {
  for (const flexible_body& b : s.model->flexible_bodies)
    s.flexible_parts.push(detail::flexible_part_of(s, b));
}

} // namespace kanexpr::mechanics
