#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/mechanics/loads/add_bristles.hpp>
#include <kanexpr/mechanics/loads/add_path_load.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads a law of friction. `default_slip_speed` is used if the law omits it; if it is not given either, that
/// is a mistake. The state variables of the load are those of bristles.
constexpr mechanics::friction_law read_friction_law(load_parts& by, const describe::friction_record& r,
                                                    expression default_slip_speed) {
  const auto part = [&](const phrase& p, std::string_view what) {
    return p.tokens == nullptr ? expression{} : by.scalar(p, what);
  };
  mechanics::friction_law law{r.kind,
                              part(r.sliding, "the coefficient of friction of "),
                              part(r.sticking, "the coefficient of static friction of "),
                              part(r.slip_speed, "the slip speed of "),
                              part(r.viscous, "the viscous coefficient of "),
                              {part(r.stiffness, "the stiffness of the bristles of "),
                               part(r.damping, "the damping of the bristles of "),
                               part(r.stribeck_speed, "the Stribeck speed of "),
                               {}}};
  if (by.has_mistake()) return law;
  for (const phrase& z : by.record.states) law.bristles.deflections.push(by.scalar(z, ""));
  law.take_slip_speed(default_slip_speed);
  if (law.needs_slip_speed())
    by.fail({by.whom, " has ", law.has_bristles() ? "dahl" : "coulomb",
             "_friction<...> without a slip speed; only a contact with restitution<...> has a default"});
  return law;
}

/// Reads friction in joints and along pathways.
class friction_reader {
public:
  constexpr explicit friction_reader(load_parts& by) : by_(by), r_(by.record) {}

  constexpr void read() {
    const expression normal = by_.scalar(r_.rest, "the normal force of ");
    if (by_.has_mistake()) return;
    const mechanics::friction_law law = read_friction_law(by_, *r_.friction, {});
    if (r_.path == nullptr) return read_in_joint(normal, law);
    const mechanics::pathway along = by_.path();
    if (by_.has_mistake()) return;
    mechanics::add_friction_along(by_.into, along, normal, law);
    mechanics::add_bristles(by_.model(), by_.into, law);
  }

private:
  constexpr void read_in_joint(expression normal, const mechanics::friction_law& law) {
    const mechanics::vector axis = by_.vector(r_.value, "the axis of ");
    const expression slip = by_.scalar(r_.angle, "the speed of ");
    if (by_.has_mistake()) return;
    check_values(normal, law);
    if (by_.has_mistake()) return;
    if (by_.state().for_units) return expect_units(normal, law);
    by_.state().hides_units = true; // a slip speed may be a number
    const mechanics::vector effort = -(normal * law.coefficient(slip)) * axis;
    if (r_.frame != nullptr) {
      const auto [on, other] = by_.frames();
      if (!by_.has_mistake()) by_.into.torques.push({on, effort, other});
    } else {
      const auto [at, other] = by_.points();
      if (!by_.has_mistake()) by_.into.forces.push({at, effort, other});
    }
  }

  constexpr void check_values(expression normal, const mechanics::friction_law& law) {
    const mechanics::contents held(*by_.model().g);
    mechanics::load_check by(by_.model(), held);
    by.check_not_negative(normal, "the normal force of ", by_.whom);
    law.check_with(by, by_.whom);
    by_.state().mistake = by.mistake();
  }

  /// States the units of the friction in a joint, whose slip speed may be a number.
  constexpr void expect_units(expression normal, const mechanics::friction_law& law) {
    namespace si = units::si;
    const bool turns = r_.frame != nullptr;
    const units::unit effort = turns ? si::newton * si::meter : si::newton;
    const units::unit speed = (turns ? si::radian : si::meter) / si::second;
    const sentence bodies = turns ? sentence({r_.frame->called, " and ", r_.other_frame->called})
                                  : sentence({r_.point->called, " and ", r_.other_point->called});
    const auto state = [&](expression e, std::string_view what, const units::unit& u) {
      by_.model().expected_units.push({e, u, base::name(what), base::name(bodies.view())});
    };
    if (law.slip_speed.is_given()) state(law.slip_speed, "the slip speed of the friction between ", speed);
    if (law.sliding.is_given()) state(normal * law.sliding, "the dry part of the friction between ", effort);
    if (law.sticking.is_given())
      state(normal * law.sticking, "the static part of the friction between ", effort);
    if (law.viscous.is_given() && !law.viscous.is_constant()) // a number is in SI units
      state(normal * law.viscous, "the viscous part of the friction between ", effort / speed);
  }

  load_parts& by_;
  const load_record& r_;
};

constexpr void read_friction(load_parts& by) { friction_reader(by).read(); }

} // namespace kanexpr::derivation
