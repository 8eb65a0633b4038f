#pragma once

#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/magic_formula.hpp>
#include <kanexpr/mechanics/loads/observed_motion.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/loads/tyre.hpp>
#include <kanexpr/mechanics/loads/tyre_law.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>
#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/building/tyre_builder.hpp>
#include <kanexpr/runtime/building/tyre_data.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::runtime {

KANEXPR_ENGINE expression tyre_builder::value_of(const tyre_data::value& given) {
  if (!given) return {};
  const expression e = as_nonzero(*given, "a value of a tyre");
  checks_.owns("a tyre", e);
  return e;
}

KANEXPR_ENGINE mechanics::tyre_law tyre_builder::law_of(const tyre_data& data) {
  mechanics::tyre_law law;
  law.model = data.model;
  if (law.model == mechanics::tyre_model::magic_formula) {
    using coefficients = mechanics::tyre_law::coefficients;
    law.formula.push({});
    const auto set = [&](expression& to, const tyre_data::value& given, double omitted) {
      const bool is_zero = given && given->is_whole_zero(); // in tables of coefficients, 0 is usual
      to = given && !is_zero ? value_of(given) : m_.number(is_zero ? 0 : omitted);
    };
    coefficients::each_coefficient(law.formula[0], [&](auto&... to) {
      tyre_data::coefficients::each_coefficient(data.formula, [&](auto&... c) { (set(to, c, 0), ...); });
    });
    coefficients::each_factor(law.formula[0], [&](auto&... to) {
      tyre_data::coefficients::each_factor(data.formula, [&](auto&... c) { (set(to, c, 1), ...); });
    });
    const std::string_view missing = mechanics::missing_coefficient(law.formula[0]);
    if (!missing.empty()) checks_.fail({"a tyre has a magic formula without the coefficient ", missing});
    return law;
  }
  if (!data.slip_stiffness || !data.cornering_stiffness)
    checks_.fail({"a tyre has no ", data.slip_stiffness ? "cornering" : "slip", " stiffness"});
  if (law.model == mechanics::tyre_model::brush && !data.friction)
    checks_.fail({"a tyre has no coefficient of friction"});
  const auto or_zero = [&](const tyre_data::value& given) { return given ? value_of(given) : m_.zero(); };
  const auto set_elastic = [&](auto& to) {
    to.slip_stiffness = or_zero(data.slip_stiffness);
    to.cornering_stiffness = or_zero(data.cornering_stiffness);
    to.camber_stiffness = or_zero(data.camber_stiffness);
    to.trail = or_zero(data.trail);
  };
  set_elastic(law.linear);
  set_elastic(law.brush);
  law.brush.friction = or_zero(data.friction);
  return law;
}

KANEXPR_ENGINE void tyre_builder::tyre(const wheel_on_ground& wheel, const tyre_data& data) {
  if (has_mistake() || !owns_wheel("a tyre", wheel)) return;
  mechanics::tyre t;
  t.wheel = wheel, t.law = law_of(data);
  t.load = value_of(data.load), t.standstill = value_of(data.standstill);
  t.effective_radius = value_of(data.effective_radius);
  if (!data.standstill) checks_.fail({"a tyre has no speed of standstill"});
  if (data.load && data.radial) checks_.fail({"a tyre has both a load and a radial stiffness"});
  if (t.law.needs_load() && !data.load && !data.radial) checks_.fail({"a tyre has no load"});
  if (data.radial) {
    t.radial.stiffness = value_of(data.radial->stiffness);
    t.radial.damping = value_of(data.radial->damping);
    t.radial.width = value_of(data.radial->width);
    t.radial.exponent = m_.one();
  }
  if (data.relaxation) {
    t.relaxation.forward_length = value_of(data.relaxation->forward_length);
    t.relaxation.lateral_length = value_of(data.relaxation->lateral_length);
    t.relaxation.forward = deflection(data.relaxation->forward_deflection);
    t.relaxation.lateral = deflection(data.relaxation->lateral_deflection);
  }
  if (!checks_.mistake()) system_.loads.add(t);
}

KANEXPR_ENGINE tyre_forces tyre_builder::forces_of_tyre(int tyre, mechanics::known_motion& known) {
  const auto& all = system_.loads.all<mechanics::tyre>();
  const int tyres = all.size();
  const bool is_known = known.skeleton_used().model == &m_;
  if (tyre < 1 || tyre > tyres)
    checks_.fail({"the forces of tyre ", base::counted(tyre).view(),
                  " are requested, but the number of tyres is ", base::counted(tyres).view()});
  else if (!is_known)
    checks_.fail({"the forces of a tyre are requested for the motion of a different builder"});
  if (tyre < 1 || tyre > tyres || !is_known) {
    const expression none = m_.zero();
    return {none, none, none, none, none, none, none};
  }
  mechanics::observed_motion on(known.moving());
  const mechanics::tyre& of = all[tyre - 1];
  const mechanics::tyre_slip slip = of.slip(on);
  const mechanics::tyre_effort f = of.effort(on);
  return {slip.load, f.forward, f.lateral, f.aligning, slip.forward, -slip.lateral, slip.camber};
}

KANEXPR_ENGINE int tyre_builder::deflection(expression state_variable) {
  const int speed = state_variable.belongs_to(*m_.g) ? m_.speeds.find(state_variable) : -1;
  if (speed < m_.speeds_of_motion())
    checks_.fail({"a deflection of a tyre is not a state variable"});
  else
    system_.loads.state_rates.push({speed, {}, {}});
  return speed;
}

} // namespace kanexpr::runtime
