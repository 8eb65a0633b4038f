#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_lagrange.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

/// Checks that a Coriolis matrix formed from Christoffel symbols is valid.
namespace kanexpr::mechanics {

namespace detail {

inline constexpr wording_of_rates by_coriolis{", as the Coriolis matrix requires",
                                              "; the Coriolis matrix requires constant masses and inertias"};

/// Checks that the mass matrix depends only on coordinates whose rates are the speeds; otherwise Ṁ − 2C
/// cannot be skew-symmetric.
constexpr sentence check_changes_of_mass(const skeleton& s, const symbolic::matrix& mass) {
  const mechanism& m = *s.model;
  const contents held(*m.g);
  const auto changes_with = [&](const expression& symbol) {
    sequence<expression> changes;
    for (const expression& e : mass.entries)
      if (held.holds(e, m.g->symbol_at(symbol.node()).kind)) changes.push(symbolic::differentiate(e, symbol));
    return !vanish(m, changes);
  };
  const auto refused = [&](std::string_view what, std::string_view name = {}) {
    return sentence(
        {"the Coriolis matrix requires a mass matrix that depends only on coordinates; this one depends on ",
         what, name});
  };
  if (changes_with(m.time)) return refused("time");
  for (const expression& r : m.inputs)
    if (changes_with(r)) return refused("the prescribed quantity ", called(m, r));
  for (const expression& u : m.speeds)
    if (changes_with(u)) return refused("the ", speed_called(m, called(m, u)).view());
  for (int j = 0; j < m.coordinates.size(); ++j)
    if (!m.speeds.contains(s.coordinate_rates[j]) && changes_with(m.coordinates[j]))
      return refused(called(m, m.coordinates[j]), ", whose rate is not a speed");
  return {};
}

/// The part of the generalized inertia forces that is quadratic in the speeds, with the opposite sign.
constexpr sequence<expression> quadratic_part(const mechanism& m, const sequence<expression>& bias) {
  symbolic::substitution backwards(*m.g), at_rest(*m.g);
  for (const expression& u : m.speeds) {
    backwards.replace(u, -u);
    at_rest.replace(u, m.zero());
  }
  sequence<expression> quadratic;
  for (const expression& b : bias) {
    const expression constant = at_rest.in(b);
    quadratic.push(constant - (b + backwards.in(b)) / 2);
  }
  return quadratic;
}

/// Returns a message that explains why the equations of motion may differ from Lagrange's, whose C is formed
/// from Christoffel symbols; empty if they cannot.
constexpr sentence mismatch_with_lagrange(motion& k, const loads& acting) {
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  if (m.derived_by == method::lagrange) return {};
  if (const sentence found = lagrange_checker(k, acting, by_coriolis).run()) return found;
  for (int j = 0; j < m.coordinates.size(); ++j)
    if (!m.speeds.contains(s.coordinate_rates[j]))
      return sentence({"the Coriolis matrix requires the coordinate rates as speeds; the rate of ",
                       called(m, m.coordinates[j]), " is not a speed"});
  return {};
}

} // namespace detail

/// Returns a message that explains why the matrix `c` of Christoffel symbols is not a Coriolis matrix; empty
/// if it is one. Either M depends on more than the coordinates, or C u differs from the part of −F_r* at
/// u̇ = 0 that is quadratic in the speeds. `bias_of` forms that part and is called only in doubtful cases.
template <class Form>
constexpr sentence check_coriolis(motion& k, const loads& acting, const symbolic::matrix& mass,
                                  const symbolic::matrix& c, const Form& bias_of) {
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  if (const sentence found = detail::check_changes_of_mass(s, mass)) return found;
  const sentence candidate = detail::mismatch_with_lagrange(k, acting);
  if (!candidate) return {};
  sequence<expression> off = detail::quadratic_part(m, bias_of());
  off.resize(m.speeds.size(), m.zero()); // the auxiliary speeds come last
  for (int i = 0; i < c.rows; ++i)
    for (int j = 0; j < c.columns; ++j) off[i] -= c(i, j) * m.speeds[j];
  return detail::vanish(m, off) ? sentence() : candidate;
}

} // namespace kanexpr::mechanics
