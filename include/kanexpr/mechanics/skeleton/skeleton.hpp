#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/skeleton/flexible_part.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/linear/solve_linear.hpp>

namespace kanexpr::mechanics {

/// A point of the skeleton and its motion: v = v_parent + ω_frame × r + relative_velocity.
struct station {
  int parent = none;
  bool absolute = false; ///< v = relative_velocity, measured from the ground
  int frame = mechanism::inertial;
  int offset_frame = mechanism::inertial; ///< the frame in whose axes `r` is given
  components r{};
  bool carried = true; ///< ṙ = ω_frame × r
  bool rigid = false; ///< r is actually constant in the frame, not merely treated as constant in the velocity
  vector relative_velocity{};
  int axes = mechanism::inertial; ///< the frame in whose working axes its motion and forces are expressed

  constexpr vector offset() const {
    vector v;
    v.add(offset_frame, r);
    return v;
  }
};

/// The mass properties of all bodies that move with a frame, about a station and in the frame's body axes.
struct link {
  int station = none;
  int frame = none;
  rigid_mass mass{};
};

/// The derivative with respect to one generalized speed of a vector that is linear in the speeds: a partial
/// velocity or a partial angular velocity.
struct partial_velocity {
  int speed = none;
  components value{};
};

/// A mechanism prepared for the dynamics. Frames that do not rotate relative to each other are merged, points
/// form a tree, masses that move as one body are combined, and every frame has the axes in which its
/// quantities are cheapest to form.
struct skeleton {
  const mechanism* model = nullptr;
  sequence<expression> coordinate_rates{};        ///< q̇ as expressions of q, u and t
  sequence<symbolic::solved_block> rate_blocks{}; ///< the coupled parts of the equations that determine them
  sequence<int> rigid_with{}; ///< by frame: the representative of the frames that rotate with it
  sequence<int> turns_in{};   ///< by representative: the frame in which its angular velocity is measured
  sequence<vector> relative_angular_velocity{}; ///< by representative: its angular velocity in that frame
  sequence<int> body_axes{}; ///< by representative: the axes in which its masses and offsets are given
  sequence<int>
      working_axes{}; ///< by representative: the axes in which its motion, forces and composites are formed
  sequence<sequence<partial_velocity>>
      partial_angular_velocities{}; ///< by representative: the partial derivatives of the relative angular
                                    ///< velocity, in working axes
  sequence<station> stations{};     ///< a parent precedes its children
  sequence<sequence<partial_velocity>>
      partial_velocities{}; ///< by station: the partial derivatives of its relative velocity, in working axes
  sequence<int> station_of_point{};
  sequence<link> links{};      ///< all masses, combined if they move as one body
  sequence<link> base_links{}; ///< an equivalent set with fewer parameters: masses are regrouped across
                               ///< joints, see base_parameters.hpp
  sequence<flexible_part> flexible_parts{};       ///< the flexible bodies, in the order of the mechanism
  sequence<components> offsets_in_working_axes{}; ///< by station, if they were needed

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.model, self.coordinate_rates, self.rate_blocks, self.rigid_with, self.turns_in,
          self.relative_angular_velocity, self.body_axes, self.working_axes, self.partial_angular_velocities,
          self.stations, self.partial_velocities, self.station_of_point, self.links, self.base_links,
          self.flexible_parts, self.offsets_in_working_axes);
  }

  /// Whether the inertia of a rigid body is given along axes that are fixed in the body, and about its mass
  /// center.
  constexpr bool has_own_axes(const body& b) const {
    if (b.is_off_center()) return false;
    for (const dyadic::part& p : b.inertia.parts)
      for (int axes : {p.left, p.right})
        if (rigid_with[axes] != rigid_with[b.frame]) return false;
    return true;
  }

  /// Whether frames or points have been added to the mechanism since the skeleton was formed.
  constexpr bool lacks_any() const {
    return rigid_with.size() < model->frames.size() || station_of_point.size() < model->points.size();
  }

  /// The offset of a station in working axes. It is formed when it is first needed, because the order of the
  /// nodes determines the code, and kept, because the path between the axes can be as long as a chain.
  constexpr const components& offset_in_working_axes(int n) const {
    // the elements are not part of the constant object; g++ evaluates no mutable members
    components& r = const_cast<components&>(offsets_in_working_axes[n]);
    const station& at = stations[n];
    if (!r.x.is_given()) r = express(*model, at.r, at.offset_frame, working_axes[at.frame]);
    return r;
  }

  /// The rotating frames; each precedes the frame in which it rotates.
  constexpr sequence<int> frames_tips_first() const {
    sequence<int> order;
    sequence<int> waiting(model->frames.size(), 0); // the number of unlisted frames that rotate in each frame
    for (int f = 1; f < model->frames.size(); ++f)
      if (rigid_with[f] == f) ++waiting[turns_in[f]];
    for (int f = 1; f < model->frames.size(); ++f)
      if (rigid_with[f] == f && waiting[f] == 0) order.push(f);
    for (int i = 0; i < order.size(); ++i) {
      const int below = turns_in[order[i]];
      if (--waiting[below] == 0 && below != mechanism::inertial) order.push(below);
    }
    return order;
  }

  /// The basis axis about which frame `f` rotates in its parent frame, or none if there is no such axis.
  constexpr int joint_axis(int f) const {
    const frame& own = model->frames[f];
    return own.kind == orientation::about_basis && !own.has_declared_angular_velocity() ? own.axis : none;
  }
};

} // namespace kanexpr::mechanics
