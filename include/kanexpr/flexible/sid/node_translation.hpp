#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/flexible/agreement.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/options.hpp>
#include <kanexpr/flexible/sid/dense.hpp>
#include <kanexpr/flexible/sid/document.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace kanexpr::flexible::sid {

/// Translates the nodes of standard input data. Its velocity and its angular velocity relative to the frame
/// of the body are phi(q) q̇ and psi(q) q̇. To the second order, a node is therefore at origin + phi q + ½ phi1
/// q q, where phi1 is the linear part of phi, and its axes are turned by the rotation vector psi q + ½ psi1 q
/// q, where psi1 is the symmetric part of the linear part of psi. The other terms of origin, psi and AP
/// follow.
class node_translation {
public:
  base::sequence<mechanics::flexible_node> nodes{};

  node_translation(const document& from, index_order order, const reading_options& options,
                   file_report& report)
      : from_(from), order_(order), options_(options), report_(report), n_(from.amplitudes) {}

  /// Whether the nodes are valid; otherwise, the report contains the mistake.
  bool translate() {
    nodes.resize(static_cast<int>(from_.nodes.size()));
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < from_.nodes.size(); ++i) {
      if (!names.insert(from_.nodes[i].called).second)
        return report_.fail(from_.nodes[i].line,
                            "there is a second node " + printable(from_.nodes[i].called));
      if (!translate_node(from_.nodes[i], nodes[static_cast<int>(i)])) return false;
    }
    return true;
  }

private:
  bool translate_node(const node& given, mechanics::flexible_node& into) {
    const auto is = [&](const series& s, int columns) {
      return is_valid(s, 3, columns, n_, order_, report_);
    };
    if (!given.origin.is_given())
      return report_.fail(given.line, "node " + printable(given.called) + " has no origin");
    if (!is(given.origin, 1) || !is(given.phi, n_) || !is(given.psi, n_) || !is(given.orientation, 3))
      return false;
    for (const series* s : {&given.phi, &given.psi})
      if (const int line = s->line_of_second_order())
        return report_.fail(line,
                            std::string(s->called) + " of node " + printable(given.called) +
                                " has terms of second order in the amplitudes; the place of a node is "
                                "described to the second order, for which the first order of phi and psi "
                                "suffices");
    into.called = base::name(given.called);
    into.position = mechanics::taylor_series(3, n_);
    into.orientation.resize(9);
    into.rotation.resize(3 * n_);
    return translate_position(given, into) && translate_orientation(given, into);
  }

  dense dense_of(const series& s, int columns) const { return sid::dense_of(s, 3, columns, n_, order_); }

  bool translate_position(const node& given, mechanics::flexible_node& into) {
    const dense origin = dense_of(given.origin, 1), shapes = dense_of(given.phi, n_);
    const bool has_phi = !given.phi.m0.empty(), has_linear = !given.origin.m1.empty();
    const bool has_second = !given.phi.m1.empty();
    comparison linear, quadratic;
    for (int i = 0; i < 3; ++i) {
      into.position.constant(i) = origin.zeroth(i, 0);
      for (int k = 0; k < n_; ++k) {
        into.position.linear(k, i) = has_phi ? shapes.zeroth(i, k) : origin.first(i, 0, k);
        linear.add(origin.first(i, 0, k), into.position.linear(k, i));
        for (int l = 0; l < n_; ++l) {
          into.position.quadratic(k, l, i) =
              has_second ? (shapes.first(i, k, l) + shapes.first(i, l, k)) / 2 : origin.second(i, 0, k, l);
          if (!origin.m2.empty()) quadratic.add(origin.second(i, 0, k, l), into.position.quadratic(k, l, i));
        }
      }
    }
    const auto name = [&](std::size_t e) {
      const int k = static_cast<int>(e) % n_;
      return "the coefficient of amplitude " + at(k) + " in origin" + at((static_cast<int>(e) - k) / n_, 0) +
             " of node " + printable(given.called);
    };
    const auto second_name = [&](std::size_t) {
      return "a second derivative of origin of node " + printable(given.called);
    };
    return (!has_linear || agrees(linear, given.origin.line, name, "phi gives", options_, report_)) &&
           agrees(quadratic, given.origin.line, second_name, "phi gives", options_, report_);
  }

  bool translate_orientation(const node& given, mechanics::flexible_node& into) {
    const dense turned = dense_of(given.orientation, 3), rotations = dense_of(given.psi, n_);
    const bool has_orientation =
        !given.orientation.m0.empty() || given.orientation.structure == structure::unit;
    const bool has_axes = given.orientation.is_given() && has_orientation;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) into.orientation[3 * i + j] = has_axes ? turned.zeroth(i, j) : i == j;
    for (int k = 0; k < n_; ++k)
      for (int i = 0; i < 3; ++i)
        into.rotation[3 * k + i] =
            given.psi.m0.empty() ? rotation_in(turned, into, k, i) : rotations.zeroth(i, k);
    translate_second_rotation(given, into, turned, rotations);
    if (!check_rotation_matrix(given, into) || !check_turning(given, into, turned) ||
        !check_second_turning(given, into, turned) || !check_second_rotation(given, into, rotations))
      return false;
    make_orthonormal(into.orientation);
    return true;
  }

  void translate_second_rotation(const node& given, mechanics::flexible_node& into, const dense& turned,
                                 const dense& rotations) const {
    const bool has_psi = !given.psi.m1.empty(), has_axes = !turned.m2.empty();
    if (!has_psi && !has_axes) return;
    into.second_rotation.resize(3 * n_ * n_);
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l < n_; ++l)
        for (int i = 0; i < 3; ++i)
          into.second_rotation[3 * (k * n_ + l) + i] =
              has_psi ? (rotations.first(i, k, l) + rotations.first(i, l, k)) / 2
                      : second_rotation_in(turned, into, k, l, i);
  }

  /// Component i of the second derivative of the rotation vector, from that of the orientation Γ. Its product
  /// with Γᵀ is ½ ([ψ_k]× [ψ_l]× + [ψ_l]× [ψ_k]×), which is symmetric, and the cross product matrix sought.
  static double second_rotation_in(const dense& turned, const mechanics::flexible_node& into, int k, int l,
                                   int i) {
    const auto product = [&](int row, int column) {
      double entry = 0;
      for (int j = 0; j < 3; ++j) entry += turned.second(row, j, k, l) * into.orientation[3 * column + j];
      return entry;
    };
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    return (product(b, a) - product(a, b)) / 2;
  }

  /// Compares the antisymmetric part of the linear part of psi, if it is not zero, with ψ_l × ψ_k / 2, which
  /// the angular velocity of a rotation vector contains.
  bool check_second_rotation(const node& given, const mechanics::flexible_node& into,
                             const dense& rotations) {
    comparison antisymmetric;
    bool is_symmetric = true;
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l < k; ++l)
        for (int i = 0; i < 3; ++i) {
          const int a = (i + 1) % 3, b = (i + 2) % 3;
          const base::sequence<double>& psi = into.rotation;
          const double written = (rotations.first(i, k, l) - rotations.first(i, l, k)) / 2;
          is_symmetric = is_symmetric && !(std::abs(written) > 0);
          antisymmetric.add(written, (psi[3 * l + a] * psi[3 * k + b] - psi[3 * l + b] * psi[3 * k + a]) / 2);
        }
    const auto name = [&](std::size_t) {
      return "half of the difference of coefficients with exchanged amplitudes in psi of node " +
             printable(given.called);
    };
    return is_symmetric ||
           agrees(antisymmetric, given.psi.line, name, "its constant part gives", options_, report_);
  }

  /// Compares the terms of second order in AP with those that follow from the rotation vector.
  bool check_second_turning(const node& given, const mechanics::flexible_node& into, const dense& turned) {
    if (turned.m2.empty()) return true;
    comparison quadratic;
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l <= k; ++l)
        for (int j = 0; j < 3; ++j) {
          const std::array<double, 3> axis = column_of(into.orientation, j);
          const std::array<double, 3> first = vector_at(into.rotation, k),
                                      second = vector_at(into.rotation, l);
          const std::array<double, 3> one = cross(first, cross(second, axis)),
                                      other = cross(second, cross(first, axis)),
                                      own = cross(vector_at(into.second_rotation, k * n_ + l), axis);
          for (std::size_t i = 0; i < 3; ++i)
            quadratic.add(turned.second(static_cast<int>(i), j, k, l), (one[i] + other[i]) / 2 + own[i]);
        }
    const auto name = [&](std::size_t) {
      return "a second derivative of AP of node " + printable(given.called);
    };
    return agrees(quadratic, given.orientation.line, name, "psi gives", options_, report_);
  }

  static std::array<double, 3> vector_at(const base::sequence<double>& from, int place) {
    return {from[3 * place], from[3 * place + 1], from[3 * place + 2]};
  }
  static std::array<double, 3> column_of(const base::sequence<double>& matrix, int j) {
    return {matrix[j], matrix[3 + j], matrix[6 + j]};
  }
  static std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  /// Component i of the rotation with amplitude k, from the linear part [ψ_k]× Γ of the orientation Γ.
  static double rotation_in(const dense& turned, const mechanics::flexible_node& into, int k, int i) {
    const int row = (i + 2) % 3, column = (i + 1) % 3;
    double entry = 0;
    for (int j = 0; j < 3; ++j) entry += turned.first(row, j, k) * into.orientation[3 * column + j];
    return entry;
  }

  bool check_rotation_matrix(const node& given, const mechanics::flexible_node& into) {
    comparison products;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        double product = 0;
        for (int e = 0; e < 3; ++e) product += into.orientation[3 * i + e] * into.orientation[3 * j + e];
        products.add(product, i == j);
      }
    if (products.relative_difference() <= 1e-3) return true;
    return report_.fail(given.orientation.line,
                        "AP of node " + printable(given.called) + " is not a rotation matrix");
  }

  /// Removes the rounding of a rotation matrix by Newton's iteration for its polar factor, Γ ← Γ (3 − ΓᵀΓ)/2.
  static void make_orthonormal(base::sequence<double>& matrix) {
    for (int iteration = 0; iteration < 4; ++iteration) {
      const base::sequence<double> before = matrix;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          double change = 0;
          for (int k = 0; k < 3; ++k) {
            double product = 0;
            for (int e = 0; e < 3; ++e) product += before[3 * e + k] * before[3 * e + j];
            change += before[3 * i + k] * ((k == j ? 1 : 0) - product);
          }
          matrix[3 * i + j] = before[3 * i + j] + change / 2;
        }
    }
  }

  bool check_turning(const node& given, const mechanics::flexible_node& into, const dense& turned) {
    if (given.orientation.m1.empty() || given.psi.m0.empty()) return true;
    comparison linear;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < n_; ++k) {
          const int a = (i + 1) % 3, b = (i + 2) % 3;
          linear.add(turned.first(i, j, k), into.rotation[3 * k + a] * into.orientation[3 * b + j] -
                                                into.rotation[3 * k + b] * into.orientation[3 * a + j]);
        }
    const auto name = [&](std::size_t e) {
      const int k = static_cast<int>(e) % n_, entry = static_cast<int>(e) / n_;
      return "the coefficient of amplitude " + at(k) + " in AP" + at(entry / 3, entry % 3) + " of node " +
             printable(given.called);
    };
    return agrees(linear, given.orientation.line, name, "psi gives", options_, report_);
  }

  const document& from_;
  index_order order_;
  const reading_options& options_;
  file_report& report_;
  int n_;
};

} // namespace kanexpr::flexible::sid
