#pragma once

#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/wheel_reader.hpp>
#include <kanexpr/describe/tyre_record.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/loads/tyre.hpp>
#include <kanexpr/mechanics/loads/tyre_law.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads tyres.
class tyre_reader : part_reader {
public:
  using part_reader::part_reader;

  constexpr void read(mechanics::loads& into, const describe::tyre_record& r, std::string_view whom) {
    if (!r.mistake.empty()) return reading_.fail({whom, " ", r.mistake});
    mechanics::tyre t;
    t.wheel = wheel_reader(reading_, symbols_, phrases_, entities_).read(*r.wheel, whom);
    read_law(t.law, r, whom);
    t.load = given(r.load, "the load of ", whom);
    t.radial.stiffness = given(r.stiffness, "the radial stiffness of ", whom);
    t.radial.width = given(r.width, "the width of ", whom);
    t.radial.damping = given(r.damping, "the radial damping of ", whom);
    t.radial.exponent = m_.one();
    t.standstill = given(r.standstill, "the speed of standstill of ", whom);
    t.effective_radius = given(r.effective_radius, "the effective radius of ", whom);
    if (r.forward_length.tokens != nullptr) read_relaxation(into, t.relaxation, r, whom);
    if (!reading_.mistake) into.tyres.push(t);
  }

private:
  constexpr expression given(const phrase& p, std::string_view what, std::string_view whom) {
    if (p.tokens == nullptr && p.kind == shape::nothing) return {};
    return phrases_.scalar_of(p, {what, whom}, whom);
  }
  constexpr expression given_or_zero(const phrase& p, std::string_view what, std::string_view whom) {
    const expression value = given(p, what, whom);
    return value.is_given() ? value : m_.zero();
  }

  constexpr void read_law(mechanics::tyre_law& law, const describe::tyre_record& r, std::string_view whom) {
    law.model = r.model;
    if (r.model == mechanics::tyre_model::magic_formula) {
      law.formula.push({});
      return read_coefficients(law.formula[0], *r.formula, whom);
    }
    const auto elastic = [&](auto& of) {
      of.slip_stiffness = given(r.slip_stiffness, "the slip stiffness of ", whom);
      of.cornering_stiffness = given(r.cornering_stiffness, "the cornering stiffness of ", whom);
      of.camber_stiffness = given_or_zero(r.camber_stiffness, "the camber stiffness of ", whom);
      of.trail = given_or_zero(r.trail, "the pneumatic trail of ", whom);
    };
    if (r.model == mechanics::tyre_model::linear) return elastic(law.linear);
    law.brush.friction = given(r.friction, "the coefficient of friction of ", whom);
    elastic(law.brush);
  }

  constexpr void read_coefficients(mechanics::tyre_law::coefficients& into, const tyre_coefficients& from,
                                   std::string_view whom) {
    mechanics::tyre_law::coefficients::each_coefficient(into, [&](auto&... to) {
      tyre_coefficients::each_coefficient(from,
                                          [&](const auto&... c) { ((to = coefficient(c, 0, whom)), ...); });
    });
    mechanics::tyre_law::coefficients::each_factor(into, [&](auto&... to) {
      tyre_coefficients::each_factor(from, [&](const auto&... c) { ((to = coefficient(c, 1, whom)), ...); });
    });
    if (reading_.mistake) return;
    const std::string_view missing = mechanics::missing_coefficient(into);
    if (!missing.empty()) reading_.fail({whom, " has a magic formula without the coefficient ", missing});
  }

  constexpr expression coefficient(const describe::tyre_coefficient& c, double omitted,
                                   std::string_view whom) {
    if (c.symbol.tokens != nullptr) return phrases_.scalar_of(c.symbol, {"a coefficient of ", whom}, whom);
    const double value = c.is_given ? c.number : omitted;
    if (!symbolic::is_finite(value)) reading_.fail({"a coefficient of ", whom, " is not finite"});
    return m_.one().number(symbolic::real(value));
  }

  constexpr void read_relaxation(mechanics::loads& into, mechanics::tyre_relaxation& lag,
                                 const describe::tyre_record& r, std::string_view whom) {
    lag.forward_length = given(r.forward_length, "a relaxation length of ", whom);
    lag.lateral_length = given(r.lateral_length, "a relaxation length of ", whom);
    const expression forward = given(r.forward_deflection, "a deflection of ", whom);
    const expression lateral = given(r.lateral_deflection, "a deflection of ", whom);
    if (reading_.mistake) return;
    lag.forward = m_.speeds.find(forward), lag.lateral = m_.speeds.find(lateral);
    for (const int speed : {lag.forward, lag.lateral}) into.state_rates.push({speed, {}, {}});
  }
};

} // namespace kanexpr::derivation
