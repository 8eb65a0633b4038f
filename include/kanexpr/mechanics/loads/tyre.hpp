#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/contact_law.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/one_sided.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/loads/tyre_law.hpp>
#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/mechanics/loads/wheel_contact.hpp>
#include <kanexpr/mechanics/loads/wheel_on_ground.hpp>
#include <kanexpr/mechanics/loads/wheel_shapes.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The lag of the slip behind that of the wheel, as two deflections d of the tyre with the relaxation lengths
/// σ. With the slip velocity V_s and the reference speed V of the law,
///
///     linear:  ḋ = −V_s − |V| d/σ,            slip = d/σ
///     others:  ḋ = −V_s − (|V| + |V_s|) d/σ,  slip = (d/σ)/(1 − |d/σ|)
///
/// In both cases, the slip of a steady motion is −V_s/|V|. The second form bounds the deflection by σ, also
/// if the wheel spins or slides sideways at standstill. At standstill, the tyre is a spring. Pacejka (2012),
/// sections 7.2.1 and 7.2.2; Canudas de Wit et al. (2003), doi 10.1076/vesd.39.3.189.14152.
struct tyre_relaxation {
  expression forward_length{}, lateral_length{}; ///< σ
  int forward = none, lateral = none;            ///< the deflections, as places among the speeds

  constexpr explicit operator bool() const { return forward != none; }
};

/// A wheel with a tyre on the ground.
struct tyre {
  wheel_on_ground wheel{};
  tyre_law law{};
  expression load{};             ///< F_z, if it is given; it then acts only through the law
  contact_law radial{};          ///< otherwise, the normal force as a function of the penetration
  expression standstill{};       ///< v₀, the forward speed below which slips are smoothed
  expression effective_radius{}; ///< of the free rolling wheel, if it is not the loaded radius
  tyre_relaxation relaxation{};

  constexpr bool is_radial() const { return radial.stiffness.is_given(); }

  constexpr void act(force_system& on, conservative how) const;

  /// The slip and the load on which the forces depend.
  constexpr tyre_slip slip(observed_motion& on) const;
  /// The forces and moments of the ground on the wheel.
  constexpr tyre_effort effort(observed_motion& on) const;

  /// Appends the rates of the deflections.
  constexpr void add_state_rates(force_system& on, sequence<state_rate>& all) const;

  /// Of the radial stiffness; zero on uneven ground, where its force is applied without an energy.
  constexpr expression potential_energy(const mechanism& m) const {
    return has_energy() ? radial.energy(wheel.contact(m).penetration) : m.zero();
  }

  constexpr void check_with(load_check& by, int) const;
  constexpr void state_units(load_units& by, int) const;

private:
  /// The slip of the law, the elastic part of the load, and the rates of the deflections.
  struct slipping {
    tyre_slip slip{};
    expression elastic{}, forward_rate{}, lateral_rate{};
  };

  constexpr bool has_energy() const { return is_radial() && wheel.ground != ground_shape::uneven; }

  template <class Motion>
  constexpr tyre_law known_law(Motion& on) const {
    tyre_law known = law;
    tyre_law::each_value(known,
                         [&](expression& e, std::string_view, const units::unit&) { e = on.known(e); });
    return known;
  }

  template <class Motion>
  constexpr slipping slip_at(Motion& on, const wheel_contact& at) const {
    const wheel_motion moves = wheel.motion_at(on.moving(), at);
    slipping s;
    s.slip.load = at.camber_sine.number({});
    if (load.is_given()) s.slip.load = on.known(load);
    if (is_radial()) {
      s.elastic = radial.elastic_force(at.penetration);
      s.slip.load = s.elastic * radial.dissipation(moves.approach);
    }
    expression x = moves.forward_slip;
    if (effective_radius.is_given()) x = moves.forward_speed - on.known(effective_radius) * moves.spin;
    const expression y = moves.lateral_slip, v = moves.forward_speed;
    const expression reference = law.is_by_rolling_speed() ? v - x : v;
    s.slip.camber = at.camber_sine, s.slip.velocity = v;
    s.slip.direction = v / speed_above(v, standstill);
    if (relaxation)
      relax(s, on, x, y, reference);
    else {
      const expression speed = speed_above(reference, standstill);
      s.slip.forward = -x / speed, s.slip.lateral = -y / speed;
    }
    return s;
  }

  template <class Motion>
  constexpr void relax(slipping& s, Motion& on, expression x, expression y, expression reference) const {
    const mechanism& m = *on.skeleton_used().model;
    const expression along = m.speeds[relaxation.forward] / on.known(relaxation.forward_length);
    const expression across = m.speeds[relaxation.lateral] / on.known(relaxation.lateral_length);
    expression passing = smooth_magnitude(reference * reference, standstill);
    s.slip.forward = along, s.slip.lateral = across;
    if (law.model != tyre_model::linear) {
      passing += smooth_magnitude(symbolic::sum_of_products(x, x, y, y), standstill);
      const expression squared = symbolic::sum_of_products(along, along, across, across);
      const expression width = squared.number(symbolic::real(1e-4));
      const expression rest = 1 - smooth_magnitude(squared, width);
      const expression narrow = rest.number(symbolic::exactly(1, 20));
      const expression floor = narrow / 2, above = one_sided(rest, narrow) + floor; // at least 1/40
      s.slip.forward = along / above, s.slip.lateral = across / above;
    }
    const expression forward_decay = passing * along, lateral_decay = passing * across;
    s.forward_rate = -x - forward_decay, s.lateral_rate = -y - lateral_decay;
  }
};

// Below the templates that they use: clang++ would otherwise form these too late for constant expressions.

constexpr void tyre::act(force_system& on, conservative how) const {
  const mechanism& m = *on.skeleton_used().model;
  const wheel_contact at = wheel.contact(m);
  const slipping s = slip_at(on, at);
  const tyre_effort f = known_law(on).at(s.slip);
  components force = f.forward * at.forward, torque = f.aligning * at.normal;
  force += f.lateral * at.lateral;
  if (is_radial()) {
    const bool is_in_energy = how == conservative::by_energy && has_energy();
    force += (is_in_energy ? s.slip.load - s.elastic : s.slip.load) * at.normal;
  }
  torque += f.overturning * at.forward;
  torque += f.rolling * at.lateral;
  if (effective_radius.is_given()) {
    const expression arm = on.known(effective_radius) - at.loaded_radius;
    torque -= (f.forward * arm) * at.axis;
  }
  wheel.add_force(on, at, force);
  if (!torque.is_zero()) wheel.add_torque(on, torque);
  if (!relaxation) return;
  on.add_share(relaxation.forward, s.forward_rate);
  on.add_share(relaxation.lateral, s.lateral_rate);
}

constexpr tyre_slip tyre::slip(observed_motion& on) const {
  return slip_at(on, wheel.contact(*on.skeleton_used().model)).slip;
}

constexpr tyre_effort tyre::effort(observed_motion& on) const { return known_law(on).at(slip(on)); }

constexpr void tyre::add_state_rates(force_system& on, sequence<state_rate>& all) const {
  if (!relaxation) return;
  const slipping s = slip_at(on, wheel.contact(*on.skeleton_used().model));
  all.push({relaxation.forward, s.forward_rate, {}});
  all.push({relaxation.lateral, s.lateral_rate, {}});
}

constexpr void tyre::check_with(load_check& by, int) const {
  wheel.check_with(by, "the tyre");
  const sentence names({"the tyre between ", by.ends_of(wheel).view()});
  const auto part = [&](expression e, std::string_view what) {
    if (e.is_given()) by.check_no_speed_rates(e, what, names.view());
  };
  const auto constant = [&](expression e, std::string_view what) {
    if (!e.is_given()) return;
    by.check_constant(e, what, names.view());
    by.check_positive(e, what, names.view());
  };
  tyre_law::each_value(law, [&](expression e, std::string_view what, const units::unit&) { part(e, what); });
  part(load, "the load of ");
  part(effective_radius, "the effective radius of ");
  constant(radial.stiffness, "the radial stiffness of ");
  constant(radial.width, "the width of ");
  const auto not_negative = [&](expression e, std::string_view what) {
    if (e.is_given()) by.check_not_negative(e, what, names.view());
  };
  if (radial.damping.is_given()) by.check_constant(radial.damping, "the radial damping of ", names.view());
  not_negative(radial.damping, "the radial damping of ");
  not_negative(load, "the load of ");
  tyre_law::each_bound(law, not_negative, [&](expression e, std::string_view what) {
    by.check_positive(e, what, names.view());
  });
  if (effective_radius.is_given())
    by.check_positive(effective_radius, "the effective radius of ", names.view());
  constant(standstill, "the speed of standstill of ");
  constant(relaxation.forward_length, "a relaxation length of ");
  constant(relaxation.lateral_length, "a relaxation length of ");
}

constexpr void tyre::state_units(load_units& by, int) const {
  namespace si = units::si;
  wheel.state_units(by, "the tyre");
  const sentence names({"the tyre between ", by.ends_of(wheel).view()});
  const auto state = [&](expression e, std::string_view what, const units::unit& u) {
    if (!e.is_given()) return;
    by.describe({what, names.view()});
    by.expect(e, u);
  };
  tyre_law::each_value(law, state);
  state(load, "the load of ", si::newton);
  state(effective_radius, "the effective radius of ", si::meter);
  state(radial.stiffness, "the radial stiffness of ", si::newton / si::meter);
  state(radial.width, "the width of ", si::meter);
  state(radial.damping, "the radial damping of ", si::second / si::meter);
  state(standstill, "the speed of standstill of ", si::meter / si::second);
  state(relaxation.forward_length, "a relaxation length of ", si::meter);
  state(relaxation.lateral_length, "a relaxation length of ", si::meter);
  if (!relaxation) return;
  const mechanism& m = by.mechanism_used();
  state(m.speeds[relaxation.forward], "a deflection of ", si::meter);
  state(m.speeds[relaxation.lateral], "a deflection of ", si::meter);
}

} // namespace kanexpr::mechanics
