#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/derivation/read/load_table.hpp>
#include <kanexpr/derivation/read/path_reader.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/derivation/read/wheel_reader.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/units/si.hpp>

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
    if (r.what == load_word::none) return evaluate_load(r); // reports it
    if (row_of(r).is_conservative || r.terms_given != 0 || (r.path != nullptr && moves(*r.path)))
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
    if (r.wheel != nullptr) return place_of_wheel(wanted, r, whom);
    if (wanted == load_quantity::length) return length_of(*r.path, whom);
    const std::string_view word = word_of(wanted);
    const auto fail = [&](std::string_view why) {
      reading_.fail({reading_.part, whom, " uses ", word, "<...> of ", name_of(r).view(), why});
      return value::of(m_.zero());
    };
    if (r.what == load_word::none) return fail(", which is not a load");
    if (!is_listed(r)) return fail(", which the system does not list in loads<...>");
    const load_row& row = row_of(r);
    const bool acts_along_path =
        row.tension != nullptr && (r.what != load_word::friction || r.path != nullptr);
    const bool is_tension = wanted == load_quantity::tension;
    const bool is_observed = is_tension          ? acts_along_path
                             : r.tyre != nullptr ? is_of_tyre(wanted) || wanted == load_quantity::normal_force
                                                 : row.observe != nullptr && !is_of_tyre(wanted);
    if (!is_observed)
      return fail(is_tension           ? ", which does not act along a pathway"
                  : is_of_tyre(wanted) ? ", which is not a tyre"
                                       : ", which is not a contact");
    if (reading_.for_units) return unit_of_quantity(wanted, r);
    mechanics::loads alone;
    evaluate_load(r, alone);
    if (reading_.mistake) return value::of(m_.zero());
    mechanics::observed_motion on(reading_.known->moving());
    return row.observe != nullptr ? row.observe(wanted, alone, on) : value::of(row.tension(alone, on));
  }

private:
  using load_quantity = describe::load_quantity;

  static constexpr std::string_view word_of(load_quantity what) {
    switch (what) {
    case load_quantity::length: return "length_of";
    case load_quantity::penetration: return "penetration_of";
    case load_quantity::tension: return "tension_of";
    case load_quantity::normal_force: return "normal_force_of";
    case load_quantity::longitudinal_force: return "longitudinal_force_of";
    case load_quantity::lateral_force: return "lateral_force_of";
    case load_quantity::aligning_moment: return "aligning_moment_of";
    case load_quantity::longitudinal_slip: return "longitudinal_slip_of";
    case load_quantity::lateral_slip: return "lateral_slip_of";
    case load_quantity::camber: return "sine_of_camber_of";
    case load_quantity::friction_force: return "friction_force_of";
    case load_quantity::contact_force:
    case load_quantity::contact_place: return "show_forces";
    case load_quantity::lowest_point: return "contact_point";
    }
    return {};
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

  constexpr value place_of_wheel(load_quantity wanted, const load_record& of, std::string_view whom) {
    if (reading_.for_units) {
      if (is_vector(wanted))
        return value::of(vector_of_unit(reading_, word_of(wanted), whom, units::si::meter));
      return value::of(symbol_of_unit(reading_, "penetration_of<...>", units::si::meter));
    }
    load_parts parts(*this, of, reading_.into.loads, whom);
    const mechanics::wheel_on_ground w = wheel_reader(parts).read(*of.wheel);
    mechanics::vector lowest;
    if (!reading_.mistake) {
      const mechanics::contents held(*m_.g);
      mechanics::load_check by(m_, held);
      w.check_with(by, "the wheel");
      reading_.mistake = by.mistake();
    }
    if (reading_.mistake) return is_vector(wanted) ? value::of(lowest) : value::of(m_.zero());
    const mechanics::wheel_contact at = w.contact(m_);
    if (!is_vector(wanted)) return value::of(at.penetration);
    lowest.add(w.other, at.lowest);
    return value::of(lowest);
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
    if (r.what != load_word::none) {
      load_parts parts(*this, r, into, whom.view());
      return row_of(r).read(parts);
    }
    if (r.unparsed) return reading_.fail_by_unparsed(r.called, "loads<...>");
    reading_.fail({"loads<...> lists ", short_name(r.called).view(), ", which is ",
                   r.instead.empty() ? "not a load" : r.instead});
  }
};

constexpr load_lookup lookup_in(load_reader& all) {
  return {&all, [](load_reader& with, const describe::token& t, std::string_view whom) {
            return with.quantity_of(t, whom);
          }};
}

} // namespace kanexpr::derivation
