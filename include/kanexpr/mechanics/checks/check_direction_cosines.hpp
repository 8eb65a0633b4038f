#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <string_view>

namespace kanexpr::mechanics {

namespace detail {

/// The rows or columns of a direction cosine matrix whose entries are numbers.
struct numeric_axes {
  double entry[3][3]{};
  bool known[3]{};

  constexpr explicit numeric_axes(const numbers& rows) {
    for (int i = 0; i < 9; ++i) entry[i / 3][i % 3] = rows.entries[i], known[i / 3] = true;
  }
  constexpr numeric_axes(const matrix3& m, bool columns) {
    for (int i = 0; i < 3; ++i) {
      known[i] = true;
      for (int k = 0; k < 3; ++k) {
        const expression e = columns ? m(k, i) : m(i, k);
        known[i] = known[i] && e.is_constant();
        if (e.is_constant()) entry[i][k] = m(0, 0).owner().number_at(e.node()).value();
      }
    }
  }
  constexpr double dot(int i, int j) const {
    return entry[i][0] * entry[j][0] + entry[i][1] * entry[j][1] + entry[i][2] * entry[j][2];
  }
  /// The tolerance admits numbers written with six digits and still detects a wrong sign or order.
  constexpr bool orthonormal() const {
    for (const auto& axis : entry)
      for (double e : axis)
        if (numeric::elementary::abs(e) > 2) return false; // the square might overflow
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        if (known[i] && known[j] && numeric::elementary::abs(dot(i, j) - (i == j ? 1 : 0)) > 1e-6)
          return false;
    return true;
  }
  constexpr bool right_handed() const {
    if (!known[0] || !known[1] || !known[2]) return true;
    double volume = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      volume += entry[0][i] * (entry[1][j] * entry[2][k] - entry[1][k] * entry[2][j]);
    }
    return volume > 0;
  }
};

/// Whether an expression contains symbols only as arguments of sines and cosines, so that it must be valid at
/// any angle.
constexpr bool holds_angles_only(const symbolic::graph& g, int id, sequence<int>& seen) {
  using symbolic::operation;
  const symbolic::node& n = g[id];
  if (n.op == operation::constant || n.op == operation::sin || n.op == operation::cos) return true;
  if (symbolic::is_leaf(n.op)) return false;
  if (seen.contains(id)) return true;
  seen.push(id);
  return holds_angles_only(g, n.a, seen) && (!symbolic::is_binary(n.op) || holds_angles_only(g, n.b, seen));
}

/// The values of expressions at generic states, if they must be valid at any angle; otherwise empty.
constexpr sequence<numbers> at_any_angles(const mechanism& m, const sequence<expression>& all, int rows) {
  sequence<int> seen;
  for (const expression& e : all)
    if (!holds_angles_only(*m.g, e.node(), seen)) return {};
  symbolic::matrix a(*m.g, rows, all.size() / rows);
  a.entries = all;
  return at_generic_states(a, &m);
}

/// Checks the length of a quaternion of numbers and functions of angles. If the entries are coordinates, the
/// state is normalized instead.
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
  const detail::numeric_axes rows(f.to_parent, false), columns(f.to_parent, true);
  const bool orthonormal = rows.orthonormal() && columns.orthonormal();
  if (!f.quaternion.empty()) {
    if (orthonormal && detail::has_unit_length(m, f.quaternion)) return {};
    return base::sentence({"the quaternion of frame ", called, " does not have unit length"});
  }
  if (!orthonormal)
    return base::sentence({"the direction cosines of frame ", called,
                           " are not orthonormal; write irrational entries as sqrt or cos of numbers"});
  bool right_handed = rows.right_handed();
  if (!rows.known[0] || !rows.known[1] || !rows.known[2]) {
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
