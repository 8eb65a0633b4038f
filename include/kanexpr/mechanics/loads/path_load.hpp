#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/one_sided.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/possible_unit.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The law of the tension T in a pathway of length l.
enum class tension_law : unsigned char {
  given,    ///< T = terms[0]
  spring,   ///< T = k x + k₃ x³ with x = l − l₀; terms k, k₃, l₀
  damper,   ///< T = c dl/dt; terms[0] is c
  friction, ///< T = N μ(dl/dt) with the coefficient of a law of friction; terms[0] is N
  stop,     ///< no tension from a least to a greatest length; terms least, greatest, k, c, width
};

/// A load along a pathway. A positive tension shortens the pathway.
struct path_load {
  pathway along{};
  tension_law law{};
  sequence<expression> terms{};
  friction_law friction{};

private:
  template <class Motion>
  constexpr expression tension_of_stop(Motion& on, const taut_pathway& taut, conservative how) const {
    const expression at_most = one_sided(taut.length() - terms[1], terms[4]),
                     at_least = one_sided(terms[0] - taut.length(), terms[4]);
    if (terms[3].is_zero())
      return how == conservative::by_energy ? on.skeleton_used().model->zero()
                                            : terms[2] * (at_most - at_least);
    motion& k = on.moving();
    const expression damping = on.known(terms[3]), rate = taut.rate(k);
    const expression of_greatest = k.rate(terms[1]), of_least = k.rate(terms[0]);
    expression longer = dissipation_factor(damping, rate - of_greatest),
               shorter = dissipation_factor(damping, of_least - rate);
    if (how == conservative::by_energy) longer = longer - 1, shorter = shorter - 1;
    const expression pulls = at_most * longer, pushes = at_least * shorter;
    return terms[2] * (pulls - pushes);
  }

  template <class Motion>
  constexpr moving_bristles move_bristles(Motion& on, const taut_pathway& taut) const {
    return friction.known_in(on).move_bristles(on.known(terms[0]), {taut.rate(on.moving())});
  }

  template <class Motion>
  constexpr expression tension(Motion& on, const taut_pathway& taut, conservative how) const {
    switch (law) {
    case tension_law::given: return on.known(terms[0]);
    case tension_law::spring: {
      const expression x = taut.length() - terms[2], linear = terms[0] * x;
      return linear + terms[1] * (x * x * x);
    }
    case tension_law::damper: {
      const expression damping = on.known(terms[0]);
      return damping * taut.rate(on.moving());
    }
    case tension_law::friction: {
      if (friction.has_bristles()) return -move_bristles(on, taut).force[0];
      const expression normal = on.known(terms[0]);
      return normal * friction.known_in(on).coefficient(taut.rate(on.moving()));
    }
    case tension_law::stop: return tension_of_stop(on, taut, how);
    }
    return {};
  }

public:
  constexpr void act(force_system& on, conservative how) const {
    if (how == conservative::by_energy && law == tension_law::spring) return;
    const taut_pathway taut(along, on.skeleton_used());
    if (!friction.has_bristles()) return taut.pull(on, tension(on, taut, how));
    const moving_bristles moving = move_bristles(on, taut);
    taut.pull(on, -moving.force[0]);
    on.add_share(place_of_bristle(*on.skeleton_used().model), moving.rates[0]);
  }

  /// Appends the rate of the deflection of bristles.
  constexpr void add_state_rates(force_system& on, sequence<state_rate>& all) const {
    if (!friction.has_bristles()) return;
    const moving_bristles moving = move_bristles(on, taut_pathway(along, on.skeleton_used()));
    all.push({place_of_bristle(*on.skeleton_used().model), moving.rates[0], {}});
  }

  /// The tension, positive if it shortens the pathway.
  constexpr expression tension(observed_motion& on) const {
    return tension(on, taut_pathway(along, on.skeleton_used()), conservative::by_forces);
  }

  constexpr expression potential_energy(const mechanism& m) const {
    if (law == tension_law::spring) return energy_of_spring(along.length_in(m));
    if (law == tension_law::stop) return energy_of_stop(along.length_in(m));
    return m.zero();
  }

  constexpr std::string_view called() const {
    switch (law) {
    case tension_law::given: return "force";
    case tension_law::spring: return terms[1].is_zero() ? "linear spring" : "cubic spring";
    case tension_law::damper: return "linear damper";
    case tension_law::friction: return "friction";
    case tension_law::stop: return "stop";
    }
    return {};
  }

  constexpr void check_with(load_check& by, int) const {
    const sentence place = along.place(by), whose({called(), " ", place.view()});
    along.check_with(by, whose.view());
    if (const sentence found = along.find_mistake(by.mechanism_used(), called()))
      return by.fail({found.view()});
    if (along.is_constant(by.mechanism_used()))
      return by.fail({"the length of the ", whose.view(), " is the same in every configuration"});
    const bool has_rate = law == tension_law::damper || law == tension_law::friction ||
                          (law == tension_law::stop && !terms[3].is_zero());
    if (along.form == pathway_form::given_length && has_rate)
      by.check_prescribed(along.length, "the length of the ", whose.view());
    switch (law) {
    case tension_law::given: return by.check_no_speed_rates(terms[0], "the ", whose.view());
    case tension_law::damper: return by.check_no_speed_rates(terms[0], "the damping of the ", whose.view());
    case tension_law::friction:
      by.check_no_speed_rates(terms[0], "the normal force of the ", whose.view());
      by.check_not_negative(terms[0], "the normal force of the ", whose.view());
      return friction.check_with(by, sentence({"the ", whose.view()}).view());
    case tension_law::spring:
      by.check_constant(terms[0], "the stiffness of the ", whose.view());
      by.check_constant(terms[1], "the cubic stiffness of the ", whose.view());
      return by.check_constant(terms[2], "the natural length of the ", whose.view());
    case tension_law::stop: return check_stop(by, whose.view());
    }
  }

  constexpr void state_units(load_units& by, int) const {
    namespace si = units::si;
    units::unit length = si::meter, force = si::newton;
    const sentence place = along.place(by), whose({called(), " ", place.view()});
    if (along.form == pathway_form::given_length) {
      by.describe({"the length of the ", whose.view()});
      const units::possible_unit found = by.unit_of(along.length);
      if (!found) return;
      length = *found;
      force = length == si::radian ? si::newton * si::meter : si::joule / length;
    }
    along.state_units(by, whose.view());
    const auto expect = [&](int term, std::string_view what, const units::unit& u) {
      by.describe({what, whose.view()});
      by.expect(terms[term], u);
    };
    switch (law) {
    case tension_law::given: return expect(0, "the ", force);
    case tension_law::spring:
      expect(0, "the stiffness of the ", force / length);
      expect(1, "the cubic stiffness of the ", force / units::pow<3>(length));
      return expect(2, "the natural length of the ", length);
    case tension_law::damper: return expect(0, "the damping of the ", force * si::second / length);
    case tension_law::friction:
      if (friction.has_bristles()) state_units_of_bristles(by, whose.view(), force, length);
      return state_units_of_friction(by, whose.view(), force, length / si::second);
    case tension_law::stop:
      expect(0, "the least length of the ", length);
      expect(1, "the greatest length of the ", length);
      expect(2, "the stiffness of the ", force / length);
      expect(3, "the damping of the ", si::second / length);
      return expect(4, "the width of the ", length);
    }
  }

private:
  constexpr int place_of_bristle(const mechanism& m) const {
    return m.speeds.find(friction.bristles.deflections[0]);
  }

  /// States the unit of a value that the normal force multiplies. A number is in SI units.
  constexpr void state_unit_by_load(load_units& by, std::string_view what, std::string_view whose,
                                    expression value, const units::unit& of_product) const {
    if (!value.is_given()) return;
    by.describe({"the normal force of the ", whose});
    const units::possible_unit normal = by.unit_of(terms[0]);
    by.describe({what, whose});
    if (normal)
      by.expect(value, of_product / *normal);
    else if (!value.is_constant())
      by.expect(terms[0] * value, of_product);
  }

  constexpr void state_units_of_bristles(load_units& by, std::string_view whose, const units::unit& force,
                                         const units::unit& length) const {
    namespace si = units::si;
    const bristles& b = friction.bristles;
    state_unit_by_load(by, "the stiffness of the bristles of the ", whose, b.stiffness, force / length);
    state_unit_by_load(by, "the damping of the bristles of the ", whose, b.damping,
                       force * si::second / length);
    by.describe({"the Stribeck speed of the ", whose});
    if (b.stribeck_speed.is_given()) by.expect(b.stribeck_speed, length / si::second);
    by.describe({"the normal force of the ", whose});
    const units::possible_unit normal = by.unit_of(terms[0]);
    by.describe({"the deflection of the ", whose});
    if (bristles::are_deflections(terms[0]))
      by.expect(b.deflections[0], length);
    else if (normal)
      by.expect(b.deflections[0], length * units::pow<1, 2>(*normal));
  }

  constexpr void state_units_of_friction(load_units& by, std::string_view whose, const units::unit& force,
                                         const units::unit& speed) const {
    state_unit_by_load(by, "the coefficient of friction of the ", whose, friction.sliding, force);
    state_unit_by_load(by, "the coefficient of static friction of the ", whose, friction.sticking, force);
    state_unit_by_load(by, "the viscous coefficient of the ", whose, friction.viscous, force / speed);
    by.describe({"the slip speed of the ", whose});
    if (friction.slip_speed.is_given()) by.expect(friction.slip_speed, speed);
  }

  constexpr expression energy_of_spring(expression length) const {
    const expression x = length - terms[2], square = x * x;
    const expression linear = terms[0] * square / 2;
    return linear + terms[1] * (square * square) / 4;
  }
  constexpr expression energy_of_stop(expression length) const {
    const expression at_most = one_sided_energy(length - terms[1], terms[4]),
                     at_least = one_sided_energy(terms[0] - length, terms[4]);
    return terms[2] * (at_most + at_least);
  }

  constexpr void check_stop(load_check& by, std::string_view whose) const {
    by.check_constant(terms[0], "the least length of the ", whose);
    by.check_constant(terms[1], "the greatest length of the ", whose);
    by.check_constant(terms[2], "the stiffness of the ", whose);
    by.check_no_speed_rates(terms[3], "the damping of the ", whose);
    by.check_constant(terms[4], "the width of the ", whose);
    if (!terms[3].is_zero()) {
      by.check_prescribed(terms[0], "the least length of the ", whose);
      by.check_prescribed(terms[1], "the greatest length of the ", whose);
    }
    const expression range = terms[1] - terms[0];
    if (range.is_constant() && !(range.owner().number_at(range.node()).value() > 0))
      by.fail({"the greatest length of the ", whose, " does not exceed the least length"});
    by.check_positive(range, "the distance between the ends of the ", whose);
    by.check_positive(terms[2], "the stiffness of the ", whose);
    by.check_positive(terms[4], "the width of the ", whose);
    by.check_not_negative(terms[3], "the damping of the ", whose);
  }
};

/// The default width over which a stop is rounded: a thousandth of the distance between its ends.
constexpr expression default_width_of_stop(expression least, expression greatest) {
  return (greatest - least) / 1000;
}

} // namespace kanexpr::mechanics
