#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/check_inertia.hpp>
#include <kanexpr/mechanics/dynamics/positive_mass.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>

#include <string_view>

/// Checks of flexible bodies.
namespace kanexpr::mechanics {

/// Reports an amplitude that is not a coordinate, or that is also an amplitude of another body among the
/// first `others` flexible bodies.
constexpr sentence check_amplitudes(const mechanism& m, std::string_view body,
                                    const sequence<expression>& amplitudes, int others) {
  for (int k = 0; k < amplitudes.size(); ++k) {
    if (!m.coordinates.contains(amplitudes[k]))
      return sentence({"amplitude ", base::counted(k + 1).view(), " of ", body, " is not a coordinate"});
    for (int l = 0; l < k; ++l)
      if (amplitudes[l] == amplitudes[k])
        return sentence({called(m, amplitudes[k]), " is listed twice among the amplitudes of ", body});
    for (int i = 0; i < others; ++i)
      if (m.flexible_bodies[i].amplitudes.contains(amplitudes[k]))
        return sentence({called(m, amplitudes[k]), " is an amplitude of both ",
                         m.flexible_bodies[i].called.view(), " and ", body});
  }
  return {};
}

namespace detail {

/// Whether entries (i, j) and (j, i) of a matrix are numbers that differ only by rounding.
constexpr bool differ_by_rounding(const symbolic::matrix& a, int i, int j) {
  for (const expression& e : {a(i, j), a(j, i), a(i, i), a(j, j)})
    if (!e.is_constant()) return false;
  const auto value = [&](int row, int column) {
    const expression e = a(row, column);
    return e.owner().number_at(e.node()).value();
  };
  const double difference = value(i, j) - value(j, i), scale = value(i, i) * value(j, j);
  return difference * difference <= 1e-18 * numeric::elementary::abs(scale);
}

} // namespace detail

/// Reports a matrix of a flexible body, such as "the stiffness of ", that is not symmetric.
constexpr sentence check_symmetry(const mechanism& m, const symbolic::matrix& a, std::string_view of,
                                  std::string_view body) {
  symbolic::matrix differences(*m.g, 0, 1);
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < i; ++j)
      if (a(i, j) != a(j, i) && !detail::differ_by_rounding(a, i, j))
        differences.entries.push(a(i, j) - a(j, i));
  differences.rows = differences.entries.size();
  if (differences.rows == 0) return {};
  for (const numbers& state : at_generic_states(differences, &m))
    for (const double difference : state.entries)
      if (!base::equal(difference, 0.0)) return sentence({of, body, " is not symmetric"});
  return {};
}

/// Reports a negative number on the diagonal of a matrix of a flexible body, such as "the stiffness of ".
constexpr sentence check_not_negative(const mechanism& m, const symbolic::matrix& a, std::string_view of,
                                      const sequence<expression>& amplitudes, std::string_view body) {
  for (int k = 0; k < a.rows; ++k)
    if (is_negative(a(k, k)))
      return sentence({of, called(m, amplitudes[k]), ", an amplitude of ", body, ", is negative"});
  return {};
}

namespace detail {

/// Checks the integrals of one flexible body.
class flexible_body_checker {
public:
  constexpr flexible_body_checker(const mechanism& m, const flexible_body& b, const contents& held)
      : m_(m), b_(b), held_(held) {}

  constexpr sentence run() {
    check_contents();
    if (b_.mass.is_zero()) fail({"the flexible body ", b_.called.view(), " has no mass"});
    if (is_negative(b_.mass)) fail({"the mass of ", b_.called.view(), " is negative"});
    if (!found_) check_modal_mass();
    if (!found_) check_energy();
    return found_;
  }

private:
  using kind = contents::kind;

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }

  constexpr void check_contents() {
    check_fixed(b_.mass, "the mass of ");
    for (int i = 0; i < 3; ++i) check_deforming(b_.first_moment[i], "the first moment of ");
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) check_deforming(b_.inertia(i, j), "the inertia of ");
    for (const components& h : b_.angular)
      for (int i = 0; i < 3; ++i) check_deforming(h[i], "an angular integral of ");
    for (const expression& e : b_.modal_mass.entries) check_fixed(e, "the modal mass of ");
  }
  constexpr void check_fixed(expression e, std::string_view of) {
    if (!held_.is_fixed(e)) refuse(symbol_other_than(e, {}), of, "; it may contain only parameters");
  }
  constexpr void check_deforming(expression e, std::string_view of) {
    if (!held_.is_fixed(e))
      refuse(symbol_other_than(e, b_.amplitudes), of,
             "; it may contain only parameters and the amplitudes of the body");
  }
  constexpr void refuse(const sentence& symbol, std::string_view of, std::string_view allowed) {
    if (symbol) fail({of, b_.called.view(), " contains ", symbol.view(), allowed});
  }

  /// Returns, for example, "the speed u1" for a symbol that is neither a parameter nor one of the given
  /// coordinates; an empty message if there is none.
  constexpr sentence symbol_other_than(expression e, const sequence<expression>& allowed) const {
    for (const int q : held_.symbols_in(e, {kind::coordinate}))
      if (!allowed.contains({*m_.g, q})) return sentence({"the coordinate ", called(m_, {*m_.g, q})});
    if (const sentence found = symbol_in(
            m_, held_, e, {kind::speed, kind::auxiliary_speed, kind::coordinate_rate, kind::speed_rate}))
      return sentence({"the ", found.view()});
    if (held_.holds(e, kind::input)) return sentence({"the input ", held_.name_of(e, kind::input)});
    return held_.holds(e, kind::time) ? sentence({"time"}) : sentence();
  }

  constexpr void check_modal_mass() {
    const symbolic::matrix& mass = b_.modal_mass;
    for (int k = 0; k < mass.rows; ++k)
      if (mass(k, k).is_zero() || is_negative(mass(k, k)))
        fail({"the modal mass of ", called(m_, b_.amplitudes[k]), ", an amplitude of ", b_.called.view(),
              ", is not positive"});
    if (!found_) found_ = check_symmetry(m_, mass, "the modal mass of ", b_.called.view());
    if (!is_positive(mass, 0))
      fail({"the modal mass of ", b_.called.view(),
            " is not positive definite: some deformation has no kinetic energy, or a negative one"});
  }

  /// Checks the kinetic energy of the undeformed body as a quadratic form in v, ω and q̇.
  constexpr void check_energy() {
    const int count = b_.amplitudes.size();
    symbolic::substitution undeformed(*m_.g);
    for (const expression& q : b_.amplitudes) undeformed.replace(q, m_.zero());
    symbolic::matrix energy(*m_.g, 6 + count, 6 + count);
    for (int i = 0; i < 3; ++i) {
      energy(i, i) = b_.mass;
      const components arm = cross(unit(*m_.g, i), b_.first_moment); // of v in the direction of e_i × r
      for (int j = 0; j < 3; ++j) energy(3 + i, j) = undeformed.in(arm[j]);
      for (int j = 0; j <= i; ++j) energy(3 + i, 3 + j) = undeformed.in(b_.inertia(i, j));
    }
    for (int k = 0; k < count; ++k)
      for (int i = 0; i < 3; ++i) {
        energy(6 + k, i) = undeformed.in(symbolic::differentiate(b_.first_moment[i], b_.amplitudes[k]));
        energy(6 + k, 3 + i) = undeformed.in(b_.angular[k][i]);
      }
    for (int k = 0; k < count; ++k)
      for (int l = 0; l <= k; ++l) energy(6 + k, 6 + l) = b_.modal_mass(k, l);
    if (!is_positive(energy, rounded))
      fail({"the integrals of ", b_.called.view(),
            " belong to no distribution of mass: the kinetic energy of some motion is negative"});
  }

  /// Whether a symmetric matrix, given by its lower triangle, is positive definite after its diagonal has
  /// been enlarged by a fraction. Rows without a diagonal entry are ignored, because planar models often
  /// leave moments of inertia at zero. True if the matrix contains symbols.
  static constexpr bool is_positive(const symbolic::matrix& a, double enlarged) {
    sequence<int> rows;
    for (int i = 0; i < a.rows; ++i)
      if (!a(i, i).is_zero()) rows.push(i);
    sequence<double> values(rows.size() * rows.size(), 0.0);
    for (int i = 0; i < rows.size(); ++i)
      for (int j = 0; j <= i; ++j) {
        const expression e = a(rows[i], rows[j]);
        if (!e.is_constant()) return true;
        const double value = e.owner().number_at(e.node()).value();
        values[i * rows.size() + j] = i == j ? (1 + enlarged) * value : value;
      }
    return is_positive_definite(values, rows.size());
  }

  static constexpr double rounded = 1e-3; ///< admits a thin rod and integrals given to four digits

  const mechanism& m_;
  const flexible_body& b_;
  const contents& held_;
  sentence found_{};
};

} // namespace detail

/// Checks flexible body number `place`.
constexpr sentence check_flexible_body(const mechanism& m, int place, const contents& held) {
  const flexible_body& b = m.flexible_bodies[place];
  if (const sentence found = check_amplitudes(m, b.called.view(), b.amplitudes, place)) return found;
  return detail::flexible_body_checker(m, b, held).run();
}

} // namespace kanexpr::mechanics
