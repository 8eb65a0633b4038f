#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/flexible/agreement.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/options.hpp>
#include <kanexpr/flexible/sid/dense.hpp>
#include <kanexpr/flexible/sid/document.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace kanexpr::flexible::sid {

/// Translates the nodes of standard input data. A node is at origin(q) = origin + phi q + ½ phi1 q q, where
/// phi1 is the linear part of phi, and its axes are turned by psi q; the linear parts of origin and AP follow
/// from these.
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
    comparison linear;
    for (int i = 0; i < 3; ++i) {
      into.position.constant(i) = origin.zeroth(i, 0);
      for (int k = 0; k < n_; ++k) {
        into.position.linear(k, i) = has_phi ? shapes.zeroth(i, k) : origin.first(i, 0, k);
        linear.add(origin.first(i, 0, k), into.position.linear(k, i));
        for (int l = 0; l < n_; ++l)
          into.position.quadratic(k, l, i) = (shapes.first(i, k, l) + shapes.first(i, l, k)) / 2;
      }
    }
    const auto name = [&](std::size_t e) {
      const int k = static_cast<int>(e) % n_;
      return "the coefficient of amplitude " + at(k) + " in origin" + at((static_cast<int>(e) - k) / n_, 0) +
             " of node " + printable(given.called);
    };
    return !has_linear || agrees(linear, given.origin.line, name, "phi gives", options_, report_);
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
    if (!check_rotation_matrix(given, into) || !check_turning(given, into, turned)) return false;
    make_orthonormal(into.orientation);
    return true;
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
