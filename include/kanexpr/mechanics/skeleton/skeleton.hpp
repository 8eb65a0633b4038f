#pragma once

#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/symbolic/linear/solve_linear.hpp>

namespace kanexpr::mechanics {

/// A point of the skeleton and how it moves: v = v_parent + ω_frame × r + relative_velocity.
struct station {
  int parent = none;
  bool absolute = false; ///< v = relative_velocity alone, measured from the ground
  int frame = mechanism::inertial;
  int offset_frame = mechanism::inertial; ///< the frame whose axes `r` is given in
  components r{};
  bool carried = true; ///< ṙ = ω_frame × r
  bool rigid = false;  ///< r is fixed in the frame, in fact and not only for the velocity
  vector relative_velocity{};
  int axes = mechanism::inertial; ///< the frame in whose working axes its motion and forces are given

  constexpr vector offset() const {
    vector v;
    v.add(offset_frame, r);
    return v;
  }
};

/// The mass that moves as one with a frame, seen from a station, in the frame's body axes.
struct link {
  int station = none;
  int frame = none;
  rigid_mass mass{};
};

/// What a unit of one generalized speed adds to a vector that is linear in the speeds: a partial velocity or
/// a partial angular velocity.
struct partial_velocity {
  int speed = none;
  components value{};
};

/// A mechanism made ready for the dynamics: frames that do not turn in each other are one, points form a tree
/// of steps, masses are gathered where they move as one, and every frame has the axes in which its quantities
/// are cheapest to form.
struct skeleton {
  const mechanism* model = nullptr;
  sequence<expression> coordinate_rates{};        ///< q̇ as expressions of q, u and t
  sequence<symbolic::solved_block> rate_blocks{}; ///< the coupled parts of the equations that gave them
  sequence<int> rigid_with{}; ///< by frame: the frame that stands for all that turn with it
  sequence<int> turns_in{};   ///< by such frame: the one that its angular velocity is measured in
  sequence<vector> relative_angular_velocity{}; ///< by such frame: that angular velocity
  sequence<int> body_axes{}; ///< by such frame: the axes in which its masses and offsets are given
  sequence<int>
      working_axes{}; ///< by such frame: the axes in which its motion, forces and composites are formed
  sequence<sequence<partial_velocity>>
      partial_angular_velocities{}; ///< by such frame: the partial derivatives of that, in working axes
  sequence<station> stations{};     ///< a parent comes before its children
  sequence<sequence<partial_velocity>>
      partial_velocities{}; ///< by station: the partial derivatives of its relative velocity, in working axes
  sequence<int> station_of_point{};
  sequence<link> links{};      ///< every mass, gathered where it moves as one
  sequence<link> base_links{}; ///< the same motion with fewer numbers: masses regrouped across joints, see
                               ///< base_parameters.hpp

  /// Whether the mechanism has frames or points that were added later.
  constexpr bool lacks_any() const {
    return rigid_with.size() < model->frames.size() || station_of_point.size() < model->points.size();
  }

  constexpr components offset_in_working_axes(int n) const {
    const station& at = stations[n];
    return express(*model, at.r, at.offset_frame, working_axes[at.frame]);
  }

  /// Frames that turn, those farther from the ground before those that they turn in.
  constexpr sequence<int> frames_tips_first() const {
    sequence<int> order;
    sequence<int> waiting(model->frames.size(), 0); // how many frames turn in this one and are not listed yet
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

  /// The basis axis that frame `f` turns about in the frame below it, or none: no single one.
  constexpr int joint_axis(int f) const {
    const frame& own = model->frames[f];
    return own.kind == orientation::about_basis && !own.turns_by_declaration() ? own.axis : none;
  }
};

} // namespace kanexpr::mechanics
