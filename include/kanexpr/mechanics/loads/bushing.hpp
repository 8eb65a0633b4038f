#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/motion/relative_motion.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>

namespace kanexpr::mechanics {

/// An elastic mount between two frames with a point each, stiff in six directions, those of the axes of the
/// base: the frame `against` with the point `base`.
///
/// The displacement d from the base has the energy ½ Σ kᵢ dᵢ². The rotation has the energy Σ κᵢ (1 − aᵢ·bᵢ)
/// with the axes aᵢ of the base, bᵢ of the other frame and κ₁ = (k₅ + k₆ − k₄)/2, …: a rotation by θ about
/// one axis has the torque k sin θ, and small rotations about all axes are independent of each other.
struct bushing {
  int frame = none;
  int against = none;
  int place = none;                            ///< the point that belongs to `frame`
  int base = none;                             ///< the point that belongs to `against`
  sequence<expression> stiffness{}, damping{}; ///< along x, y and z, then about x, y and z

  constexpr void act(force_system& on, conservative how) const {
    const mechanism& m = *on.skeleton_used().model;
    components force(*m.g), torque(*m.g);
    if (how == conservative::by_forces) add_elastic(m, force, torque);
    add_damping(on, force, torque);
    apply(on, force, torque);
  }

  constexpr expression potential_energy(const mechanism& m) const {
    const components d = displacement(m);
    expression energy = m.zero();
    for (int i = 0; i < 3; ++i) energy += stiffness[i] * (d[i] * d[i]) / 2;
    for (int i = 0; i < 3; ++i) {
      const components axis = axis_of_frame(m, i);
      energy += alignment(i) * (1 - axis[i]);
    }
    return energy;
  }

  constexpr void check_with(load_check& by, int) const {
    const mechanism& m = by.mechanism_used();
    if (frame == against) return by.fail({"a bushing acts between frame ", by.frame(frame), " and itself"});
    if (const sentence found = check_position(m, place, base)) return by.fail({found.view()});
    const sentence names = by.ends_of(*this);
    for (int i = 0; i < 6; ++i) {
      by.check_constant(stiffness[i], "a stiffness of the bushing between ", names.view());
      by.check_not_negative(stiffness[i], "a stiffness of the bushing between ", names.view());
      by.check_no_speed_rates(damping[i], "a damping of the bushing between ", names.view());
      by.check_not_negative(damping[i], "a damping of the bushing between ", names.view());
    }
  }

  constexpr void state_units(load_units& by, int) const {
    namespace si = units::si;
    const sentence names = by.ends_of(*this);
    for (int i = 0; i < 6; ++i) {
      const units::unit u = i < 3 ? si::newton / si::meter : si::newton * si::meter / si::radian;
      by.describe({"a stiffness of the bushing between ", names.view()});
      by.expect(stiffness[i], u);
      by.describe({"a damping of the bushing between ", names.view()});
      by.expect(damping[i], u * si::second);
    }
  }

private:
  /// The place relative to the base, in the axes of the base.
  constexpr components displacement(const mechanism& m) const {
    return express(m, position_from(m, base, place), against);
  }
  constexpr components axis_of_frame(const mechanism& m, int i) const {
    return express(m, unit(*m.g, i), frame, against);
  }
  constexpr expression alignment(int i) const {
    const expression others = stiffness[3 + (i + 1) % 3] + stiffness[3 + (i + 2) % 3];
    return (others - stiffness[3 + i]) / 2;
  }

  constexpr void add_elastic(const mechanism& m, components& force, components& torque) const {
    const components d = displacement(m);
    for (int i = 0; i < 3; ++i) force[i] -= stiffness[i] * d[i];
    for (int i = 0; i < 3; ++i) torque += alignment(i) * cross(axis_of_frame(m, i), unit(*m.g, i));
  }

  constexpr void add_damping(force_system& on, components& force, components& torque) const {
    bool is_damped = false;
    for (const expression& c : damping) is_damped = is_damped || !c.is_zero();
    if (!is_damped) return;
    const skeleton& s = on.skeleton_used();
    const mechanism& m = *s.model;
    motion& k = on.moving();
    components rate =
        express(m, velocity_between(k, s.station_of_point[place], s.station_of_point[base]), against);
    const components w =
        express(m, k.angular_velocity(against), s.working_axes[s.rigid_with[against]], against);
    rate -= cross(w, displacement(m));
    const components turning = express(m, angular_velocity_between(s, frame, against), against);
    for (int i = 0; i < 3; ++i) {
      const expression along = on.known(damping[i]), about = on.known(damping[3 + i]);
      force[i] -= along * rate[i];
      torque[i] -= about * turning[i];
    }
  }

  /// Applies a force at the place and the opposite force on the base at the same place, and a torque between
  /// the frames.
  constexpr void apply(force_system& on, const components& force, const components& torque) const {
    const mechanism& m = *on.skeleton_used().model;
    vector at_place, of_arm, between;
    at_place.add(against, force);
    of_arm.add(against, -cross(displacement(m), force));
    between.add(against, torque);
    on.add_force(place, at_place);
    on.add_force(base, -at_place);
    on.add_torque(against, none, of_arm);
    on.add_torque(frame, against, between);
  }
};

} // namespace kanexpr::mechanics
