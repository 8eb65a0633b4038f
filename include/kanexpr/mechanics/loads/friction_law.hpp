#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/bristles.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/friction_kind.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <cstdint>
#include <string_view>

/// The friction force as a function of the slip velocity and the normal force, whatever it acts on: a joint,
/// a contact or a pathway.
namespace kanexpr::mechanics {

namespace detail {

/// tanh(√z)/√z, which is smooth at z = 0: below z = 0.01 it is evaluated by its series.
constexpr expression tanh_over_root(expression z) {
  constexpr std::int64_t series[][2]{{21844, 6081075}, {-1382, 155925}, {62, 2835}, {-17, 315},
                                     {2, 15},          {-1, 3},         {1, 1}};
  const auto term = [&](int i) { return z.number(symbolic::exactly(series[i][0], series[i][1])); };
  const expression limit = z.number(symbolic::exactly(1, 100)), bounded = (symbolic::min)(z, limit);
  expression sum = term(0);
  for (int i = 1; i < 7; ++i) sum = sum * bounded + term(i); // does not overflow in single precision
  const expression root = sqrt(z), ratio = tanh(root) / root;
  return symbolic::if_positive(z - limit, ratio, sum);
}

} // namespace detail

/// A law of friction. The friction force is −N μ(v), where N is the normal force and v the slip velocity, and
/// always opposes slip, so it only takes energy if N ≥ 0.
///
/// - Coulomb, smooth: μ(v) = μ v/√(v² + vₛ²), with the slip speed vₛ over which sticking is smoothed.
/// - Stribeck, after Brown & McPhee (2016), doi 10.1115/1.4033658: μ(v) = μ_d tanh(4 v/v_t) + (μ_s − μ_d)
///   (v/v_t)/((v/(2v_t))² + ¾)² + c v. The static coefficient μ_s is reached at the slip speed v_t.
/// - viscous: μ(v) = c v.
/// - bristles: those of Dahl, with a constant coefficient, or of LuGre, with μ(v) = μ_c + (μ_s − μ_c)
///   exp(−(v/v_s)²) and the further force −N c v. The slip speed is that over which |v| is smoothed.
struct friction_law {
  friction_kind kind = friction_kind::frictionless;
  expression sliding{};    ///< μ, μ_d or μ_c
  expression sticking{};   ///< μ_s
  expression slip_speed{}; ///< vₛ or v_t
  expression viscous{};    ///< c
  mechanics::bristles bristles{};

  static constexpr friction_law coulomb(expression mu, expression slip_speed) {
    return {friction_kind::coulomb, mu, {}, slip_speed, {}};
  }
  static constexpr friction_law stribeck(expression mu_static, expression mu_dynamic, expression slip_speed,
                                         expression viscous) {
    return {friction_kind::stribeck, mu_dynamic, mu_static, slip_speed, viscous};
  }
  static constexpr friction_law of_viscosity(expression viscous) {
    return {friction_kind::viscous, {}, {}, {}, viscous};
  }

  /// Dahl's law, with one state variable for each direction of slip: 1 in a joint or along a pathway, 2 in a
  /// contact with a plane, 3 in any other.
  static constexpr friction_law dahl(expression mu, expression stiffness, expression slip_speed,
                                     const sequence<expression>& deflections) {
    return {friction_kind::bristles, mu, {}, slip_speed, {}, {stiffness, {}, {}, deflections}};
  }
  /// The law of LuGre.
  static constexpr friction_law lugre(expression mu_static, expression mu_sliding, expression stribeck_speed,
                                      expression stiffness, expression damping, expression viscous,
                                      const sequence<expression>& deflections) {
    friction_law law{friction_kind::bristles,
                     mu_sliding,
                     mu_static,
                     {},
                     viscous,
                     {stiffness, damping, stribeck_speed, deflections}};
    law.take_slip_speed({});
    return law;
  }

  /// The same law with the rates of the coordinates replaced by speeds.
  template <class Motion>
  constexpr friction_law known_in(Motion& on) const {
    const auto known = [&](expression e) { return e.is_given() ? on.known(e) : e; };
    friction_law law{kind};
    law.sliding = known(sliding), law.sticking = known(sticking);
    law.slip_speed = slip_speed, law.viscous = known(viscous);
    law.bristles = bristles;
    return law;
  }

  /// Whether a coefficient of the law is missing; the viscous one may be omitted in addition to others.
  constexpr bool needs_coefficient() const {
    switch (kind) {
    case friction_kind::frictionless: return false;
    case friction_kind::viscous: return !viscous.is_given();
    case friction_kind::coulomb: return !sliding.is_given();
    case friction_kind::bristles: return !sliding.is_given() || !bristles.stiffness.is_given();
    case friction_kind::stribeck: return !sliding.is_given() || !sticking.is_given();
    }
    return false;
  }
  constexpr bool needs_slip_speed() const {
    const bool is_dry = kind != friction_kind::frictionless && kind != friction_kind::viscous;
    return is_dry && !slip_speed.is_given();
  }
  /// Takes the slip speed of a law that omits it. The default of LuGre's law is 1/1000 of its Stribeck speed.
  constexpr void take_slip_speed(expression by_default) {
    if (!needs_slip_speed()) return;
    slip_speed = bristles.stribeck_speed.is_given() ? bristles.stribeck_speed / 1000 : by_default;
  }
  constexpr bool has_bristles() const { return kind == friction_kind::bristles; }
  constexpr explicit operator bool() const { return kind != friction_kind::frictionless; }

  /// The friction force of bristles, for each direction of slip, and the rates of their deflections.
  constexpr moving_bristles move_bristles(expression normal_force, const sequence<expression>& slip) const {
    expression squared = slip[0] * slip[0];
    for (int i = 1; i < slip.size(); ++i) squared += slip[i] * slip[i];
    moving_bristles all = bristles.under(normal_force, slip, slip_speed, coefficient_of_bristles(squared));
    if (!viscous.is_given() || viscous.is_zero()) return all;
    const expression resistance = normal_force * viscous;
    for (int i = 0; i < slip.size(); ++i) all.force[i] -= resistance * slip[i];
    return all;
  }

  /// μ(v) of a scalar slip velocity; for bristles, that of steady slip, smoothed as Coulomb's law is.
  constexpr expression coefficient(expression slip) const {
    switch (kind) {
    case friction_kind::frictionless: break;
    case friction_kind::viscous: return viscous * slip;
    case friction_kind::bristles: return over_slip(slip * slip) * slip;
    case friction_kind::coulomb: return sliding * (slip / smoothed(slip * slip));
    case friction_kind::stribeck: {
      const expression relative = slip / slip_speed;
      const expression dry = sliding * tanh(4 * relative) + peak(relative * relative) * relative;
      return dry + viscous * slip;
    }
    }
    return slip.number(symbolic::exactly(0));
  }

  /// μ(v)/v as a function of v², for a slip vector v: the friction force is −N (μ(v)/v) v. It is smooth at
  /// v = 0.
  constexpr expression over_slip(expression squared_slip) const {
    switch (kind) {
    case friction_kind::frictionless: break;
    case friction_kind::viscous: return viscous;
    case friction_kind::bristles: {
      const expression dry = coefficient_of_bristles(squared_slip) / smoothed(squared_slip);
      return viscous.is_given() ? dry + viscous : dry;
    }
    case friction_kind::coulomb: return sliding / smoothed(squared_slip);
    case friction_kind::stribeck: {
      const expression relative = squared_slip / (slip_speed * slip_speed);
      const expression dry = 4 * sliding * detail::tanh_over_root(16 * relative) + peak(relative);
      return dry / slip_speed + viscous;
    }
    }
    return squared_slip.number(symbolic::exactly(0));
  }

  constexpr void check_with(load_check& by, std::string_view whose) const {
    check_numbers(by, whose);
    const auto part = [&](expression e, std::string_view name) {
      if (e.is_given()) by.check_no_speed_rates(e, name, whose);
    };
    part(sliding, "the coefficient of friction of ");
    part(sticking, "the coefficient of static friction of ");
    part(viscous, "the viscous coefficient of ");
    if (has_bristles()) check_bristles(by, whose);
    if (!slip_speed.is_given()) return;
    by.check_constant(slip_speed, "the slip speed of ", whose);
    by.check_positive(slip_speed, "the slip speed of ", whose);
  }

private:
  /// Reports numbers by which friction would drive the slip.
  constexpr void check_numbers(load_check& by, std::string_view whose) const {
    const auto part = [&](expression e, std::string_view name) {
      if (e.is_given()) by.check_not_negative(e, name, whose);
    };
    part(sliding, "the coefficient of friction of ");
    part(sticking, "the coefficient of static friction of ");
    part(viscous, "the viscous coefficient of ");
    if (!sticking.is_given() || !sliding.is_given()) return;
    const expression excess = sticking - sliding;
    if (excess.is_constant() && excess.owner().number_at(excess.node()).value() < 0)
      by.fail({"the coefficient of static friction of ", whose, " is less than that of sliding friction"});
  }
  constexpr void check_bristles(load_check& by, std::string_view whose) const {
    const mechanism& m = by.mechanism_used();
    for (const expression& z : bristles.deflections)
      if (m.speeds.find(z) < m.speeds_of_motion())
        return by.fail({"a bristle of ", whose, " is not a state variable"});
    const auto constant = [&](expression e, std::string_view name, bool is_positive) {
      if (!e.is_given()) return;
      by.check_constant(e, name, whose);
      if (is_positive) by.check_positive(e, name, whose);
    };
    constant(bristles.stiffness, "the stiffness of the bristles of ", true);
    constant(bristles.stribeck_speed, "the Stribeck speed of ", true);
    constant(bristles.damping, "the damping of the bristles of ", false);
    if (bristles.damping.is_given())
      by.check_not_negative(bristles.damping, "the damping of the bristles of ", whose);
    by.check_positive(sliding, "the coefficient of friction of ", whose);
    if (sticking.is_given()) by.check_positive(sticking, "the coefficient of static friction of ", whose);
  }

  /// μ_c + (μ_s − μ_c) exp(−(v/v_s)²)
  constexpr expression coefficient_of_bristles(expression squared_slip) const {
    if (!bristles.stribeck_speed.is_given()) return sliding;
    const expression square = bristles.stribeck_speed * bristles.stribeck_speed;
    const expression fading = exp(-(squared_slip / square)), excess = sticking - sliding;
    return sliding + excess * fading;
  }

  constexpr expression smoothed(expression squared_slip) const {
    return sqrt(squared_slip + slip_speed * slip_speed);
  }
  /// (μ_s − μ_d)/(z/4 + ¾)², the excess of static friction over relative slip, z being its square.
  constexpr expression peak(expression z) const {
    const expression width = (z + 3) / 4;
    return (sticking - sliding) / (width * width);
  }
};

} // namespace kanexpr::mechanics
