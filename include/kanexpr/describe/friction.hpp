#pragma once

#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/loads/friction_kind.hpp>

#include <cstddef>

/// The laws of friction, for joints and contacts.
namespace kanexpr {

namespace describe {

template <class Law>
concept law_of_friction = requires { Law::friction_law; };

template <class Law>
inline constexpr friction_record friction_of = Law::friction_law;

template <class Law>
concept law_with_bristles =
    law_of_friction<Law> && Law::friction_law.kind == mechanics::friction_kind::bristles;

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

/// Dahl's law of friction (1968): the force −N σ z of bristles that deflect by z, with z' = v − σ |v| z/μ. In
/// contrast to the laws above, it holds a load at rest without creep. The deflection is a state variable,
/// `bristle_of<...>`. σ is the stiffness of the bristles by the normal force, in 1/m or 1/rad. The slip speed
/// e is that over which |v| is smoothed, v²/√(v² + e²); a contact with a `restitution<e, v>` may omit it, as
/// for `coulomb_friction`. `dahl_friction<mu, sigma, e>`
template <auto... values>
struct dahl_friction {
  static constexpr describe::friction_record friction_law{
      .kind = mechanics::friction_kind::bristles,
      .sliding = describe::given_phrases<values...>[0],
      .slip_speed = sizeof...(values) == 3 ? describe::given_phrases<values...>[2] : describe::phrase{},
      .stiffness = describe::given_phrases<values...>[1],
      .fits = describe::arguments_of("dahl_friction<coefficient, stiffness, slip speed>", sizeof...(values),
                                     2, 3)};
};

/// The law of friction by C. Canudas de Wit, H. Olsson, K. J. Åström & P. Lischinsky (1995), LuGre: the force
/// −N (σ₀ z + s σ₁ z' + σ₂ v) of bristles that deflect by z, with z' = v − σ₀ |v| z/μ(v) and the coefficient
/// μ(v) = μ_c + (μ_s − μ_c) exp(−(v/v_s)²). σ₀, σ₁ and σ₂ are stiffness, damping and viscous friction by the
/// normal force. The factor s = 1/(1 + σ₁ |v|/(4 μ)) reduces the damping during slip as far as necessary so
/// that the friction never creates energy. The slip speed over which |v| is smoothed is v_s/1000 if it is
/// omitted. `lugre_friction<mu_static, mu_sliding, vs, sigma0, sigma1, sigma2, e>`; σ₁ and σ₂ may be omitted.
template <auto... values>
struct lugre_friction {
  static constexpr std::size_t given = sizeof...(values);
  static constexpr describe::friction_record friction_law{
      .kind = mechanics::friction_kind::bristles,
      .sliding = describe::given_phrases<values...>[1],
      .sticking = describe::given_phrases<values...>[0],
      .slip_speed = given == 7 ? describe::given_phrases<values...>[6] : describe::phrase{},
      .viscous = given > 5 ? describe::given_phrases<values...>[5] : describe::phrase{},
      .stiffness = describe::given_phrases<values...>[3],
      .damping = given > 4 ? describe::given_phrases<values...>[4] : describe::phrase{},
      .stribeck_speed = describe::given_phrases<values...>[2],
      .fits = describe::arguments_of(
          "lugre_friction<static, sliding, Stribeck speed, stiffness, damping, viscous, slip speed>", given,
          4, 7)};
};

} // namespace kanexpr
