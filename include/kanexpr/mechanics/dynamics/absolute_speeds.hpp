#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/articulated_bodies.hpp>
#include <kanexpr/mechanics/dynamics/kane.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

namespace kanexpr::mechanics {

/// Equations of a tree for the absolute angular velocities of bodies that rotate about parallel axes of the
/// ground, in place of their speeds relative to the body below. The matrix for these speeds w is sparser in
/// operations, because each body moves the bodies outward of it without rotating them. With u_i = w_i ± w_j,
/// where j is the speed of the body below, the forces follow from F_w = (∂u/∂w)ᵀ F_u, and u̇ from ẇ.
class absolute_speeds {
public:
  constexpr explicit absolute_speeds(const skeleton& s) : given_(s), s_(s), below_(s.model->speeds.size()) {
    const mechanism& m = *s.model;
    sequence<int> motions(m.ways(), 0); // by speed: the number of frames and stations that it moves
    for (const auto* each : {&s.partial_angular_velocities, &s.partial_velocities})
      for (const sequence<partial_velocity>& partials : *each)
        for (const partial_velocity& v : partials) ++motions[v.speed];
    const sequence<int> order = s.frames_tips_first();
    for (int i = order.size() - 1; i >= 0; --i) measure_from_ground(order[i], motions);
  }
  absolute_speeds(const absolute_speeds&) = delete;
  absolute_speeds& operator=(const absolute_speeds&) = delete;

  /// Whether any speed is replaced.
  constexpr bool is_any() const { return any_; }

  /// u̇, with the pivots of the elimination of the matrix for the internal speeds.
  constexpr symbolic::symmetric_solution solve(const loads& acting, bool by_articulated_bodies) const {
    const mechanism& m = *s_.model;
    sequence<expression> force = forces_of_loads(given_, acting);
    for (int i = 0; i < below_.size(); ++i)
      if (below_[i].speed != none) force[below_[i].speed] -= signed_by(below_[i], force[i]);
    motion k = motion_on_accelerated_ground(s_, acting);
    const sequence<expression> of_inertia = inertia_forces(s_, k);
    for (int i = 0; i < force.size(); ++i) force[i] += of_inertia[i];
    const symbolic::matrix mass = mass_matrix(s_);
    symbolic::symmetric_solution solved;
    if (by_articulated_bodies) {
      solved = articulated_bodies(s_).solve(force);
      for (symbolic::pivot& p : solved.pivots) p.entry = mass(p.place, p.place);
    } else {
      solved = symbolic::solve_symmetric(*m.g, mass, force);
    }
    const sequence<expression> rates = solved.x;
    for (int i = 0; i < below_.size(); ++i)
      if (below_[i].speed != none) solved.x[i] -= signed_by(below_[i], rates[below_[i].speed]);
    return solved;
  }

private:
  struct speed_below {
    int speed = none;
    bool is_opposite = false; ///< the axes point in opposite directions
  };

  static constexpr expression signed_by(const speed_below& b, expression e) { return b.is_opposite ? -e : e; }

  /// The only partial angular velocity of a frame, if no other motion has its speed; otherwise null.
  constexpr const partial_velocity* only_partial(int f, const sequence<int>& motions) const {
    const sequence<partial_velocity>& partials = s_.partial_angular_velocities[f];
    if (partials.size() != 1 || partials[0].speed >= below_.size()) return nullptr;
    const bool is_in_one_frame = motions[partials[0].speed] == 1 && partials[0].value.is_constant();
    return is_in_one_frame ? &partials[0] : nullptr;
  }

  /// Frames are visited from the ground outward.
  constexpr void measure_from_ground(int f, const sequence<int>& motions) {
    const int below = s_.turns_in[f];
    if (below == mechanism::inertial || s_.turns_in[below] != mechanism::inertial) return;
    const partial_velocity *const own = only_partial(f, motions), *const other = only_partial(below, motions);
    if (own == nullptr || other == nullptr) return;
    const components turned = express(*s_.model, other->value, s_.working_axes[below], s_.working_axes[f]);
    const components opposite = -turned;
    const bool is_opposite = are_equal(own->value, opposite);
    if (!is_opposite && !are_equal(own->value, turned)) return;
    below_[own->speed] = {other->speed, is_opposite};
    s_.turns_in[f] = mechanism::inertial;
    s_.relative_angular_velocity[f].add(s_.relative_angular_velocity[below]);
    any_ = true;
  }

  static constexpr bool are_equal(const components& a, const components& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }

  const skeleton& given_;
  skeleton s_;
  sequence<speed_below> below_; ///< by speed
  bool any_ = false;
};

} // namespace kanexpr::mechanics
