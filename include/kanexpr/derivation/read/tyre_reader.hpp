#pragma once

#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/derivation/read/wheel_reader.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/describe/tyre_record.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/loads/tyre.hpp>
#include <kanexpr/mechanics/loads/tyre_law.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads tyres.
class tyre_reader : load_parts {
public:
  constexpr explicit tyre_reader(const load_parts& by) : load_parts(by) {}

  constexpr void read(const describe::tyre_record& r) {
    if (!r.mistake.empty()) return reading_.fail({whom, " ", r.mistake});
    mechanics::tyre t;
    t.wheel = wheel_reader(*this).read(*r.wheel);
    read_law(t.law, r);
    t.load = given(r.load, "the load of ");
    t.radial.stiffness = given(r.stiffness, "the radial stiffness of ");
    t.radial.width = given(r.width, "the width of ");
    t.radial.damping = given(r.damping, "the radial damping of ");
    t.radial.exponent = m_.one();
    t.standstill = given(r.standstill, "the speed of standstill of ");
    t.effective_radius = given(r.effective_radius, "the effective radius of ");
    if (r.forward_length.tokens != nullptr) read_relaxation(t.relaxation, r);
    if (!reading_.mistake) into.add(t);
  }

private:
  constexpr expression given(const phrase& p, std::string_view what) {
    if (p.tokens == nullptr && p.kind == shape::nothing) return {};
    return scalar(p, what);
  }
  constexpr expression given_or_zero(const phrase& p, std::string_view what) {
    const expression value = given(p, what);
    return value.is_given() ? value : m_.zero();
  }

  constexpr void read_law(mechanics::tyre_law& law, const describe::tyre_record& r) {
    law.model = r.model;
    if (r.model == mechanics::tyre_model::magic_formula) {
      law.formula.push({});
      return read_coefficients(law.formula[0], *r.formula);
    }
    const auto elastic = [&](auto& of) {
      of.slip_stiffness = given(r.slip_stiffness, "the slip stiffness of ");
      of.cornering_stiffness = given(r.cornering_stiffness, "the cornering stiffness of ");
      of.camber_stiffness = given_or_zero(r.camber_stiffness, "the camber stiffness of ");
      of.trail = given_or_zero(r.trail, "the pneumatic trail of ");
    };
    if (r.model == mechanics::tyre_model::linear) return elastic(law.linear);
    law.brush.friction = given(r.friction, "the coefficient of friction of ");
    elastic(law.brush);
  }

  constexpr void read_coefficients(mechanics::tyre_law::coefficients& all, const tyre_coefficients& from) {
    mechanics::tyre_law::coefficients::each_coefficient(all, [&](auto&... to) {
      tyre_coefficients::each_coefficient(from, [&](const auto&... c) { ((to = coefficient(c, 0)), ...); });
    });
    mechanics::tyre_law::coefficients::each_factor(all, [&](auto&... to) {
      tyre_coefficients::each_factor(from, [&](const auto&... c) { ((to = coefficient(c, 1)), ...); });
    });
    if (reading_.mistake) return;
    const std::string_view missing = mechanics::missing_coefficient(all);
    if (!missing.empty()) reading_.fail({whom, " has a magic formula without the coefficient ", missing});
  }

  constexpr expression coefficient(const describe::tyre_coefficient& c, double omitted) {
    if (c.symbol.tokens != nullptr) return scalar(c.symbol, "a coefficient of ");
    const double value = c.is_given ? c.number : omitted;
    if (!symbolic::is_finite(value)) reading_.fail({"a coefficient of ", whom, " is not finite"});
    return m_.one().number(symbolic::real(value));
  }

  constexpr void read_relaxation(mechanics::tyre_relaxation& lag, const describe::tyre_record& r) {
    lag.forward_length = given(r.forward_length, "a relaxation length of ");
    lag.lateral_length = given(r.lateral_length, "a relaxation length of ");
    const expression forward = given(r.forward_deflection, "a deflection of ");
    const expression lateral = given(r.lateral_deflection, "a deflection of ");
    if (reading_.mistake) return;
    lag.forward = m_.speeds.find(forward), lag.lateral = m_.speeds.find(lateral);
    for (const int speed : {lag.forward, lag.lateral}) into.state_rates.push({speed, {}, {}});
  }
};

constexpr void read_tyre(load_parts& by) { tyre_reader(by).read(*by.record.tyre); }

/// A quantity of the only load, a tyre.
constexpr value observe_tyre(describe::load_quantity wanted, const mechanics::loads& alone,
                             mechanics::observed_motion& on) {
  const mechanics::tyre t = alone.all<mechanics::tyre>()[0];
  switch (wanted) {
  case describe::load_quantity::normal_force: return value::of(t.slip(on).load);
  case describe::load_quantity::longitudinal_force: return value::of(t.effort(on).forward);
  case describe::load_quantity::lateral_force: return value::of(t.effort(on).lateral);
  case describe::load_quantity::aligning_moment: return value::of(t.effort(on).aligning);
  case describe::load_quantity::longitudinal_slip: return value::of(t.slip(on).forward);
  case describe::load_quantity::lateral_slip: return value::of(-t.slip(on).lateral);
  case describe::load_quantity::camber: return value::of(t.slip(on).camber);
  case describe::load_quantity::length:
  case describe::load_quantity::penetration:
  case describe::load_quantity::tension:
  case describe::load_quantity::friction_force:
  case describe::load_quantity::contact_force:
  case describe::load_quantity::contact_place:
  case describe::load_quantity::lowest_point: break;
  }
  return {};
}

} // namespace kanexpr::derivation
