#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/contact_reader.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/muscle_reader.hpp>
#include <kanexpr/derivation/read/observed_quantity.hpp>
#include <kanexpr/derivation/read/path_reader.hpp>
#include <kanexpr/derivation/read/tyre_reader.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/loads/add_path_load.hpp>
#include <kanexpr/mechanics/loads/bushing.hpp>
#include <kanexpr/mechanics/loads/friction_law.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the loads of a model. The symbols and entities of loads that depend on motion are read like all
/// others; these loads are evaluated once velocities are known.
class load_reader : part_reader {
public:
  using part_reader::part_reader;

  /// Reads the loads that depend on motion; returns whether there are any. Requires that `set_known_motion`
  /// was called.
  constexpr bool read_moving_loads() {
    bool any = false;
    for (const load_record& r : reading_.from.loads) {
      if (reading_.mistake || !moves(r)) continue;
      any = true;
      evaluate_load(r);
    }
    return any;
  }

  constexpr void read_load(const load_record& r) {
    if (!reading_.check_base_conflict(r.conflict, r.called)) return;
    if (!r.fits) return reading_.fail_by_argument_count("", name_of(r).view(), r.fits);
    if (r.path != nullptr && !path_reader(*this).is_pathway(*r.path, r.word)) return;
    if (r.once && is_listed_twice(r)) return reading_.fail({name_of(r).view(), " is listed twice"});
    if (!moves(r)) return evaluate_load(r);
    phrases_.check_misuse(r.value, name_of(r).view());
    if (r.what == load_word::potential_energy || r.what == load_word::spring ||
        r.what == load_word::torsional_spring || r.terms_given != 0 || (r.path != nullptr && moves(*r.path)))
      return reading_.fail(
          {name_of(r).view(), " contains a velocity or derivative; it may contain only coordinates"});
    const sentence whom = name_of(r);
    for (const point_record* p : {r.point, r.other_point})
      if (p != nullptr) entities_.point(p, whom.view());
    for (const frame_record* f : {r.frame, r.other_frame})
      if (f != nullptr) entities_.frame(f, whom.view());
    if (r.path != nullptr && !reading_.mistake) part_reader::mention(*r.path, whom.view());
    for (const phrase* each : {&r.value, &r.angle, &r.rest})
      for (const describe::token& t : *each)
        if (!reading_.mistake) mention(t, whom.view());
  }

  /// Returns the length of a pathway or the force of a load, for a phrase of `whom`.
  constexpr value quantity_of(const describe::token& t, std::string_view whom) {
    const auto wanted = static_cast<load_quantity>(t.index);
    const load_record& r = *t.load;
    if (wanted == load_quantity::length) return length_of(*r.path, whom);
    const std::string_view word = word_of(wanted);
    const auto fail = [&](std::string_view why) {
      reading_.fail({reading_.part, whom, " uses ", word, "<...> of ", name_of(r).view(), why});
      return value::of(m_.zero());
    };
    if (r.what == load_word::none) return fail(", which is not a load");
    if (!is_listed(r)) return fail(", which the system does not list in loads<...>");
    if (wanted == load_quantity::tension && !pulls(r)) return fail(", which does not act along a pathway");
    if (is_of_tyre(wanted) && r.tyre == nullptr) return fail(", which is not a tyre");
    const bool presses = r.contact != nullptr || (wanted == load_quantity::normal_force && r.tyre != nullptr);
    if (wanted != load_quantity::tension && !is_of_tyre(wanted) && !presses)
      return fail(", which is not a contact");
    if (reading_.for_units) return unit_of_quantity(wanted, r);
    mechanics::loads alone;
    evaluate_load(r, alone);
    if (reading_.mistake) return value::of(m_.zero());
    return observed_quantity(wanted, alone, reading_.known->moving());
  }

private:
  using load_word = describe::load_word;
  using load_quantity = describe::load_quantity;

  static constexpr bool pulls(const load_record& r) {
    const bool is_along_path = r.what >= load_word::path_force && r.what <= load_word::path_stop;
    return is_along_path || r.what == load_word::muscle || r.what == load_word::spring ||
           r.what == load_word::damper || (r.what == load_word::friction && r.path != nullptr);
  }

  constexpr bool is_listed(const load_record& r) const {
    bool found = false;
    for (const load_record& each : reading_.from.loads) found = found || &each == &r;
    for (const describe::joint_record& each : reading_.from.joints) found = found || each.stops == &r;
    return found;
  }

  constexpr value length_of(const path_record& r, std::string_view whom) {
    if (r.what == describe::path_word::none)
      reading_.fail({reading_.part, whom, " uses length_of<...> of ", short_name(r.called).view(),
                     ", which is ", r.instead.empty() ? "" : r.instead.substr(0, r.instead.find(';')),
                     r.instead.empty() ? "not a pathway" : ", not a pathway"});
    if (reading_.mistake || !path_reader(*this).is_pathway(r, "length_of<...>")) return value::of(m_.zero());
    if (reading_.for_units && r.ends_at_points())
      return value::of(symbol_of_unit(reading_, "length_of<...>", units::si::meter));
    const mechanics::pathway along = path_reader(*this).read(r, whom);
    if (!reading_.mistake) reading_.mistake = along.find_mistake(m_, "pathway");
    return value::of(reading_.mistake ? m_.zero() : along.length_in(m_));
  }

  /// The force along a pathway whose length is given has the unit that follows from this length.
  constexpr value unit_of_quantity(load_quantity wanted, const load_record& r) {
    const sentence whose = name_of(r), called({word_of(wanted), "<", r.word, ">"});
    if (is_vector(wanted))
      return value::of(vector_of_unit(reading_, word_of(wanted), whose.view(), describe::unit_of(wanted)));
    if (r.path != nullptr && !r.path->ends_at_points())
      return value::of(new_symbol(*m_.g, symbolic::symbol_kind::input, base::name(called.view())));
    return value::of(symbol_of_unit(reading_, base::name(called.view()), describe::unit_of(wanted)));
  }

  /// Whether a load depends on a motion that is not known while the model is read.
  constexpr bool moves(const load_record& r) const {
    bool any = moves(r.value) || moves(r.angle) || moves(r.rest);
    if (r.path != nullptr) any = any || moves(*r.path);
    for (int i = 0; i < r.terms_given; ++i) any = any || moves(r.terms[i]);
    return any;
  }
  constexpr bool moves(const path_record& r) const {
    return moves(r.length) || moves(r.axis) || moves(r.size);
  }
  constexpr bool moves(const phrase& p) const {
    for (const describe::token& t : p)
      if (!phrases_.is_declared(t)) return true;
    return false;
  }

  constexpr bool is_listed_twice(const load_record& r) const {
    int times = 0;
    for (const load_record& each : reading_.from.loads) times += &each == &r ? 1 : 0;
    return times > 1;
  }

  constexpr void mention(const describe::token& t, std::string_view whom) {
    if (t.frame != nullptr) entities_.frame(t.frame, whom);
    if (t.point != nullptr) entities_.point(t.point, whom);
    if (t.symbol != nullptr) symbols_.symbol(*t.symbol, whom);
    if (t.load != nullptr && t.load->path != nullptr) part_reader::mention(*t.load->path, whom);
  }

  constexpr void evaluate_load(const load_record& r) { evaluate_load(r, reading_.into.loads); }
  constexpr void evaluate_load(const load_record& r, mechanics::loads& into) {
    const sentence whom = name_of(r);
    switch (r.what) {
    case load_word::force: {
      const auto [at, other] = points_of(r, r.other_point != nullptr ? whom.view() : "a force"sv);
      const mechanics::vector v = effort_of(r, whom.view(), " at "sv);
      if (reading_.for_units && r.coefficient != nullptr) expect_unit(*r.coefficient, *r.point);
      if (!reading_.mistake) into.forces.push({at, v, other});
      return;
    }
    case load_word::torque: {
      const auto [on, other] = frames_of(r, r.other_frame != nullptr ? whom.view() : "a torque"sv);
      const mechanics::vector v = effort_of(r, whom.view(), " on "sv);
      if (!reading_.mistake) into.torques.push({on, v, other});
      return;
    }
    case load_word::gravity: return evaluate_gravity(into, r);
    case load_word::potential_energy: {
      const expression energy = phrases_.scalar_of(r.value, {""sv, whom.view()}, whom.view());
      if (reading_.mistake) return;
      if (energy.is_zero() && !symbols_.holds_bound(r.value)) return reading_.fail({whom.view(), " is zero"});
      into.potential_energies.push({energy});
      return;
    }
    case load_word::spring: {
      const auto [at, other] = points_of(r, whom.view());
      const expression stiffness = part_of(r.value, "the stiffness of "sv, whom.view());
      const expression length = part_of(r.rest, "the natural length of "sv, whom.view());
      if (!reading_.mistake) mechanics::add_spring(into.spring_dampers, at, other, stiffness, length);
      return;
    }
    case load_word::torsional_spring: return evaluate_torsional_spring(into, r, whom.view());
    case load_word::damper: {
      const auto [at, other] = points_of(r, whom.view());
      const expression damping = part_of(r.value, "the damping of "sv, whom.view());
      if (!reading_.mistake) mechanics::add_damper(into.spring_dampers, at, other, damping);
      return;
    }
    case load_word::torsional_damper: {
      const auto [on, other] = frames_of(r, whom.view());
      const expression damping = part_of(r.value, "the damping of "sv, whom.view());
      if (!reading_.mistake) into.torsional_dampers.push({on, other, damping});
      return;
    }
    case load_word::path_force:
    case load_word::path_spring:
    case load_word::path_cubic_spring:
    case load_word::path_damper:
    case load_word::path_stop: return evaluate_path_load(into, r, whom.view());
    case load_word::bushing: {
      mechanics::bushing b;
      const auto [on, other] = frames_of(r, whom.view());
      const auto [at, base] = points_of(r, whom.view());
      b.frame = on, b.against = other, b.place = at, b.base = base;
      for (int i = 0; i < 12; ++i) {
        const bool is_given = i < r.terms_given && !reading_.mistake;
        const expression term =
            is_given ? part_of(r.terms[i], i < 6 ? "a stiffness of " : "a damping of ", whom.view())
                     : m_.zero();
        (i < 6 ? b.stiffness : b.damping).push(term);
      }
      if (!reading_.mistake) into.bushings.push(b);
      return;
    }
    case load_word::friction: return evaluate_friction(into, r, whom.view());
    case load_word::contact: return evaluate_contact(into, r, whom.view());
    case load_word::muscle: return muscle_reader(*this).read(into, r, whom.view());
    case load_word::tyre: return tyres_.read(into, *r.tyre, whom.view());
    case load_word::none:
      if (r.unparsed) return reading_.fail_by_unparsed(r.called, "loads<...>");
      return reading_.fail({"loads<...> lists ", short_name(r.called).view(), ", which is ",
                            r.instead.empty() ? "not a load" : r.instead});
    }
  }

  constexpr void evaluate_path_load(mechanics::loads& into, const load_record& r, std::string_view whom) {
    const mechanics::pathway along = path_reader(*this).read(*r.path, whom);
    const auto term = [&](int i, std::string_view part) { return part_of(r.terms[i], part, whom); };
    if (r.what == load_word::path_force) {
      const expression tension = part_of(r.value, "", whom);
      if (!reading_.mistake) mechanics::add_force_along(into, along, tension);
    } else if (r.what == load_word::path_damper) {
      const expression damping = part_of(r.value, "the damping of ", whom);
      if (!reading_.mistake) mechanics::add_damper_along(into, along, damping);
    } else if (r.what == load_word::path_stop) {
      mechanics::stop_at_ends by{term(0, "the least length of "), term(1, "the greatest length of "),
                                 term(2, "the stiffness of "), term(3, "the damping of ")};
      if (r.terms_given > 4) by.width = term(4, "the width of ");
      if (!reading_.mistake) mechanics::add_stop(into, along, by);
    } else {
      const bool is_cubic = r.what == load_word::path_cubic_spring;
      const expression stiffness = term(0, "the stiffness of ");
      const expression cubic = is_cubic ? term(1, "the cubic stiffness of ") : m_.zero();
      const expression length = term(is_cubic ? 2 : 1, "the natural length of ");
      if (!reading_.mistake) mechanics::add_spring_along(into, along, stiffness, cubic, length);
    }
  }

  /// The points or frames between which a load acts; if there is only one, the second is `none`.
  struct ends {
    int first, other;
  };
  constexpr ends points_of(const load_record& r, std::string_view whom) {
    const int first = entities_.point(r.point, whom);
    return {first, r.other_point != nullptr ? entities_.point(r.other_point, whom) : none};
  }
  constexpr ends frames_of(const load_record& r, std::string_view whom) {
    const int first = entities_.frame(r.frame, whom);
    return {first, r.other_frame != nullptr ? entities_.frame(r.other_frame, whom) : none};
  }

  /// Returns the vector of a force or torque. If the load acts on a single entity, messages about the vector
  /// name that entity.
  constexpr mechanics::vector effort_of(const load_record& r, std::string_view whom, std::string_view place) {
    if (r.other_point != nullptr || r.other_frame != nullptr)
      return phrases_.vector_of(r.value, {""sv, whom}, whom);
    const std::string_view on = r.point != nullptr ? r.point->called : r.frame->called;
    const sentence load({r.word, place});
    return phrases_.vector_of(r.value, {load.view(), on}, on);
  }
  /// Names a coefficient if its unit does not fit.
  constexpr void expect_unit(const describe::coefficient_record& c, const point_record& at) {
    const expression value = phrases_.scalar_of(c.value, {"", c.word}, c.word);
    base::name word = c.word;
    word.append(" at ");
    if (!reading_.mistake) m_.expected_units.push({value, c.unit, word, at.called});
  }
  constexpr expression part_of(const phrase& p, std::string_view part, std::string_view whom) {
    return phrases_.scalar_of(p, {part, whom}, whom);
  }

  constexpr void evaluate_gravity(mechanics::loads& into, const load_record& r) {
    if (into.has_gravity) reading_.fail({"gravity is listed twice"});
    const mechanics::vector v = phrases_.vector_of(r.value, {""sv, "gravity"sv}, "gravity"sv);
    if (!reading_.mistake) into.has_gravity = true, into.gravity = v;
  }

  constexpr void evaluate_friction(mechanics::loads& into, const load_record& r, std::string_view whom) {
    const expression normal = part_of(r.rest, "the normal force of ", whom);
    if (reading_.mistake) return;
    const mechanics::friction_law law = contacts_.law_of(*r.friction, r.states, {}, whom);
    if (r.path == nullptr) return evaluate_friction_in_joint(into, r, normal, law, whom);
    const mechanics::pathway along = path_reader(*this).read(*r.path, whom);
    if (reading_.mistake) return;
    mechanics::add_friction_along(into, along, normal, law);
    mechanics::add_bristles(m_, into, law);
  }

  constexpr void evaluate_friction_in_joint(mechanics::loads& into, const load_record& r, expression normal,
                                            const mechanics::friction_law& law, std::string_view whom) {
    const mechanics::vector axis = phrases_.vector_of(r.value, {"the axis of ", whom}, whom);
    const expression slip = part_of(r.angle, "the speed of ", whom);
    if (reading_.mistake) return;
    check_friction(normal, law, whom);
    if (reading_.mistake) return;
    if (reading_.for_units) return expect_units_of_friction(r, normal, law);
    reading_.hides_units = true; // a slip speed may be a number
    const mechanics::vector effort = -(normal * law.coefficient(slip)) * axis;
    if (r.frame != nullptr) {
      const auto [on, other] = frames_of(r, whom);
      if (!reading_.mistake) into.torques.push({on, effort, other});
    } else {
      const auto [at, other] = points_of(r, whom);
      if (!reading_.mistake) into.forces.push({at, effort, other});
    }
  }

  /// States the units of the friction in a joint, whose slip speed may be a number.
  constexpr void expect_units_of_friction(const load_record& r, expression normal,
                                          const mechanics::friction_law& law) {
    namespace si = units::si;
    const bool turns = r.frame != nullptr;
    const units::unit effort = turns ? si::newton * si::meter : si::newton;
    const units::unit speed = (turns ? si::radian : si::meter) / si::second;
    const sentence bodies = turns ? sentence({r.frame->called, " and ", r.other_frame->called})
                                  : sentence({r.point->called, " and ", r.other_point->called});
    const auto state = [&](expression e, std::string_view what, const units::unit& u) {
      m_.expected_units.push({e, u, base::name(what), base::name(bodies.view())});
    };
    if (law.slip_speed.is_given()) state(law.slip_speed, "the slip speed of the friction between ", speed);
    if (law.sliding.is_given()) state(normal * law.sliding, "the dry part of the friction between ", effort);
    if (law.sticking.is_given())
      state(normal * law.sticking, "the static part of the friction between ", effort);
    if (law.viscous.is_given() && !law.viscous.is_constant()) // a number is in SI units
      state(normal * law.viscous, "the viscous part of the friction between ", effort / speed);
  }

  constexpr void check_friction(expression normal, const mechanics::friction_law& law,
                                std::string_view whom) {
    const mechanics::contents held(*m_.g);
    mechanics::load_check by(m_, held);
    by.check_not_negative(normal, "the normal force of ", whom);
    law.check_with(by, whom);
    reading_.mistake = by.mistake();
  }

  constexpr void evaluate_contact(mechanics::loads& into, const load_record& r, std::string_view whom) {
    if (!r.contact->mistake.empty()) return reading_.fail({whom, " ", r.contact->mistake});
    const mechanics::contact c = contacts_.read(*r.contact, r.states, whom);
    if (reading_.mistake) return;
    into.contacts.push(c);
    mechanics::add_bristles(m_, into, c.friction);
  }

  constexpr void evaluate_torsional_spring(mechanics::loads& into, const load_record& r,
                                           std::string_view whom) {
    const expression angle = part_of(r.angle, "the angle of "sv, whom);
    const expression stiffness = part_of(r.value, "the stiffness of "sv, whom);
    const expression rest = part_of(r.rest, "the rest angle of "sv, whom);
    if (!reading_.mistake)
      reading_.mistake = mechanics::check_torsional_spring(m_, angle, stiffness, rest, whom);
    if (!reading_.mistake) into.potential_energies.push(mechanics::torsional_spring(angle, stiffness, rest));
  }

  contact_reader contacts_{reading_, symbols_, phrases_, entities_};
  tyre_reader tyres_{reading_, symbols_, phrases_, entities_};
};

constexpr load_lookup lookup_in(load_reader& all) {
  return {&all, [](load_reader& with, const describe::token& t, std::string_view whom) {
            return with.quantity_of(t, whom);
          }};
}

} // namespace kanexpr::derivation
