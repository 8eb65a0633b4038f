#pragma once

#include <kanexpr/derive/read/lagrange_reader.hpp>
#include <kanexpr/derive/read/load_wording.hpp>
#include <kanexpr/mechanics/checks/check_torsional_spring.hpp>
#include <kanexpr/mechanics/model/loads.hpp>

namespace kanexpr::deriving {

/// The loads of a model. Those that speak of motion are read with their symbols and entities like all others,
/// and evaluated when velocities are known.
class load_reader : public lagrange_reader {
public:
  using lagrange_reader::lagrange_reader;

  /// After `know`. Whether there were any.
  constexpr bool read_moving_loads() {
    bool any = false;
    for (int i = 0; i < from_.loads.size && !mistake_; ++i) {
      if (!moves(from_.loads[i])) continue;
      any = true;
      evaluate_load(from_.loads[i]);
    }
    return any;
  }

protected:
  constexpr void read_load(const load_record& r) {
    if (!words_belong(r.beside, r.called)) return;
    if (!r.fits) return wrong_count("", name_of(r).view(), r.fits);
    if (!moves(r)) return evaluate_load(r);
    check_written(r.value, name_of(r).view());
    if (r.what == load_word::potential_energy || r.what == load_word::spring ||
        r.what == load_word::torsional_spring)
      return fail({name_of(r).view(), " holds a velocity or derivative; it may hold coordinates only"});
    const sentence whom = name_of(r);
    for (const point_record* p : {r.point, r.other_point})
      if (p != nullptr) point(p, whom.view());
    for (const frame_record* f : {r.frame, r.other_frame})
      if (f != nullptr) frame(f, whom.view());
    for (int i = 0; i < r.value.size && !mistake_; ++i) mention(r.value.tokens[i], whom.view());
  }

private:
  using load_word = describe::load_word;

  /// Whether a load speaks of motion that is not known while the model is read.
  constexpr bool moves(const load_record& r) const {
    return moves(r.value) || moves(r.angle) || moves(r.rest);
  }
  constexpr bool moves(const phrase& p) const {
    for (int i = 0; i < p.size; ++i)
      if (!is_declared(p.tokens[i])) return true;
    return false;
  }

  constexpr void mention(const describe::token& t, std::string_view whom) {
    if (t.frame != nullptr) frame(t.frame, whom);
    if (t.point != nullptr) point(t.point, whom);
    if (t.symbol != nullptr) symbol(*t.symbol, whom);
  }

  constexpr void evaluate_load(const load_record& r) {
    switch (r.what) {
    case load_word::force: return evaluate_force(r);
    case load_word::torque: return evaluate_torque(r);
    case load_word::gravity: return evaluate_gravity(r);
    case load_word::potential_energy: {
      const sentence whom = name_of(r);
      const expression energy = scalar_of(r.value, {"", whom.view()}, whom.view());
      if (mistake_) return;
      if (energy.is_zero() && !holds_bound(r.value))
        return fail({whom.view(), " is zero; 1/2 of whole numbers is 0 in C++"});
      m_.potential_energies.push(energy);
      break;
    }
    case load_word::spring: return evaluate_spring(r);
    case load_word::torsional_spring: return evaluate_torsional_spring(r);
    case load_word::damper: {
      const sentence whom = name_of(r);
      const int at = point(r.point, whom.view()), other = point(r.other_point, whom.view());
      const expression damping = damping_of(r, whom.view());
      if (!mistake_) mechanics::add_damper(m_, at, other, damping);
      break;
    }
    case load_word::torsional_damper: {
      const sentence whom = name_of(r);
      const int on = frame(r.frame, whom.view()), other = frame(r.other_frame, whom.view());
      const expression damping = damping_of(r, whom.view());
      if (!mistake_) mechanics::add_torsional_damper(m_, on, other, damping);
      break;
    }
    case load_word::none:
      if (r.unparsed) return fail_by_unparsed(r.called, "loads<...>");
      return fail({"loads<...> lists ", short_name(r.called).view(), ", which is ",
                   r.instead.empty() ? "not a load" : r.instead});
    }
  }

  constexpr void evaluate_force(const load_record& r) {
    if (r.other_point != nullptr) {
      const sentence whom = name_of(r);
      const int at = point(r.point, whom.view()), other = point(r.other_point, whom.view());
      const mechanics::vector v = vector_of(r.value, {"", whom.view()}, whom.view());
      if (!mistake_) mechanics::add_force(m_, at, v, other);
      return;
    }
    const int at = point(r.point, "a force");
    const sentence word = mechanics::sentence({r.word, " at "});
    const mechanics::vector v = vector_of(r.value, {word.view(), r.point->called}, r.point->called);
    if (!mistake_) mechanics::add_force(m_, at, v);
  }

  constexpr void evaluate_torque(const load_record& r) {
    if (r.other_frame != nullptr) {
      const sentence whom = name_of(r);
      const int on = frame(r.frame, whom.view()), other = frame(r.other_frame, whom.view());
      const mechanics::vector v = vector_of(r.value, {"", whom.view()}, whom.view());
      if (!mistake_) mechanics::add_torque(m_, on, v, other);
      return;
    }
    const int on = frame(r.frame, "a torque");
    const sentence word = mechanics::sentence({r.word, " on "});
    const mechanics::vector v = vector_of(r.value, {word.view(), r.frame->called}, r.frame->called);
    if (!mistake_) mechanics::add_torque(m_, on, v);
  }

  constexpr void evaluate_gravity(const load_record& r) {
    if (m_.has_gravity) fail({"gravity is given twice"});
    const mechanics::vector v = vector_of(r.value, {"", "gravity"}, "gravity");
    if (!mistake_) mechanics::set_gravity(m_, v);
  }

  constexpr void evaluate_spring(const load_record& r) {
    const sentence whom = name_of(r);
    const int at = point(r.point, whom.view()), other = point(r.other_point, whom.view());
    const expression stiffness = scalar_of(r.value, {"the stiffness of ", whom.view()}, whom.view());
    const expression length = scalar_of(r.rest, {"the natural length of ", whom.view()}, whom.view());
    if (!mistake_) mechanics::add_spring(m_, at, other, stiffness, length);
  }

  constexpr void evaluate_torsional_spring(const load_record& r) {
    const sentence whom = name_of(r);
    const expression angle = scalar_of(r.angle, {"the angle of ", whom.view()}, whom.view());
    const expression stiffness = scalar_of(r.value, {"the stiffness of ", whom.view()}, whom.view());
    const expression rest = scalar_of(r.rest, {"the angle at rest of ", whom.view()}, whom.view());
    if (!mistake_) mistake_ = mechanics::check_torsional_spring(m_, angle, stiffness, rest, whom.view());
    if (!mistake_) mechanics::add_torsional_spring(m_, angle, stiffness, rest);
  }

  constexpr expression damping_of(const load_record& r, std::string_view whom) {
    return scalar_of(r.value, {"the damping of ", whom}, whom);
  }
};

} // namespace kanexpr::deriving
