#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/negative.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/numeric/elementary.hpp>

#include <string_view>

/// Physically impossible inertias, as far as they are numbers.
namespace kanexpr::mechanics {

namespace detail {

struct numeric_inertia {
  double at[3][3]{};
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
    for (const auto& row : at)
      for (double e : row)
        if (numeric::elementary::abs(e) > most) most = numeric::elementary::abs(e);
    return most;
  }
  constexpr void scale(double by) {
    for (auto& row : at)
      for (double& e : row) e *= by;
  }
  /// Moves the inertia from its reference point, at r from the mass center, to the mass center.
  constexpr void move_to_center(double mass, const double (&r)[3]) {
    const double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) at[i][j] -= mass * ((i == j ? square : 0) - r[i] * r[j]);
  }
  constexpr double trace() const { return at[0][0] + at[1][1] + at[2][2]; }
  constexpr bool symmetric() const {
    for (int i = 0; i < 3; ++i)
      if (numeric::elementary::abs(at[i][(i + 1) % 3] - at[(i + 1) % 3][i]) > 1e-12) return false;
    return true;
  }
  /// Whether factor·I + shift·E is positive definite, by its leading minors.
  constexpr bool positive(double factor, double shift) const {
    double a[3][3]{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) a[i][j] = factor * at[i][j] + (i == j ? shift : 0);
    const double minor = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    const double whole = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
                         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    return a[0][0] > 0 && minor > 0 && whole > 0;
  }
};

/// Computes the vector from the mass center of a body to the reference point of its inertia; returns false if
/// the two points are not connected.
constexpr bool take_way(const mechanism& m, const body& b, vector& way) {
  sequence<int> above; // the mass center and the points from which it is offset
  for (int p = b.center; p != none; p = m.points[p].parent) above.push(p);
  int common = b.about;
  for (; common != none && !above.contains(common); common = m.points[common].parent)
    way.add(m.points[common].offset);
  if (common == none) return false;
  for (int p = b.center; p != common; p = m.points[p].parent) way.subtract(m.points[p].offset);
  return true;
}

/// The vector from the mass center of a body to the reference point of its inertia. It is known if it is
/// numeric in the axes of the inertia and the mass is a number.
struct numeric_way {
  bool known = false;
  double mass = 0;
  double r[3]{};

  constexpr numeric_way() = default;
  constexpr numeric_way(const mechanism& m, const body& b, int axes) {
    if (b.about == none || b.about == b.center || !b.mass.is_constant()) return;
    vector way;
    if (!take_way(m, b, way)) return;
    mass = m.g->number_at(b.mass.node()).value();
    for (const vector::part& p : way.parts)
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
                                                const numeric_way& way) {
  if (!inertia.positive(1, 1e-9))
    return base::sentence(
        {"the inertia of ", called, " is indefinite: its moment about some axis is negative"});
  constexpr double rounded = 2.5e-3; // admits a plate of zero thickness given with three digits
  const double whole = inertia.trace();
  bool is_given[3]{},
      is_planar = false; // in planar models only one moment matters, and the others are often left zero
  for (int i = 0; i < 3; ++i) {
    is_given[i] = numeric::elementary::abs(inertia.at[i][i]) > 1e-12;
    is_planar = is_planar || !is_given[i];
  }
  if (way.known) inertia.move_to_center(way.mass / largest, way.r);
  bool is_too_small = way.known && !is_planar && !inertia.positive(1, rounded * whole);
  for (int i = 0; i < 3; ++i)
    is_too_small = is_too_small || (way.known && is_given[i] && inertia.at[i][i] < -rounded * whole);
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
                                                const numeric_way& way) {
  return check_principal_values(b.called.view(), b.about == none ? "" : m.points[b.about].called.view(),
                                inertia, largest, way);
}

} // namespace detail

constexpr bool has_inertia(const body& b) {
  for (const dyadic::part& p : b.inertia.parts)
    for (int i = 0; i < 9; ++i)
      if (!p.value(i / 3, i % 3).is_zero()) return true;
  return false;
}

/// Checks that an inertia is positive about every axis and that no principal moment exceeds the sum of the
/// other two; otherwise a second moment of the mass, an eigenvalue of ½ tr(I) E − I, would be negative.
constexpr base::sentence check_inertia(const mechanism& m, const body& b) {
  if (b.inertia.parts.size() != 1 || b.inertia.parts[0].left != b.inertia.parts[0].right) return {};
  const matrix3& given = b.inertia.parts[0].value;
  const std::string_view called = b.called.view();
  for (int i = 0; i < 3; ++i)
    if (is_negative(given(i, i))) return base::sentence({"a moment of inertia of ", called, " is negative"});
  detail::numeric_inertia inertia(given);
  const double largest = inertia.known ? inertia.largest() : 0;
  if (!(largest > 1e-100)) return {};
  inertia.scale(1 / largest);
  if (!inertia.symmetric()) return base::sentence({"the inertia of ", called, " is not symmetric"});
  if (b.effective) return {};
  return detail::check_principal_values(m, b, inertia, largest,
                                        detail::numeric_way(m, b, b.inertia.parts[0].left));
}

} // namespace kanexpr::mechanics
