#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/sizes/finiteness.hpp>

#include <string_view>

namespace kanexpr::mechanics {

namespace detail {

/// The rows or columns of a direction cosine matrix whose entries are numbers.
struct numeric_axes {
  triad axis{};
  bool known[3]{true, true, true};

  constexpr explicit numeric_axes(const numbers& rows) {
    for (int i = 0; i < 9; ++i) axis[i / 3][i % 3] = rows.entries[i];
  }
  constexpr explicit numeric_axes(const matrix3& rows) {
    for (int i = 0; i < 3; ++i) {
      known[i] = rows.row[i].is_constant();
      for (int k = 0; k < 3; ++k)
        if (const expression e = rows(i, k); e.is_constant())
          axis[i][k] = e.owner().number_at(e.node()).value();
    }
  }
  constexpr bool all_known() const { return known[0] && known[1] && known[2]; }
  /// The tolerance admits numbers written with six digits and still detects a wrong sign or order.
  constexpr bool orthonormal() const {
    for (int i = 0; i < 9; ++i)
      if (numeric::elementary::abs(axis[i / 3][i % 3]) > 2) return false; // the square might overflow
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        if (known[i] && known[j] && numeric::elementary::abs(dot(axis[i], axis[j]) - (i == j ? 1 : 0)) > 1e-6)
          return false;
    return true;
  }
  constexpr bool right_handed() const { return !all_known() || dot(axis.x, cross(axis.y, axis.z)) > 0; }
};

/// The values of expressions at generic states if the expressions depend only on angles; otherwise empty.
constexpr sequence<numbers> at_any_angles(const mechanism& m, const sequence<expression>& all, int rows) {
  if (!symbolic::depend_only_on_angles(*m.g, symbolic::nodes_of(all))) return {};
  symbolic::matrix a(*m.g, rows, all.size() / rows);
  a.entries = all;
  return at_generic_states(a, &m);
}

/// Checks the length of a quaternion whose entries are numbers or functions of angles. If the entries are
/// coordinates, the state is normalized instead.
constexpr bool has_unit_length(const mechanism& m, const sequence<expression>& quaternion) {
  for (const numbers& e : at_any_angles(m, quaternion, 1)) {
    double square = 0;
    for (int i = 0; i < 4; ++i) {
      if (numeric::elementary::abs(e(0, i)) > 2) return false; // the square might overflow
      square += e(0, i) * e(0, i);
    }
    if (!(numeric::elementary::abs(square - 1) < 1e-6)) return false;
  }
  return true;
}

} // namespace detail

/// Checks that direction cosines that are numbers or functions of angles form a rotation, and that the length
/// of an axis is within range.
constexpr base::sentence check_direction_cosines(const mechanism& m, const frame& f) {
  if (f.kind == orientation::about_axis && f.direction.is_constant()) {
    const symbolic::graph& g = f.direction.x.owner();
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const symbolic::number n = g.number_at(f.direction[i].node());
      if (symbolic::is_finite(n)) square += n.value() * n.value();
    }
    if (!(numeric::elementary::abs(square - 1) < 1e-6))
      return base::sentence(
          {"the axis of frame ", f.called.view(), " is too long or too short to be normalized"});
  }
  if (f.kind != orientation::matrix) return {};
  const std::string_view called = f.called.view();
  const detail::numeric_axes rows(f.to_parent), columns(transpose(f.to_parent));
  const bool orthonormal = rows.orthonormal() && columns.orthonormal();
  if (!f.quaternion.empty()) {
    if (orthonormal && detail::has_unit_length(m, f.quaternion)) return {};
    return base::sentence({"the quaternion of frame ", called, " does not have unit length"});
  }
  if (!orthonormal)
    return base::sentence({"the direction cosines of frame ", called,
                           " are not orthonormal; write irrational entries as sqrt or cos of numbers"});
  bool right_handed = rows.right_handed();
  if (!rows.all_known()) {
    sequence<expression> cosines;
    for (int i = 0; i < 9; ++i) cosines.push(f.to_parent(i / 3, i % 3));
    for (const numbers& state : detail::at_any_angles(m, cosines, 3)) {
      const detail::numeric_axes turned(state);
      if (!turned.orthonormal())
        return base::sentence({"the direction cosines of frame ", called, " are not orthonormal"});
      right_handed = right_handed && turned.right_handed();
    }
  }
  if (!right_handed)
    return base::sentence(
        {"the direction cosines of frame ", called, " are not right-handed: they describe a reflection"});
  return {};
}

} // namespace kanexpr::mechanics
