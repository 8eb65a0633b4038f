#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// How loads with a potential energy are applied.
enum class conservative : unsigned char {
  by_forces,
  by_energy, ///< their energy is part of a Lagrangian; only the part without an energy is applied as a force
};

/// Σ_s Q_s ∂q̇_s/∂u_r for every speed, where Q_s is the generalized force that belongs to the rate of
/// coordinate q_s.
constexpr sequence<expression> forces_on_speeds(const skeleton& s, const sequence<expression>& on_rates) {
  const mechanism& m = *s.model;
  symbolic::accumulation by_speeds(*m.g, s.coordinate_rates);
  for (int q = 0; q < m.coordinates.size(); ++q) by_speeds.seed(s.coordinate_rates[q], on_rates[q]);
  by_speeds.run();
  sequence<expression> forces;
  for (const expression& u : m.speeds) forces.push(by_speeds.by(u));
  return forces;
}

/// ∂V̇/∂u_r for every speed, where V is the sum of the potential energies of the model: Σ_s ∂V/∂q_s
/// ∂q̇_s/∂u_r with the rates q̇ of the kinematic equations. The generalized active force is −∂V̇/∂u_r. Kane &
/// Levinson (1985), section 5.1.
constexpr sequence<expression> potential_rates(const skeleton& s, const sequence<expression>& energies) {
  const mechanism& m = *s.model;
  symbolic::accumulation by_coordinates(*m.g, energies);
  for (const expression& energy : energies) by_coordinates.seed(energy, m.one());
  by_coordinates.run();
  sequence<expression> gradient;
  for (const expression& q : m.coordinates) gradient.push(by_coordinates.by(q));
  return forces_on_speeds(s, gradient);
}

/// Accumulates the effects of loads: forces at the nodes of a skeleton, moments on its frames, and
/// generalized forces for individual speeds.
class force_system {
public:
  constexpr explicit force_system(const skeleton& s)
      : s_(s), m_(*s.model), known_(m_, s.coordinate_rates), drop_(m_),
        force_(s.stations.size(), components(*m_.g)), moment_(m_.frames.size(), components(*m_.g)),
        share_(m_.ways(), expression{*m_.g, graph::zero}) {}

  constexpr const skeleton& skeleton_used() const { return s_; }

  /// Registers a symbol that `known` replaces; called before any load acts.
  constexpr void replace(expression symbol, expression by) { known_.replace(symbol, by); }

  /// Substitutes the rates of the kinematic equations and of state variables, and removes auxiliary speeds.
  constexpr expression known(expression e) { return drop_.in(known_.in(e)); }
  constexpr vector known(const vector& v) { return drop_.in(known_.in(v)); }

  /// The motion at u̇ = 0.
  constexpr motion& moving() {
    if (!has_motion_) motion_ = motion(s_);
    has_motion_ = true;
    return motion_;
  }

  /// Adds a force at a point.
  constexpr void add_force(int point, const vector& value) {
    const int n = s_.station_of_point[point];
    force_[n] += express(m_, value, s_.working_axes[s_.stations[n].axes]);
  }

  /// Adds a torque on a frame and the opposite torque on another. Between adjacent frames it contributes only
  /// to the speeds of their relative rotation.
  constexpr void add_torque(int frame, int against, const vector& value) {
    const int f = s_.rigid_with[frame], b = against == none ? mechanism::inertial : s_.rigid_with[against];
    if (b != mechanism::inertial && s_.turns_in[f] == b) return add_relative_torque(f, value);
    if (f != mechanism::inertial && s_.turns_in[b] == f) return add_relative_torque(b, -value);
    add_moment(f, value);
    if (b != mechanism::inertial) add_moment(b, -value);
  }

  /// Adds generalized forces that belong to the rates of the coordinates, one for each coordinate.
  constexpr void add_coordinate_forces(const sequence<expression>& forces) {
    const sequence<expression> on_speeds = forces_on_speeds(s_, forces);
    for (int r = 0; r < on_speeds.size(); ++r) share_[r] += on_speeds[r];
  }

  /// Adds a generalized force of one speed.
  constexpr void add_share(int speed, expression force) { share_[speed] += force; }

  /// Adds a potential energy.
  constexpr void add_potential_energy(expression energy) { energies_.push(energy); }

  /// Adds the generalized forces of the potential energies; called after all loads have been added.
  constexpr void differentiate_energies() {
    if (energies_.empty()) return;
    const sequence<expression> rates = potential_rates(s_, energies_);
    for (int r = 0; r < rates.size(); ++r) share_[r] -= rates[r];
  }

  /// The force at each node, in the axes of its motion.
  constexpr sequence<components>& forces() { return force_; }
  /// The moment on each frame, in its working axes.
  constexpr sequence<components>& moments() { return moment_; }
  /// The generalized forces added directly to each speed.
  constexpr sequence<expression>& shares() { return share_; }

private:
  /// Adds a torque between a frame and the frame in which it rotates.
  constexpr void add_relative_torque(int f, const vector& value) {
    for (const partial_velocity& w : s_.partial_angular_velocities[f])
      share_[w.speed] += dot(w.value, express(m_, value, s_.working_axes[f]));
  }

  constexpr void add_moment(int f, const vector& value) {
    if (f != mechanism::inertial) moment_[f] += express(m_, value, s_.working_axes[f]);
  }

  const skeleton& s_;
  const mechanism& m_;
  known_rates known_;
  without_auxiliary_speeds drop_;
  motion motion_{};
  bool has_motion_ = false;
  sequence<components> force_;
  sequence<components> moment_;
  sequence<expression> share_;
  sequence<expression> energies_{};
};

} // namespace kanexpr::mechanics
