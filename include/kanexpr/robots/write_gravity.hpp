#pragma once

#include <kanexpr/robots/header_draft.hpp>

#include <cmath>
#include <string>

/// Gravity in the header of a robot, and the potential energies that cancel it on weightless bodies.
namespace kanexpr::robots {

namespace detail {

/// The free-fall acceleration, as an expression.
inline std::string free_fall(header_draft& draft) {
  const vector3 g = gravity_of(draft.source, draft.options), to = direction_of_gravity(g);
  const std::string size = draft.value("g", std::hypot(g[0], g[1], g[2]));
  const bool numbers = draft.options.bind == binding::numbers;
  if (numbers && is_zero(g)) return header_text::along("N", {});
  if (to == vector3{0, 0, -1}) return "-" + size + " * N::z";
  return numbers ? header_text::along("N", g)
                 : size + " * " + header_text::factor(header_text::along("N", to));
}

/// A potential energy that cancels gravity on a weightless body, so that energy is conserved.
inline std::string energy_of_lifting(header_draft& draft, const moving_body& b, const std::string& gravity) {
  const std::string &on = draft.type(b.link), called = draft.name(b.link) + "_weightless";
  const std::string symbols =
      b.is_weightless() ? draft.name(b.link) : called; // existing ones if the whole body is weightless
  const auto known = draft.values.size();
  const std::string mass = draft.value("m_" + symbols, b.weightless);
  const std::string at = draft.options.bind == binding::numbers
                             ? header_text::along(on, b.weightless_center)
                             : draft.symbols_along(on, symbols, b.weightless_center);
  if (b.is_weightless()) draft.values.resize(known);
  draft.write_struct(called, "offset", {on, at});
  return mass + " * dot(" + gravity + ", position_of<" + called + ", N>)";
}

} // namespace detail

/// Adds gravity as the first load, and the energies of the weightless bodies as the last.
inline void write_gravity(header_draft& draft) {
  const model_options& options = draft.options;
  const std::string gravity = detail::free_fall(draft);
  draft.loads.insert(draft.loads.begin(), "gravity<" + gravity + ">");
  if (options.bind == binding::numbers && is_zero(gravity_of(draft.source, options))) return;
  std::string lifting;
  for (const moving_body& b : draft.plan.what.bodies)
    if (b.weightless > 0 && !(b.joint < 0 && options.base == base_kind::fixed))
      lifting += (lifting.empty() ? "" : " + ") + detail::energy_of_lifting(draft, b, gravity);
  if (!lifting.empty())
    draft.loads.push_back("potential_energy<" + lifting + ">"); // one sum: wheels have equal terms
}

} // namespace kanexpr::robots
