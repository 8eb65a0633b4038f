#pragma once

#include <kanexpr/mechanics/mechanism.hpp>
#include <kanexpr/mechanics/problem.hpp>
#include <kanexpr/symbolic/elementary.hpp>

namespace kanexpr::mechanics {

namespace detail {

/// The rows, or columns, of a matrix of direction cosines that are numbers.
struct numeric_axes {
  double entry[3][3]{};
  bool known[3]{};

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
  /// Six digits of numbers that were written down, and no sign or order that is wrong.
  constexpr bool orthonormal() const {
    for (const auto& axis : entry)
      for (double e : axis)
        if (symbolic::elementary::abs(e) > 2) return false; // whose square might overflow
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        if (known[i] && known[j] && symbolic::elementary::abs(dot(i, j) - (i == j ? 1 : 0)) > 1e-6)
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

} // namespace detail

/// Direction cosines, as far as they are numbers, that turn nothing; an axis whose length is not within
/// range.
constexpr problem check_direction_cosines(const frame& f) {
  if (f.kind == orientation::about_axis && f.direction.is_constant()) {
    const symbolic::graph& g = f.direction.x.owner();
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const symbolic::number n = g.number_at(f.direction[i].node());
      if (symbolic::is_finite(n)) square += n.value() * n.value();
    }
    if (!(symbolic::elementary::abs(square - 1) < 1e-6))
      return sentence(
          {"the axis of frame ", f.called.view(), " has a length that is too large or too small"});
  }
  if (f.kind != orientation::matrix) return {};
  const detail::numeric_axes rows(f.to_parent, false), columns(f.to_parent, true);
  if (!rows.orthonormal() || !columns.orthonormal()) {
    if (!f.quaternion.empty())
      return sentence({"the quaternion of frame ", f.called.view(), " does not have unit length"});
    return sentence({"the direction cosines of frame ", f.called.view(),
                     " are not orthonormal; write what is not rational as sqrt or cos of numbers"});
  }
  if (!rows.right_handed())
    return sentence(
        {"the direction cosines of frame ", f.called.view(), " are not right-handed: they mirror"});
  return {};
}

} // namespace kanexpr::mechanics
