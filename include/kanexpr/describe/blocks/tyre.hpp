#pragma once

#include <kanexpr/describe/blocks/block.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/tyre_words.hpp>
#include <kanexpr/describe/wheel.hpp>

namespace kanexpr {

/// The longitudinal deflection of a tyre with relaxation lengths, the state variable dx_Front of a wheel with
/// the center Front.
template <class Center>
inline constexpr describe::state_variable_of<"dx", Center> forward_deflection_of{};

/// The lateral deflection of a tyre with relaxation lengths, the state variable dy_Front.
template <class Center>
inline constexpr describe::state_variable_of<"dy", Center> lateral_deflection_of{};

namespace describe {

template <class Wheel, class Ground, class... Words>
constexpr tyre_record record_tyre() {
  tyre_record r;
  r.wheel = &wheel_of<Wheel, Ground>;
  r.mistake = r.wheel->mistake;
  if constexpr ((word_of_a_tyre<Words> && ...)) (add_to_tyre<Words>(r), ...);
  if (r.mistake.empty()) r.mistake = mistake_of_tyre_words<Words...>(r.model);
  if constexpr (requires { typename Wheel::center; }) {
    r.forward_deflection = phrase_of<forward_deflection_of<typename Wheel::center>>;
    r.lateral_deflection = phrase_of<lateral_deflection_of<typename Wheel::center>>;
  }
  return r;
}

template <class Wheel, class Ground, class... Words>
inline constexpr tyre_record tyre_of = record_tyre<Wheel, Ground, Words...>();

template <class Center>
inline constexpr listing<phrase> deflections_of = list_of<phrase, &phrase_of<forward_deflection_of<Center>>,
                                                          &phrase_of<lateral_deflection_of<Center>>>::all;

} // namespace describe

/// A wheel with a tyre on the ground, as a load: `tyre<thin_wheel<Front, Front::y, R>, flat_ground<O, N::z>,
/// brush_tyre<mu, C>, wheel_load<Fz>, standstill<0.1>>`. After the wheel and its ground, the words follow in
/// any order: a law, `linear_tyre`, `brush_tyre` or `magic_formula`; the load, `wheel_load` or
/// `radial_stiffness`, which only the linear tyre does not need; `standstill`; and, optionally,
/// `pneumatic_trail`, `camber_stiffness`, `relaxation` and `effective_radius`.
template <class Wheel, class Ground, class... Words>
struct tyre : describe::load_words {
  static constexpr describe::load_record load = [] {
    const describe::tyre_record& t = describe::tyre_of<Wheel, Ground, Words...>;
    describe::load_record r;
    r.what = describe::load_word::tyre;
    r.word = "the tyre";
    r.once = true;
    r.fits = t.fits;
    r.point = t.wheel->center;
    r.other_point = t.wheel->place;
    r.tyre = &t;
    if constexpr (requires { typename Wheel::center; })
      if (t.forward_length.tokens != nullptr) r.states = describe::deflections_of<typename Wheel::center>;
    return r;
  }();
};

} // namespace kanexpr
