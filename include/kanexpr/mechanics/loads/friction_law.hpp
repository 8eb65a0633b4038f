#pragma once

#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/friction_kind.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
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
  expression sum = term(0);
  for (int i = 1; i < 7; ++i) sum = sum * z + term(i);
  const expression root = sqrt(z), ratio = tanh(root) / root;
  return symbolic::if_positive(z - z.number(symbolic::exactly(1, 100)), ratio, sum);
}

} // namespace detail

/// A law of friction. The friction force is −N μ(v), where N is the normal force and v the slip velocity, and
/// always opposes slip, so it only takes energy if N ≥ 0.
///
/// - Coulomb, smooth: μ(v) = μ v/√(v² + vₛ²), with the slip speed vₛ over which sticking is smoothed.
/// - Stribeck, after Brown & McPhee (2016), doi 10.1115/1.4033658: μ(v) = μ_d tanh(4 v/v_t) + (μ_s − μ_d)
///   (v/v_t)/((v/(2v_t))² + ¾)² + c v. The static coefficient μ_s is reached at the slip speed v_t.
/// - viscous: μ(v) = c v.
struct friction_law {
  friction_kind kind = friction_kind::frictionless;
  expression sliding{};    ///< μ or μ_d
  expression sticking{};   ///< μ_s
  expression slip_speed{}; ///< vₛ or v_t
  expression viscous{};    ///< c

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

  /// The same law with the rates of the coordinates replaced by speeds.
  template <class Motion>
  constexpr friction_law known_in(Motion& on) const {
    const auto known = [&](expression e) { return e.is_given() ? on.known(e) : e; };
    friction_law law{kind};
    law.sliding = known(sliding), law.sticking = known(sticking);
    law.slip_speed = slip_speed, law.viscous = known(viscous);
    return law;
  }

  constexpr bool needs_slip_speed() const {
    const bool is_dry = kind == friction_kind::coulomb || kind == friction_kind::stribeck;
    return is_dry && !slip_speed.is_given();
  }
  constexpr explicit operator bool() const { return kind != friction_kind::frictionless; }

  /// μ(v) of a scalar slip velocity.
  constexpr expression coefficient(expression slip) const {
    switch (kind) {
    case friction_kind::frictionless: break;
    case friction_kind::viscous: return viscous * slip;
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
    const auto part = [&](expression e, std::string_view name) {
      if (e.is_given()) by.check_no_speed_rates(e, name, whose);
    };
    part(sliding, "the coefficient of friction of ");
    part(sticking, "the coefficient of static friction of ");
    part(viscous, "the viscous coefficient of ");
    if (!slip_speed.is_given()) return;
    by.check_constant(slip_speed, "the slip speed of ", whose);
    by.check_positive(slip_speed, "the slip speed of ", whose);
  }

private:
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
