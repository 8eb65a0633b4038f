#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks for physically impossible inertias, to the extent that their values are known.
namespace kanexpr::mechanics {

namespace detail {

/// Whether a node is positive for positive parameters; handles sums, products, quotients, powers and similar
/// operations.
constexpr bool is_positive(const graph& g, int id) {
  using symbolic::form;
  const symbolic::node& n = g[id];
  switch (symbolic::form_of(n.op)) {
  case form::leaf:
    return g.is_constant(id) ? g.number_at(id).value() > 0
                             : g.symbol_at(id).kind == symbolic::symbol_kind::parameter;
  case form::add:
  case form::multiply:
  case form::divide: return is_positive(g, n.a) && (n.a == n.b || is_positive(g, n.b));
  case form::power: return is_positive(g, n.a);
  case form::function: return symbolic::properties_of(n.op).never_negative;
  case form::negate:
  case form::subtract:
  case form::binary_function:
  case form::selection:
  case form::list_operation: break;
  }
  return false;
}

} // namespace detail

/// Whether a scalar is negative as a number, or for all positive parameters, such as -2*m.
constexpr bool is_negative(expression e) {
  const graph& g = e.owner();
  if (e.is_constant()) return g.number_at(e.node()).negative();
  const symbolic::node& n = g[e.node()];
  return n.op == symbolic::operation::negate && detail::is_positive(g, n.a);
}

namespace detail {

/// A numeric inertia; `known` is false if the inertia contains symbols.
struct numeric_inertia {
  triad at{};
  bool known = true;

  constexpr numeric_inertia() = default;
  constexpr explicit numeric_inertia(const matrix3& m) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        known = known && m(i, j).is_constant();
        if (known) at[i][j] = m(i, j).owner().number_at(m(i, j).node()).value();
      }
  }
  constexpr double largest() const {
    double most = 0;
    for (int i = 0; i < 9; ++i)
      if (const double size = numeric::elementary::abs(at[i / 3][i % 3]); size > most) most = size;
    return most;
  }
  constexpr void scale(double by) { at = by * at; }
  /// Moves the inertia from its reference point, at r from the mass center, to the mass center.
  constexpr void move_to_center(double mass, triple r) {
    at = at + -mass * (diagonal(dot(r, r)) + -1.0 * outer(r, r));
  }
  constexpr double trace() const { return at.x.x + at.y.y + at.z.z; }
  constexpr bool is_symmetric(double tolerance) const {
    for (int i = 0; i < 3; ++i)
      if (numeric::elementary::abs(at[i][(i + 1) % 3] - at[(i + 1) % 3][i]) > tolerance) return false;
    return true;
  }
  /// Whether factor·I + shift·E is positive definite, by its leading minors.
  constexpr bool positive(double factor, double shift) const {
    const triad a = factor * at + diagonal(shift);
    return a.x.x > 0 && a.x.x * a.y.y - a.x.y * a.y.x > 0 && dot(a.x, cross(a.y, a.z)) > 0;
  }
};

/// Computes the vector from the mass center of a body to the reference point of its inertia; returns false if
/// the two points are not connected.
constexpr bool find_offset(const mechanism& m, const body& b, vector& offset) {
  sequence<int> above; // the mass center and the points from which it is offset
  for (int p = b.center; p != none; p = m.points[p].parent) above.push(p);
  int common = b.about;
  for (; common != none && !above.contains(common); common = m.points[common].parent)
    offset.add(m.points[common].offset);
  if (common == none) return false;
  for (int p = b.center; p != common; p = m.points[p].parent) offset.subtract(m.points[p].offset);
  return true;
}

/// The vector from the mass center of a body to the reference point of its inertia. It is known if it is
/// numeric in the axes of the inertia and the mass is a number.
struct numeric_offset {
  bool known = false;
  double mass = 0;
  triple r{};

  constexpr numeric_offset() = default;
  constexpr numeric_offset(const mechanism& m, const body& b, int axes) {
    vector offset;
    if (!b.is_off_center() || !b.mass.is_constant() || !find_offset(m, b, offset)) return;
    mass = m.g->number_at(b.mass.node()).value();
    for (const vector::part& p : offset.parts)
      for (int i = 0; i < 3 && !p.value.is_zero(); ++i) {
        if (p.frame != axes || !p.value[i].is_constant()) return;
        r[i] = m.g->number_at(p.value[i].node()).value();
        if (numeric::elementary::abs(r[i]) > 1e30) return; // the square might overflow
      }
    known = mass < 1e30;
  }
};

/// Checks an inertia about the mass center or another point, scaled by 1/`largest` so that its largest entry
/// is 1.
constexpr base::sentence check_principal_values(std::string_view called, std::string_view about,
                                                numeric_inertia inertia, double largest,
                                                const numeric_offset& offset) {
  if (!inertia.positive(1, 1e-9))
    return base::sentence(
        {"the inertia of ", called, " is indefinite: its moment about some axis is negative"});
  constexpr double rounded = 2.5e-3; // admits a plate of zero thickness given to three digits
  const double whole = inertia.trace();
  bool is_given[3]{},
      is_planar = false; // in planar models only one moment matters, and the others are often left zero
  for (int i = 0; i < 3; ++i) {
    is_given[i] = numeric::elementary::abs(inertia.at[i][i]) > 1e-12;
    is_planar = is_planar || !is_given[i];
  }
  if (offset.known) inertia.move_to_center(offset.mass / largest, offset.r);
  bool is_too_small = offset.known && !is_planar && !inertia.positive(1, rounded * whole);
  for (int i = 0; i < 3; ++i)
    is_too_small = is_too_small || (offset.known && is_given[i] && inertia.at[i][i] < -rounded * whole);
  if (is_too_small)
    return base::sentence(
        {"the inertia of ", called, " about ", about, " is smaller than the parallel-axis term of its mass"});
  if (!is_planar && !inertia.positive(-1, 0.5 * inertia.trace() + rounded * whole))
    return base::sentence(
        {"the inertia of ", called,
         " is not physical: one principal moment exceeds the sum of the other two; if this is "
         "intended, wrap it in effective_inertia<...>"});
  return {};
}

constexpr base::sentence check_principal_values(const mechanism& m, const body& b,
                                                const numeric_inertia& inertia, double largest,
                                                const numeric_offset& offset) {
  return check_principal_values(b.called.view(), b.about == none ? "" : m.points[b.about].called.view(),
                                inertia, largest, offset);
}

} // namespace detail

constexpr bool has_inertia(const body& b) {
  bool found = false;
  b.inertia.each_entry([&](expression e) { found = found || !e.is_zero(); });
  return found;
}

/// Checks that an inertia is positive about every axis and that no principal moment exceeds the sum of the
/// other two; otherwise a second moment of the mass, an eigenvalue of ½ tr(I) E − I, would be negative.
constexpr base::sentence check_inertia(const mechanism& m, const body& b) {
  if (!b.inertia.is_in_one_frame()) return {};
  const matrix3& given = b.inertia.parts[0].value;
  const std::string_view called = b.called.view();
  for (int i = 0; i < 3; ++i)
    if (is_negative(given(i, i))) return base::sentence({"a moment of inertia of ", called, " is negative"});
  detail::numeric_inertia inertia(given);
  const double largest = inertia.known ? inertia.largest() : 0;
  if (!(largest > 1e-100)) return {};
  inertia.scale(1 / largest);
  if (!inertia.is_symmetric(1e-12)) return base::sentence({"the inertia of ", called, " is not symmetric"});
  if (b.effective) return {};
  return detail::check_principal_values(m, b, inertia, largest,
                                        detail::numeric_offset(m, b, b.inertia.parts[0].left));
}

} // namespace kanexpr::mechanics
