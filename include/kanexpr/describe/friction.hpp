#pragma once

#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/loads/friction_kind.hpp>

/// The laws of friction, for joints and contacts.
namespace kanexpr {

namespace describe {

template <class Law>
concept law_of_friction = requires { Law::friction_law; };

template <class Law>
inline constexpr friction_record friction_of = Law::friction_law;

} // namespace describe

/// Dry friction by Coulomb's law, made smooth: the force −N μ v/√(v² + vₛ²) at the normal force N and the
/// slip velocity v. Rest is slow creep: a friction force F is reached at a slip of about vₛ F/(μ N). The slip
/// speed vₛ is in rad/s for joints that rotate. A contact with a `restitution<e, v>` may omit it; it is then
/// 1/100 of the approach speed v. `coulomb_friction<mu, vs>`
template <auto... values>
struct coulomb_friction {
  static constexpr describe::friction_record friction_law{
      .kind = mechanics::friction_kind::coulomb,
      .sliding = describe::given_phrases<values...>[0],
      .slip_speed = sizeof...(values) == 2 ? describe::given_phrases<values...>[1] : describe::phrase{},
      .fits = describe::arguments_of("coulomb_friction<coefficient, slip speed>", sizeof...(values), 1, 2)};
};

/// Dry friction with a peak at small slip and a viscous part, after P. Brown and J. McPhee (2016): the force
/// −N μ(v) with μ(v) = μ_d tanh(4 v/v_t) + (μ_s − μ_d) (v/v_t)/((v/(2v_t))² + ¾)² + c v. The static
/// coefficient μ_s is reached at the slip speed v_t, and the viscous coefficient c is in s/m, or s/rad for
/// joints that rotate. `stribeck_friction<mu_static, mu_dynamic, vt, c>`; c may be omitted.
template <auto... values>
struct stribeck_friction {
  static constexpr describe::friction_record friction_law{
      .kind = mechanics::friction_kind::stribeck,
      .sliding = describe::given_phrases<values...>[1],
      .sticking = describe::given_phrases<values...>[0],
      .slip_speed = describe::given_phrases<values...>[2],
      .viscous = describe::given_phrases<values...>[3],
      .fits = describe::arguments_of("stribeck_friction<static, dynamic, slip speed, viscous>",
                                     sizeof...(values), 3, 4)};
};

/// Viscous friction: the force −N c v. `viscous_friction<c>`
template <auto... values>
struct viscous_friction {
  static constexpr describe::friction_record friction_law{
      .kind = mechanics::friction_kind::viscous,
      .viscous = describe::given_phrases<values...>[0],
      .fits = describe::arguments_of("viscous_friction<coefficient>", sizeof...(values), 1)};
};

} // namespace kanexpr
