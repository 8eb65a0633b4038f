#pragma once

#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/tyre_record.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>

#include <string_view>

/// The words of a tyre, which follow its wheel and its ground in any order.
namespace kanexpr {

namespace describe {

enum class tyre_word : unsigned char { law, load, standstill, trail, camber, radius, relaxation };

template <class Word, tyre_word wanted>
concept is_tyre_word = requires { requires Word::tyre_word == wanted; };

template <class Word>
concept word_of_a_tyre = requires { Word::tyre_word; };

template <tyre_word wanted, class... Words>
inline constexpr int times_of_tyre_word = (0 + ... + static_cast<int>(is_tyre_word<Words, wanted>));

/// Returns the end of a sentence about words that are missing, repeated or foreign; empty if there is none.
template <class... Words>
constexpr std::string_view mistake_of_tyre_words(mechanics::tyre_model model) {
  using enum tyre_word;
  if constexpr (!(word_of_a_tyre<Words> && ...))
    return "has an argument that is not a word of a tyre, such as wheel_load<Fz> or standstill<v0>";
  else if constexpr (times_of_tyre_word<law, Words...> != 1)
    return "needs one law: linear_tyre<...>, brush_tyre<...> or magic_formula<...>";
  else if constexpr (times_of_tyre_word<standstill, Words...> != 1)
    return "needs one standstill<speed>";
  else if constexpr (times_of_tyre_word<load, Words...> > 1)
    return "has more than one of wheel_load<...> and radial_stiffness<...>";
  else if constexpr (times_of_tyre_word<trail, Words...> > 1)
    return "has two pneumatic_trail<...>";
  else if constexpr (times_of_tyre_word<camber, Words...> > 1)
    return "has two camber_stiffness<...>";
  else if constexpr (times_of_tyre_word<radius, Words...> > 1)
    return "has two effective_radius<...>";
  else if constexpr (times_of_tyre_word<relaxation, Words...> > 1)
    return "has two relaxation<...>";
  else {
    const bool is_linear = model == mechanics::tyre_model::linear;
    const bool is_formula = model == mechanics::tyre_model::magic_formula;
    if (!is_linear && times_of_tyre_word<load, Words...> == 0)
      return "needs a load: wheel_load<Fz> or radial_stiffness<k, c, width>";
    if (is_formula && times_of_tyre_word<trail, Words...> + times_of_tyre_word<camber, Words...> != 0)
      return "has a magic formula and a pneumatic_trail<...> or camber_stiffness<...>, which the formula "
             "contains";
  }
  return {};
}

template <class Word>
constexpr void add_to_tyre(tyre_record& r) {
  Word::add_to(r);
  if (r.fits) r.fits = Word::fits;
}

} // namespace describe

/// A tyre whose forces are linear in its slips, as a word of a tyre: F_x = C_κ κ and F_y = −C_α tan α.
/// `linear_tyre<C_kappa, C_alpha>`, both in N
template <auto... stiffnesses>
struct linear_tyre {
  static constexpr auto tyre_word = describe::tyre_word::law;
  static constexpr describe::arguments fits =
      describe::arguments_of("linear_tyre<slip stiffness, cornering stiffness>", sizeof...(stiffnesses), 2);
  static constexpr void add_to(describe::tyre_record& r) {
    r.model = mechanics::tyre_model::linear;
    r.slip_stiffness = describe::given_phrases<stiffnesses...>[0];
    r.cornering_stiffness = describe::given_phrases<stiffnesses...>[1];
  }
};

/// The brush model with a parabolic pressure, as a word of a tyre; without longitudinal slip, it is the tyre
/// of Fiala. `brush_tyre<mu, C>` with the coefficient of friction and the stiffness at small slip, in N, in
/// all directions; `brush_tyre<mu, C_x, C_y>` with those along and across the wheel. Pacejka (2012), section
/// 3.2.
template <auto... friction_and_stiffnesses>
struct brush_tyre {
  static constexpr auto tyre_word = describe::tyre_word::law;
  static constexpr describe::arguments fits =
      describe::arguments_of("brush_tyre<coefficient of friction, slip stiffness, cornering stiffness>",
                             sizeof...(friction_and_stiffnesses), 2, 3);
  static constexpr void add_to(describe::tyre_record& r) {
    constexpr bool is_isotropic = sizeof...(friction_and_stiffnesses) == 2;
    r.model = mechanics::tyre_model::brush;
    r.friction = describe::given_phrases<friction_and_stiffnesses...>[0];
    r.slip_stiffness = describe::given_phrases<friction_and_stiffnesses...>[1];
    r.cornering_stiffness = describe::given_phrases<friction_and_stiffnesses...>[is_isotropic ? 1 : 2];
  }
};

/// The Magic Formula for combined slip with camber, as a word of a tyre: `magic_formula<slick>`, where
/// `inline constexpr tyre_coefficients slick{.Fz0 = 4000, .R0 = 0.3, …};` contains its coefficients. Pacejka
/// (2012), section 4.3.2, without turn slip.
template <const auto& coefficients>
struct magic_formula {
  static constexpr auto tyre_word = describe::tyre_word::law;
  static constexpr describe::arguments fits{};
  static constexpr void add_to(describe::tyre_record& r) {
    r.model = mechanics::tyre_model::magic_formula;
    r.formula = &coefficients;
  }
};

/// The load F_z of a wheel as an expression, as a word of a tyre: `wheel_load<m*g/2>`. It acts only through
/// the law of the tyre; the ground does not push the wheel upward.
template <auto... load>
struct wheel_load {
  static constexpr auto tyre_word = describe::tyre_word::load;
  static constexpr describe::arguments fits = describe::arguments_of("wheel_load<Fz>", sizeof...(load), 1);
  static constexpr void add_to(describe::tyre_record& r) { r.load = describe::given_phrases<load...>[0]; }
};

/// The normal force of the ground on a wheel, as a word of a tyre: k δ (1 + c δ̇) at the penetration δ, made
/// smooth as in a contact, over the width w. `radial_stiffness<k, c, w>`
template <auto... stiffness_damping_and_width>
struct radial_stiffness {
  static constexpr auto tyre_word = describe::tyre_word::load;
  static constexpr describe::arguments fits = describe::arguments_of(
      "radial_stiffness<stiffness, damping, width>", sizeof...(stiffness_damping_and_width), 3);
  static constexpr void add_to(describe::tyre_record& r) {
    r.stiffness = describe::given_phrases<stiffness_damping_and_width...>[0];
    r.damping = describe::given_phrases<stiffness_damping_and_width...>[1];
    r.width = describe::given_phrases<stiffness_damping_and_width...>[2];
  }
};

/// The speed v₀ below which the slips of a tyre are smoothed, as a word of the tyre: the speed |V| by which
/// the slip velocity is divided is √(V² + v₀²). `standstill<v0>`
template <auto... speed>
struct standstill {
  static constexpr auto tyre_word = describe::tyre_word::standstill;
  static constexpr describe::arguments fits =
      describe::arguments_of("standstill<speed>", sizeof...(speed), 1);
  static constexpr void add_to(describe::tyre_record& r) {
    r.standstill = describe::given_phrases<speed...>[0];
  }
};

/// The distance by which the side force of a linear or brush tyre acts behind the contact at small slip, as a
/// word of the tyre: `pneumatic_trail<t>`. In the brush model, it is a sixth of the length of the contact.
template <auto... trail>
struct pneumatic_trail {
  static constexpr auto tyre_word = describe::tyre_word::trail;
  static constexpr describe::arguments fits =
      describe::arguments_of("pneumatic_trail<length>", sizeof...(trail), 1);
  static constexpr void add_to(describe::tyre_record& r) { r.trail = describe::given_phrases<trail...>[0]; }
};

/// The camber thrust −C_γ sin γ of a linear or brush tyre, as a word of the tyre: `camber_stiffness<C>`. The
/// camber γ is positive if the top of the wheel leans to the right.
template <auto... stiffness>
struct camber_stiffness {
  static constexpr auto tyre_word = describe::tyre_word::camber;
  static constexpr describe::arguments fits =
      describe::arguments_of("camber_stiffness<stiffness>", sizeof...(stiffness), 1);
  static constexpr void add_to(describe::tyre_record& r) {
    r.camber_stiffness = describe::given_phrases<stiffness...>[0];
  }
};

/// The effective rolling radius of a tyre, as a word of the tyre: a free rolling wheel advances by it per
/// radian. `effective_radius<r>`; the default is the distance of the contact from the axle.
template <auto... radius>
struct effective_radius {
  static constexpr auto tyre_word = describe::tyre_word::radius;
  static constexpr describe::arguments fits =
      describe::arguments_of("effective_radius<length>", sizeof...(radius), 1);
  static constexpr void add_to(describe::tyre_record& r) {
    r.effective_radius = describe::given_phrases<radius...>[0];
  }
};

/// The relaxation lengths of a tyre along and across the wheel, over which it must roll until its forces
/// follow the slip, as a word of the tyre: `relaxation<sigma_x, sigma_y>`. The deflections become state
/// variables, `forward_deflection_of<Center>` and `lateral_deflection_of<Center>`.
template <auto... lengths>
struct relaxation {
  static constexpr auto tyre_word = describe::tyre_word::relaxation;
  static constexpr describe::arguments fits =
      describe::arguments_of("relaxation<longitudinal length, lateral length>", sizeof...(lengths), 2);
  static constexpr void add_to(describe::tyre_record& r) {
    r.forward_length = describe::given_phrases<lengths...>[0];
    r.lateral_length = describe::given_phrases<lengths...>[1];
  }
};

} // namespace kanexpr
