#pragma once

#include <kanexpr/mechanics/model/central_inertia.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/axes.hpp>
#include <kanexpr/mechanics/skeleton/base_parameters.hpp>
#include <kanexpr/mechanics/skeleton/flexible_parts.hpp>
#include <kanexpr/mechanics/skeleton/joint_points.hpp>
#include <kanexpr/mechanics/skeleton/kinematic_equations.hpp>
#include <kanexpr/mechanics/skeleton/partial_velocities.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/time_derivative.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>

namespace kanexpr::mechanics {

namespace detail {

/// Converts the parts of a mechanism that are missing from its skeleton into stations and links, with every
/// coordinate rate replaced by its solution of the kinematic equations.
class skeleton_builder {
public:
  constexpr explicit skeleton_builder(skeleton& s)
      : m_(*s.model), s_(s), known_(m_, s.coordinate_rates),
        along_time_(time_derivative(m_, s.coordinate_rates)) {}

  constexpr void frames() {
    const int before = s_.rigid_with.size();
    for (int f = before; f < m_.frames.size(); ++f) {
      const frame& own = m_.frames[f];
      s_.relative_angular_velocity.push(relative_angular_velocity_of(f));
      const bool turns = f != mechanism::inertial &&
                         (own.has_declared_angular_velocity() || !s_.relative_angular_velocity[f].is_zero());
      s_.rigid_with.push(f == mechanism::inertial || turns ? f : s_.rigid_with[own.parent]);
    }
    for (int f = before; f < m_.frames.size(); ++f) {
      const frame& own = m_.frames[f];
      const int in = own.has_declared_angular_velocity() ? own.reference : own.parent;
      s_.turns_in.push(in == none ? none : s_.rigid_with[in]);
    }
  }

  constexpr void points() {
    for (int p = s_.station_of_point.size(); p < m_.points.size(); ++p) {
      const point& at = m_.points[p];
      if (at.parent == none)
        s_.station_of_point.push(s_.stations.push({.absolute = true, .r = components(*m_.g)}));
      else if (at.has_declared_velocity())
        s_.station_of_point.push(declared_station(at));
      else
        s_.station_of_point.push(offset_stations(at));
    }
  }

  constexpr void masses() {
    for (const body& b : m_.bodies) {
      const int at = s_.station_of_point[b.center];
      link l{at, b.frame == none ? s_.stations[at].frame : s_.rigid_with[b.frame], rigid_mass(*m_.g)};
      l.mass.mass = b.mass;
      if (b.frame != none) l.mass.inertia = central_inertia(m_, b, s_.body_axes[l.frame]);
      s_.links.push(l);
    }
  }

  /// Expresses offsets that are fixed in their frame in the body axes of the frame.
  constexpr void express_offsets(int from = 0) {
    for (int i = from; i < s_.stations.size(); ++i) {
      station& n = s_.stations[i];
      if (!n.rigid) continue;
      const int axes = s_.body_axes[n.frame];
      n.r = express(m_, n.r, n.offset_frame, axes);
      n.offset_frame = axes;
    }
  }

private:
  constexpr vector relative_angular_velocity_of(int f) {
    const frame& own = m_.frames[f];
    if (own.has_declared_angular_velocity()) return known_.in(own.angular_velocity);
    return relative_angular_velocity(m_, f, along_time_);
  }

  constexpr bool is_at_rest(int station) const {
    const auto is_carried = [&] {
      return s_.stations[station].rigid && s_.stations[station].frame == mechanism::inertial;
    };
    while (!s_.stations[station].absolute && is_carried()) station = s_.stations[station].parent;
    return s_.stations[station].absolute && s_.stations[station].relative_velocity.is_zero();
  }

  /// Adds a station with a declared velocity: by the one-point theorem, or with a velocity measured from the
  /// ground.
  constexpr int declared_station(const point& at) {
    const vector v = known_.in(at.velocity);
    const int in = s_.rigid_with[at.reference];
    if (!at.from_parent || (in == mechanism::inertial && is_at_rest(s_.station_of_point[at.parent]))) {
      const int axes = v.parts.empty() ? mechanism::inertial : s_.rigid_with[v.parts[0].frame];
      return s_.stations.push({.parent = s_.station_of_point[at.parent],
                               .absolute = true,
                               .r = components(*m_.g),
                               .relative_velocity = v,
                               .axes = axes});
    }
    int last = s_.station_of_point[at.parent];
    const bool carried = !at.moves_apart; // otherwise, ṙ need not equal ω × r
    for (const vector::part& p : at.offset.parts) last = push_step(last, in, p, carried);
    if (at.offset.parts.empty()) last = push_step(last, in, {in, components(*m_.g)}, true);
    s_.stations[last].relative_velocity = v;
    s_.stations[last].rigid = false;
    return last;
  }

  constexpr int offset_stations(const point& at) {
    int last = s_.station_of_point[at.parent];
    if (at.fixed_in != none) return fixed_station(at, last);
    for (const vector::part& p : at.offset.parts) {
      if (p.value.is_zero()) continue;
      last = push_step(last, s_.rigid_with[p.frame], p, true);
      const components growth{along_time_.of(p.value.x), along_time_.of(p.value.y),
                              along_time_.of(p.value.z)};
      if (growth.is_zero()) continue;
      s_.stations[last].relative_velocity.add(p.frame, growth);
      s_.stations[last].rigid = false;
    }
    return last;
  }

  /// Adds a station by the two-point theorem, with the whole offset in the axes of one frame, so that common
  /// terms of its parts may cancel.
  constexpr int fixed_station(const point& at, int parent) {
    const int in = s_.rigid_with[at.fixed_in];
    vector::part whole{in, components(*m_.g)};
    int deepest = -1;
    bool rigid = true;
    for (const vector::part& p : at.offset.parts) {
      const int depth = path::depth(m_, p.frame);
      if (depth > deepest) whole.frame = p.frame, deepest = depth;
      rigid = rigid && s_.rigid_with[p.frame] == in;
    }
    whole.value = express(m_, at.offset, whole.frame);
    for (int i = 0; i < 3; ++i) rigid = rigid && along_time_.of(whole.value[i]).is_zero();
    return whole.value.is_zero() ? parent : push_step(parent, in, whole, rigid);
  }

  constexpr int push_step(int parent, int in, const vector::part& offset, bool carried) {
    return s_.stations.push({.parent = parent,
                             .frame = in,
                             .offset_frame = offset.frame,
                             .r = offset.value,
                             .carried = carried,
                             .rigid = carried && s_.rigid_with[offset.frame] == in,
                             .axes = in});
  }

  const mechanism& m_;
  skeleton& s_;
  known_rates known_;
  symbolic::differentiation along_time_;
};

} // namespace detail

constexpr skeleton skeleton_of(const mechanism& m) {
  const solved_rates solved = solve_kinematics(m);
  skeleton s{.model = &m, .coordinate_rates = solved.rates, .rate_blocks = solved.blocks};
  detail::skeleton_builder build(s);
  build.frames();
  build.points();
  choose_body_axes(s);
  build.masses();
  build.express_offsets();
  merge_rigid_offsets(s);
  place_joint_points(s);
  gather_masses(s);
  choose_working_axes(s);
  form_partial_velocities(s);
  form_flexible_parts(s);
  s.offsets_in_working_axes.resize(s.stations.size());
  return s;
}

/// Adds the frames and points that were added to the mechanism after its skeleton was formed. The existing
/// skeleton is unchanged, so that results do not depend on later additions.
constexpr void extend(skeleton& s) {
  const int frames = s.rigid_with.size(), stations = s.stations.size();
  detail::skeleton_builder build(s);
  build.frames();
  build.points();
  choose_axes_from(s, frames);
  build.express_offsets(stations);
  merge_rigid_offsets(s, stations);
  form_partial_velocities(s);
  s.offsets_in_working_axes.resize(s.stations.size());
}

} // namespace kanexpr::mechanics
