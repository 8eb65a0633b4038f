#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/load_wording.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the loads of a model. The symbols and entities of loads that depend on motion are read like all
/// others; these loads are evaluated when velocities are known.
class load_reader {
public:
  constexpr load_reader(reading& all, symbol_reader& symbols, phrase_reader& phrases, entity_reader& entities)
      : reading_(all), m_(all.into.mechanism), symbols_(symbols), phrases_(phrases), entities_(entities) {}

  /// Reads the loads that depend on motion; returns whether there are any. Requires that `know` was called.
  constexpr bool read_moving_loads() {
    bool any = false;
    for (int i = 0; i < reading_.from.loads.size && !reading_.mistake; ++i) {
      if (!moves(reading_.from.loads[i])) continue;
      any = true;
      evaluate_load(reading_.from.loads[i]);
    }
    return any;
  }

  constexpr void read_load(const load_record& r) {
    if (!reading_.check_base_conflict(r.conflict, r.called)) return;
    if (!r.fits) return reading_.wrong_count("", name_of(r).view(), r.fits);
    if (r.once && is_listed_twice(r)) return reading_.fail({name_of(r).view(), " is listed twice"});
    if (!moves(r)) return evaluate_load(r);
    phrases_.check_written(r.value, name_of(r).view());
    if (r.what == load_word::potential_energy || r.what == load_word::spring ||
        r.what == load_word::torsional_spring)
      return reading_.fail(
          {name_of(r).view(), " contains a velocity or derivative; it may contain only coordinates"});
    const sentence whom = name_of(r);
    for (const point_record* p : {r.point, r.other_point})
      if (p != nullptr) entities_.point(p, whom.view());
    for (const frame_record* f : {r.frame, r.other_frame})
      if (f != nullptr) entities_.frame(f, whom.view());
    for (int i = 0; i < r.value.size && !reading_.mistake; ++i) mention(r.value.tokens[i], whom.view());
  }

private:
  using load_word = describe::load_word;

  /// Whether a load depends on a motion that is not known while the model is read.
  constexpr bool moves(const load_record& r) const {
    return moves(r.value) || moves(r.angle) || moves(r.rest);
  }
  constexpr bool moves(const phrase& p) const {
    for (int i = 0; i < p.size; ++i)
      if (!phrases_.is_declared(p.tokens[i])) return true;
    return false;
  }

  constexpr bool is_listed_twice(const load_record& r) const {
    int times = 0;
    for (int i = 0; i < reading_.from.loads.size; ++i) times += &reading_.from.loads[i] == &r ? 1 : 0;
    return times > 1;
  }

  constexpr void mention(const describe::token& t, std::string_view whom) {
    if (t.frame != nullptr) entities_.frame(t.frame, whom);
    if (t.point != nullptr) entities_.point(t.point, whom);
    if (t.symbol != nullptr) symbols_.symbol(*t.symbol, whom);
  }

  constexpr void evaluate_load(const load_record& r) {
    switch (r.what) {
    case load_word::force: return evaluate_force(r);
    case load_word::torque: return evaluate_torque(r);
    case load_word::gravity: return evaluate_gravity(r);
    case load_word::potential_energy: {
      const sentence whom = name_of(r);
      const expression energy = phrases_.scalar_of(r.value, {"", whom.view()}, whom.view());
      if (reading_.mistake) return;
      if (energy.is_zero() && !symbols_.holds_bound(r.value)) return reading_.fail({whom.view(), " is zero"});
      reading_.into.loads.potential_energies.push({energy});
      break;
    }
    case load_word::spring: return evaluate_spring(r);
    case load_word::torsional_spring: return evaluate_torsional_spring(r);
    case load_word::damper: {
      const sentence whom = name_of(r);
      const int at = entities_.point(r.point, whom.view()),
                other = entities_.point(r.other_point, whom.view());
      const expression damping = damping_of(r, whom.view());
      if (!reading_.mistake) mechanics::add_damper(reading_.into.loads.spring_dampers, at, other, damping);
      break;
    }
    case load_word::torsional_damper: {
      const sentence whom = name_of(r);
      const int on = entities_.frame(r.frame, whom.view()),
                other = entities_.frame(r.other_frame, whom.view());
      const expression damping = damping_of(r, whom.view());
      if (!reading_.mistake) reading_.into.loads.torsional_dampers.push({on, other, damping});
      break;
    }
    case load_word::none:
      if (r.unparsed) return reading_.fail_by_unparsed(r.called, "loads<...>");
      return reading_.fail({"loads<...> lists ", short_name(r.called).view(), ", which is ",
                            r.instead.empty() ? "not a load" : r.instead});
    }
  }

  constexpr void evaluate_force(const load_record& r) {
    if (r.other_point != nullptr) {
      const sentence whom = name_of(r);
      const int at = entities_.point(r.point, whom.view()),
                other = entities_.point(r.other_point, whom.view());
      const mechanics::vector v = phrases_.vector_of(r.value, {"", whom.view()}, whom.view());
      if (!reading_.mistake) reading_.into.loads.forces.push({at, v, other});
      return;
    }
    const int at = entities_.point(r.point, "a force");
    const sentence word = base::sentence({r.word, " at "});
    const mechanics::vector v = phrases_.vector_of(r.value, {word.view(), r.point->called}, r.point->called);
    if (!reading_.mistake) reading_.into.loads.forces.push({at, v});
  }

  constexpr void evaluate_torque(const load_record& r) {
    if (r.other_frame != nullptr) {
      const sentence whom = name_of(r);
      const int on = entities_.frame(r.frame, whom.view()),
                other = entities_.frame(r.other_frame, whom.view());
      const mechanics::vector v = phrases_.vector_of(r.value, {"", whom.view()}, whom.view());
      if (!reading_.mistake) reading_.into.loads.torques.push({on, v, other});
      return;
    }
    const int on = entities_.frame(r.frame, "a torque");
    const sentence word = base::sentence({r.word, " on "});
    const mechanics::vector v = phrases_.vector_of(r.value, {word.view(), r.frame->called}, r.frame->called);
    if (!reading_.mistake) reading_.into.loads.torques.push({on, v});
  }

  constexpr void evaluate_gravity(const load_record& r) {
    if (reading_.into.loads.has_gravity) reading_.fail({"gravity is listed twice"});
    const mechanics::vector v = phrases_.vector_of(r.value, {"", "gravity"}, "gravity");
    if (!reading_.mistake) reading_.into.loads.has_gravity = true, reading_.into.loads.gravity = v;
  }

  constexpr void evaluate_spring(const load_record& r) {
    const sentence whom = name_of(r);
    const int at = entities_.point(r.point, whom.view()), other = entities_.point(r.other_point, whom.view());
    const expression stiffness = phrases_.scalar_of(r.value, {"the stiffness of ", whom.view()}, whom.view());
    const expression length =
        phrases_.scalar_of(r.rest, {"the natural length of ", whom.view()}, whom.view());
    if (!reading_.mistake)
      mechanics::add_spring(reading_.into.loads.spring_dampers, at, other, stiffness, length);
  }

  constexpr void evaluate_torsional_spring(const load_record& r) {
    const sentence whom = name_of(r);
    const expression angle = phrases_.scalar_of(r.angle, {"the angle of ", whom.view()}, whom.view());
    const expression stiffness = phrases_.scalar_of(r.value, {"the stiffness of ", whom.view()}, whom.view());
    const expression rest = phrases_.scalar_of(r.rest, {"the rest angle of ", whom.view()}, whom.view());
    if (!reading_.mistake)
      reading_.mistake = mechanics::check_torsional_spring(m_, angle, stiffness, rest, whom.view());
    if (!reading_.mistake)
      reading_.into.loads.potential_energies.push(mechanics::torsional_spring(angle, stiffness, rest));
  }

  constexpr expression damping_of(const load_record& r, std::string_view whom) {
    return phrases_.scalar_of(r.value, {"the damping of ", whom}, whom);
  }

  reading& reading_;
  mechanism& m_;
  symbol_reader& symbols_;
  phrase_reader& phrases_;
  entity_reader& entities_;
};

} // namespace kanexpr::derivation
