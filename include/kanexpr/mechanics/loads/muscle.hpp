#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/muscle_parameters.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/numeric/muscle_curves.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The relative velocity v of a fiber in equilibrium with its load, a f_v(v) + β v = F, for the active force
/// `a` at rest, the damping β and the load F without the passive force.
///
/// With w = arsinh(d₂ v + d₃) this is p w + r sinh w = s for p = a d₁ and r = β/d₂, which has one root. Three
/// steps of Householder's method of fourth order from the smaller of two bounds, s/(p + r) and arsinh(s/r),
/// reach it to 1e-16 for every p/r and |w| < 14, which is beyond 10⁴ times the maximal velocity.
constexpr expression fiber_velocity(expression active, expression damping, expression load) {
  namespace curves = numeric::muscle_curves;
  if (damping.is_zero()) return curves::velocity_with_force(load / active);
  const expression p = curves::velocity_scale * active, r = damping / curves::velocity_factor;
  const expression s = load - curves::velocity_offset * active + curves::velocity_shift * r;
  const expression ratio = abs(s) / (r + 1e-8 * p), least = s / (p + r);
  const expression bound = log(ratio + sqrt(ratio * ratio + 1.0));
  expression w = symbolic::if_positive(abs(least) - bound, sign(s) * bound, least);
  for (int step = 0; step < 3; ++step) {
    const expression third = r * cosh(w), second = r * sinh(w), slope = p + third;
    const expression excess = p * w + second - s;
    const expression d = excess / slope, bend = second / slope * d, turn = third / slope * (d * d);
    w -= d * (1.0 - bend / 2) / (1.0 - bend + turn / 6);
  }
  return (sinh(w) - curves::velocity_shift) / curves::velocity_factor;
}

/// A muscle with its tendon along a pathway, after De Groote et al. (2016): its fibers, which enclose the
/// pennation angle with the line of the tendon and keep their width, have the force a f_a(l) f_v(v) + f_p(l)
/// + β v, and the tendon in series carries the part of it along the pathway.
struct muscle {
  base::name called{};
  pathway along{};
  expression activation{};
  expression peak_force{}, optimal_length{}, slack_length{}, maximal_velocity{}, pennation{}, damping{},
      tendon_strain{}, passive_strain{};
  muscle_formulation formulation{};
  expression tendon_state{}; ///< the state variable; not given with a rigid tendon

  constexpr void act(force_system& on, conservative) const {
    const taut_pathway taut(along, on.skeleton_used());
    const contraction now = contract(on.moving(), taut, on.known(activation));
    taut.pull(on, peak_force * now.tendon_force);
    if (tendon_state.is_given()) on.add_share(on.skeleton_used().model->speeds.find(tendon_state), now.rate);
  }

  /// The force of the tendon, positive if it shortens the pathway.
  constexpr expression tension(observed_motion& on) const {
    const taut_pathway taut(along, on.skeleton_used());
    return peak_force * contract(on.moving(), taut, activation).tendon_force;
  }

  /// Appends the rate of the state variable.
  constexpr void add_state_rates(force_system& on, sequence<state_rate>& all) const {
    if (!tendon_state.is_given()) return;
    const taut_pathway taut(along, on.skeleton_used());
    const int place = on.skeleton_used().model->speeds.find(tendon_state);
    all.push({place, contract(on.moving(), taut, activation).rate, {}});
  }

  constexpr void check_with(load_check& by, int) const {
    const sentence named({"muscle ", called.view()}), whose({"the ", named.view()});
    if (const sentence found = along.find_mistake(by.mechanism_used(), named.view()))
      return by.fail({found.view()});
    along.check_with(by, named.view());
    by.check_no_speed_rates(activation, "the activation of ", whose.view());
    const auto examine = [&](expression e, std::string_view of, bool is_positive) {
      by.check_constant(e, of, whose.view());
      if (is_positive) by.check_positive(e, of, whose.view());
    };
    examine(peak_force, "the peak isometric force of ", true);
    examine(optimal_length, "the optimal fiber length of ", true);
    examine(slack_length, "the tendon slack length of ", true);
    examine(maximal_velocity, "the maximal fiber velocity of ", true);
    examine(pennation, "the pennation of ", false);
    by.check_not_negative(pennation, "the pennation of ", whose.view());
    if (pennation.is_constant() && pennation.owner().number_at(pennation.node()).value() >= 1.570796326794896)
      by.fail({"the pennation of ", whose.view(), " is not less than a right angle"});
    examine(damping, "the fiber damping of ", false);
    by.check_not_negative(damping, "the fiber damping of ", whose.view());
    examine(tendon_strain, "the tendon strain of ", true);
    examine(passive_strain, "the passive strain of ", true);
  }

  constexpr void state_units(load_units& by, int) const {
    namespace si = units::si;
    const sentence named({"muscle ", called.view()}), whose({"the ", named.view()});
    along.state_units(by, named.view());
    const auto expect = [&](expression e, std::string_view of, const units::unit& u) {
      by.describe({of, whose.view()});
      by.expect(e, u);
    };
    if (along.form == pathway_form::given_length) expect(along.length, "the length of ", si::meter);
    expect(activation, "the activation of ", units::dimensionless);
    expect(peak_force, "the peak isometric force of ", si::newton);
    expect(optimal_length, "the optimal fiber length of ", si::meter);
    expect(slack_length, "the tendon slack length of ", si::meter);
    expect(maximal_velocity, "the maximal fiber velocity of ", si::hertz);
    expect(pennation, "the pennation of ", si::radian);
    expect(damping, "the fiber damping of ", units::dimensionless);
    expect(tendon_strain, "the tendon strain of ", units::dimensionless);
    expect(passive_strain, "the passive strain of ", units::dimensionless);
    if (tendon_state.is_given())
      expect(tendon_state, "the state variable of the tendon of ", units::dimensionless);
  }

private:
  /// The relative force of the tendon and the rate of its state variable.
  struct contraction {
    expression tendon_force{}, rate{};
  };
  /// The fibers: their relative length and the cosine of their angle with the tendon.
  struct fibers {
    expression length{}, cosine{};
  };
  /// The relative forces of the fibers: active at rest, and passive.
  struct fiber_forces {
    expression active{}, passive{};
  };

  constexpr contraction contract(motion& k, const taut_pathway& taut, expression activated) const {
    const expression length = taut.length();
    switch (formulation) {
    case muscle_formulation::rigid_tendon: return {with_rigid_tendon(length, taut.rate(k), activated), {}};
    case muscle_formulation::tendon_force: return by_tendon_force(length, taut.rate(k), activated);
    case muscle_formulation::fiber_length: return by_fiber_length(length, activated);
    }
    return {};
  }

  constexpr expression with_rigid_tendon(expression length, expression rate, expression activated) const {
    namespace curves = numeric::muscle_curves;
    const fibers f = fibers_along(length - slack_length);
    const fiber_forces forces = forces_of(f, activated);
    const expression greatest = maximal_velocity * optimal_length, velocity = rate * f.cosine / greatest;
    const expression active = forces.active * curves::velocity_force(velocity);
    return (active + forces.passive + damping * velocity) * f.cosine;
  }

  constexpr contraction by_tendon_force(expression length, expression rate, expression activated) const {
    namespace curves = numeric::muscle_curves;
    const expression force = tendon_state;
    const expression tendon = slack_length * curves::tendon_length(force, tendon_strain);
    const fibers f = fibers_along(length - tendon);
    const expression greatest = maximal_velocity * optimal_length;
    const expression fiber_rate = greatest * velocity_under(force, f, activated) / f.cosine;
    const expression stretching = (rate - fiber_rate) / slack_length;
    return {force, curves::tendon_factor(tendon_strain) * (force + 0.25) * stretching};
  }

  constexpr contraction by_fiber_length(expression length, expression activated) const {
    namespace curves = numeric::muscle_curves;
    const expression fiber_length = tendon_state * optimal_length;
    expression projected = fiber_length;
    fibers f{tendon_state, tendon_state.number(symbolic::exactly(1))};
    if (!pennation.is_zero()) {
      const expression width = optimal_length * sin(pennation);
      projected = sqrt(difference_of_products(fiber_length, fiber_length, width, width));
      f.cosine = projected / fiber_length;
    }
    const expression force = curves::tendon_force((length - projected) / slack_length, tendon_strain);
    return {force, maximal_velocity * velocity_under(force, f, activated)};
  }

  /// The fibers whose projection on the line of the tendon has a given length; their width is constant.
  constexpr fibers fibers_along(expression projected) const {
    if (pennation.is_zero()) return {projected / optimal_length, projected.number(symbolic::exactly(1))};
    const expression width = optimal_length * sin(pennation);
    const expression length = sqrt(sum_of_products(projected, projected, width, width));
    return {length / optimal_length, projected / length};
  }

  constexpr fiber_forces forces_of(const fibers& f, expression activated) const {
    namespace curves = numeric::muscle_curves;
    const expression active = activated * curves::active_force(f.length);
    return {active, curves::passive_force(f.length, passive_strain)};
  }

  /// The relative velocity at which the fibers balance a relative force of the tendon.
  constexpr expression velocity_under(expression tendon_force, const fibers& f, expression activated) const {
    const fiber_forces forces = forces_of(f, activated);
    return fiber_velocity(forces.active, damping, tendon_force / f.cosine - forces.passive);
  }
};

} // namespace kanexpr::mechanics
