#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/flexible/agreement.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/limits.hpp>
#include <kanexpr/flexible/options.hpp>
#include <kanexpr/flexible/sid/dense.hpp>
#include <kanexpr/flexible/sid/document.hpp>
#include <kanexpr/flexible/sid/elasticity_translation.hpp>
#include <kanexpr/flexible/sid/node_translation.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

/// Translates the matrices of standard input data into the integrals of a flexible body. Of the matrices, Gr,
/// Ge and the constant part of Oe follow from J and Cr, and the linear part of mdCM is Ct:
///
///   Gr_k = J_k − [H_k]×,   Ge(k, l) = ∂H_k/∂q_l − ∂H_l/∂q_k,   Oe(k) = −½ (J_xx, J_yy, J_zz, 2 J_xy, …)_k,
///
/// with J_k = ∂J/∂q_k and the rows H_k of Cr, because all of them are the integrals of one kinetic energy.
namespace kanexpr::flexible::sid {

class translation {
public:
  mechanics::flexible_data data{};

  translation(const document& from, const reading_options& options, file_report& report)
      : data(from.amplitudes), from_(from), options_(options), report_(report), n_(from.amplitudes),
        order_(order_of(from)) {}

  /// Whether the file defines a body; otherwise, the report contains the mistake.
  bool translate() {
    return check_contents() && check_sizes() && check_orders() && translate_modal_mass() &&
           elasticity_translation(from_, order_, options_, report_, data).translate() &&
           translate_first_moment() && translate_inertia() && translate_angular() && translate_gyroscopic() &&
           translate_nodes();
  }

private:
  /// The entries of a symmetric matrix in the order of `flexible_data::inertia`.
  static constexpr std::array<std::array<int, 2>, 6> entries{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

  bool check_contents() {
    if (from_.amplitudes_line == 0) return report_.fail("the file does not contain nelastq");
    if (n_ == 0) return report_.fail(from_.amplitudes_line, "the body has no amplitudes");
    if (from_.mass_line == 0) return report_.fail("the file does not contain the mass of the body");
    if (!(from_.mass > 0))
      return report_.fail(from_.mass_line,
                          "the mass is " + number_text(from_.mass) + "; expected a positive number");
    for (matrix m : {matrix::mdcm, matrix::j, matrix::ct, matrix::cr, matrix::me, matrix::ke})
      if (!from_[m].is_given())
        return report_.fail("the file does not contain " + std::string(from_[m].called));
    if (from_.nodes.size() > most_nodes(n_))
      return report_.fail("the file has " + std::to_string(from_.nodes.size()) + " nodes with " +
                          std::to_string(n_) + " amplitudes; at most " + std::to_string(most_nodes(n_)) +
                          " are supported");
    data.mass = from_.mass;
    return true;
  }

  bool has_inertia_as_vector() const { return from_[matrix::j].columns == 1; }
  int inertia_rows() const { return has_inertia_as_vector() ? 6 : 3; }
  int inertia_columns() const { return has_inertia_as_vector() ? 1 : 3; }

  bool check_sizes() {
    const auto is = [&](matrix m, int rows, int columns) {
      return is_valid(from_[m], rows, columns, n_, order_, report_);
    };
    return is(matrix::mdcm, 3, 1) && is(matrix::j, inertia_rows(), inertia_columns()) &&
           is(matrix::ct, n_, 3) && is(matrix::cr, n_, 3) && is(matrix::me, n_, n_) &&
           is(matrix::gr, 3, 3 * n_) && is(matrix::ge, n_, 3 * n_) && is(matrix::oe, n_, 6) &&
           is(matrix::ksigma, n_, 1) && is(matrix::ke, n_, n_) && is(matrix::de, n_, n_);
  }

  /// Refuses terms of third and higher order in the kinetic energy, except for those of first order in Me and
  /// Ge, which are ignored.
  bool check_orders() {
    for (matrix m : {matrix::ct, matrix::cr, matrix::me, matrix::gr, matrix::ge, matrix::oe})
      if (const int line = from_[m].line_of_second_order())
        return report_.fail(line, std::string(from_[m].called) +
                                      " has terms of second order in the amplitudes, which are of third or "
                                      "higher order in the kinetic energy; the equations follow from this "
                                      "energy to the second order in the amplitudes and their rates");
    for (matrix m : {matrix::me, matrix::ge})
      for (const entry& e : from_[m].m1)
        if (std::abs(e.value) > 0) {
          report_.note(line_of(m), "the linear part of " + std::string(from_[m].called) +
                                       " is ignored, because it is of third order in the kinetic energy");
          break;
        }
    return true;
  }

  dense dense_of(matrix m, int rows, int columns) const {
    return sid::dense_of(from_[m], rows, columns, n_, order_);
  }
  int line_of(matrix m) const { return from_[m].line; }
  int amplitude_of(std::size_t i) const { return static_cast<int>(i) % n_; }

  /// Names an entry of m1 in an n × columns matrix: row by row, with the amplitude last.
  auto linear_entry_name(const std::string& called, int columns) const {
    return [called, columns, n = n_](std::size_t e) {
      const int l = static_cast<int>(e) % n, row_and_column = static_cast<int>(e) / n;
      return "the coefficient of amplitude " + at(l) + " in " + called +
             at(row_and_column / columns, row_and_column % columns);
    };
  }

  // By Cauchy and Schwarz, integrals of r and of shapes are bounded by moments of inertia and modal masses.
  double largest_modal_mass() const {
    double largest = 0;
    for (int k = 0; k < n_; ++k) largest = (std::max)(largest, data.modal_mass[k * n_ + k]);
    return largest;
  }
  double largest_inertia() const {
    double largest = 0;
    for (int e = 0; e < 3; ++e) largest = (std::max)(largest, data.inertia.constant(e));
    return largest;
  }
  double size_of_rate(double second_moment) const { return std::sqrt(second_moment * largest_modal_mass()); }

  bool translate_first_moment() {
    const dense moment = dense_of(matrix::mdcm, 3, 1), coupling = dense_of(matrix::ct, n_, 3);
    comparison linear{size_of_rate(data.mass)}, symmetry{size_of_rate(data.mass)};
    const bool is_provided = !moment.m2.empty() && from_[matrix::ct].m1.empty();
    if (is_provided) report_.note(line_of(matrix::ct), "Ct has no linear part; mdCM provides it");
    for (int i = 0; i < 3; ++i) {
      data.first_moment.constant(i) = moment.zeroth(i, 0);
      for (int k = 0; k < n_; ++k) {
        data.first_moment.linear(k, i) = coupling.zeroth(k, i);
        linear.add(moment.first(i, 0, k), coupling.zeroth(k, i));
      }
    }
    for (int k = 0; k < n_; ++k)
      for (int i = 0; i < 3; ++i)
        for (int l = 0; l < n_; ++l) {
          const double one = coupling.first(k, i, l), other = coupling.first(l, i, k);
          data.first_moment.quadratic(k, l, i) = is_provided ? moment.second(i, 0, k, l) : (one + other) / 2;
          symmetry.add(one, other);
        }
    if (!check_second_moment(moment)) return false;
    const auto linear_name = [&](std::size_t e) {
      const int k = amplitude_of(e);
      return "the coefficient of amplitude " + at(k) + " in mdCM" + at((static_cast<int>(e) - k) / n_, 0);
    };
    if (!from_[matrix::mdcm].m1.empty() &&
        !agrees(linear, line_of(matrix::mdcm), linear_name, "Ct gives", options_, report_))
      return false;
    return agrees(symmetry, line_of(matrix::ct), linear_entry_name("Ct", 3),
                  "the coefficient with exchanged amplitudes is", options_, report_);
  }

  /// Compares the terms of second order in mdCM with Ct.
  bool check_second_moment(const dense& moment) {
    comparison quadratic{size_of_rate(data.mass)};
    for (int i = 0; i < 3 && !moment.m2.empty(); ++i)
      for (int k = 0; k < n_; ++k)
        for (int l = 0; l <= k; ++l)
          quadratic.add(moment.second(i, 0, k, l), data.first_moment.quadratic(k, l, i));
    const auto name = [](std::size_t) { return std::string("a second derivative of mdCM"); };
    return agrees(quadratic, line_of(matrix::mdcm), name, "Ct gives", options_, report_);
  }

  /// The entry of J in a file for entry e of `flexible_data::inertia`.
  place inertia_place(int e) const {
    static constexpr std::array<int, 6> rows_of_vector{0, 1, 2, 3, 5, 4}; // xx, yy, zz, xy, xz, yz
    const auto index = static_cast<std::size_t>(e);
    return has_inertia_as_vector() ? place{0, rows_of_vector[index]}
                                   : place{entries[index][1], entries[index][0]};
  }

  bool translate_inertia() {
    const dense inertia = dense_of(matrix::j, inertia_rows(), inertia_columns());
    const dense centrifugal = dense_of(matrix::oe, n_, 6);
    const bool has_linear = !from_[matrix::j].m1.empty(), has_oe = !from_[matrix::oe].m0.empty();
    for (int e = 0; e < 6; ++e) {
      const place p = inertia_place(e);
      data.inertia.constant(e) = inertia.zeroth(p.amplitude, p.column);
      for (int k = 0; k < n_; ++k)
        data.inertia.linear(k, e) =
            has_linear ? inertia.first(p.amplitude, p.column, k) : weight(e) * centrifugal.zeroth(k, e);
    }
    if (!has_linear && has_oe) report_.note(line_of(matrix::j), "J has no linear part; Oe provides it");
    return translate_centrifugal(centrifugal, has_linear && has_oe) && translate_second_inertia(inertia);
  }

  /// Compares the terms of second order in J with Oe, or uses them if Oe has no linear part.
  bool translate_second_inertia(const dense& inertia) {
    const bool is_provided = from_[matrix::oe].m1.empty();
    if (is_provided)
      report_.note(inertia.m2.empty()
                       ? "Oe has no linear part, so the inertia is only of first order in the amplitudes"
                       : "Oe has no linear part; J provides it");
    comparison quadratic{largest_modal_mass()};
    for (int e = 0; e < 6 && !inertia.m2.empty(); ++e)
      for (int k = 0; k < n_; ++k)
        for (int l = 0; l < n_; ++l) {
          const place p = inertia_place(e);
          const double given = inertia.second(p.amplitude, p.column, k, l);
          if (is_provided) data.inertia.quadratic(k, l, e) = given;
          quadratic.add(given, data.inertia.quadratic(k, l, e));
        }
    const auto name = [](std::size_t) { return std::string("a second derivative of J"); };
    return agrees(quadratic, line_of(matrix::j), name, "Oe gives", options_, report_);
  }

  /// The factor from an entry of Oe to one of J.
  static double weight(int e) { return e < 3 ? -2 : -1; }

  bool translate_centrifugal(const dense& centrifugal, bool compares) {
    comparison constant{size_of_rate(largest_inertia())}, symmetry{largest_modal_mass()};
    for (int k = 0; k < n_; ++k)
      for (int e = 0; e < 6; ++e) {
        constant.add(centrifugal.zeroth(k, e), data.inertia.linear(k, e) / weight(e));
        for (int l = 0; l < n_; ++l) {
          const double one = centrifugal.first(k, e, l), other = centrifugal.first(l, e, k);
          data.inertia.quadratic(k, l, e) = weight(e) * (one + other) / 2;
          symmetry.add(one, other);
        }
      }
    const auto constant_name = [](std::size_t e) {
      return "Oe" + at(static_cast<int>(e) / 6, static_cast<int>(e) % 6);
    };
    if (compares && !agrees(constant, line_of(matrix::oe), constant_name, "J gives", options_, report_))
      return false;
    return agrees(symmetry, line_of(matrix::oe), linear_entry_name("Oe", 6),
                  "the coefficient with exchanged amplitudes is", options_, report_);
  }

  bool translate_angular() {
    const dense rotation = dense_of(matrix::cr, n_, 3), gyroscopic = dense_of(matrix::ge, n_, 3 * n_);
    const bool has_linear = !from_[matrix::cr].m1.empty(), has_ge = !from_[matrix::ge].m0.empty();
    for (int k = 0; k < n_; ++k)
      for (int i = 0; i < 3; ++i) {
        data.angular.constant(3 * k + i) = rotation.zeroth(k, i);
        for (int l = 0; l < n_; ++l)
          data.angular.linear(l, 3 * k + i) =
              has_linear ? rotation.first(k, i, l) : gyroscopic.zeroth(k, 3 * l + i) / 2;
      }
    if (!has_linear && has_ge) report_.note(line_of(matrix::cr), "Cr has no linear part; Ge provides it");
    return !has_linear || !has_ge || check_elastic_gyroscopic(gyroscopic);
  }

  /// Compares Ge with Cr. Some programs order the columns of Ge by axis instead of by amplitude.
  bool check_elastic_gyroscopic(const dense& gyroscopic) {
    comparison by_amplitude{largest_modal_mass()}, by_axis{largest_modal_mass()};
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l < n_; ++l)
        for (int i = 0; i < 3; ++i) {
          const double derived = data.angular.linear(l, 3 * k + i) - data.angular.linear(k, 3 * l + i);
          by_amplitude.add(gyroscopic.zeroth(k, 3 * l + i), derived);
          by_axis.add(gyroscopic.zeroth(k, n_ * i + l), derived);
        }
    const bool is_by_axis = by_axis.total_difference() < by_amplitude.total_difference();
    const auto name = [n = n_, is_by_axis](std::size_t e) {
      const int row = static_cast<int>(e) / (3 * n), column = static_cast<int>(e) % (3 * n);
      return "Ge" + at(row, is_by_axis ? n * (column % 3) + column / 3 : column);
    };
    return agrees(is_by_axis ? by_axis : by_amplitude, line_of(matrix::ge), name, "Cr gives", options_,
                  report_);
  }

  bool translate_gyroscopic() {
    if (from_[matrix::gr].m0.empty()) return true;
    const dense gyroscopic = dense_of(matrix::gr, 3, 3 * n_);
    comparison constant{size_of_rate(largest_inertia())};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < n_; ++k)
        for (int j = 0; j < 3; ++j)
          constant.add(gyroscopic.zeroth(i, 3 * k + j),
                       data.inertia.linear(k, inertia_entry(i, j)) -
                           cross_entry(i, j, [&](int c) { return data.angular.constant(3 * k + c); }));
    const auto name = [n = n_](std::size_t e) {
      return "Gr" + at(static_cast<int>(e) / (3 * n), static_cast<int>(e) % (3 * n));
    };
    return agrees(constant, line_of(matrix::gr), name, "J and Cr give", options_, report_) &&
           check_linear_gyroscopic(gyroscopic);
  }

  /// Compares the linear part of Gr with those of Oe and Cr, ∂Gr_k/∂q_l = ∂J_k/∂q_l − [∂H_k/∂q_l]×.
  bool check_linear_gyroscopic(const dense& gyroscopic) {
    if (from_[matrix::gr].m1.empty() || from_[matrix::oe].m1.empty()) return true;
    comparison linear{largest_modal_mass()};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < n_; ++k)
        for (int j = 0; j < 3; ++j)
          for (int l = 0; l < n_; ++l)
            linear.add(gyroscopic.first(i, 3 * k + j, l),
                       data.inertia.quadratic(k, l, inertia_entry(i, j)) -
                           cross_entry(i, j, [&](int c) { return data.angular.linear(l, 3 * k + c); }));
    return agrees(linear, line_of(matrix::gr), linear_entry_name("Gr", 3 * n_), "Oe and Cr give", options_,
                  report_);
  }

  /// The place of entry (i, j) of a symmetric matrix in the order of `flexible_data::inertia`.
  static int inertia_entry(int i, int j) { return i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5; }
  /// Entry (i, j) of [v]× for a vector with the given components.
  template <class Component>
  static double cross_entry(int i, int j, const Component& v) {
    if (i == j) return 0;
    const double third = v(3 - i - j);
    return (i + 1) % 3 == j ? -third : third;
  }

  bool translate_modal_mass() {
    const dense given = dense_of(matrix::me, n_, n_);
    return add_symmetric([&](int k, int l) { return given.zeroth(k, l); }, n_, data.modal_mass,
                         line_of(matrix::me), [](int k, int l) { return "Me" + at(k, l); }, options_,
                         report_);
  }

  bool translate_nodes() {
    node_translation nodes(from_, order_, options_, report_);
    if (!nodes.translate()) return false;
    data.nodes = std::move(nodes.nodes);
    return true;
  }

  const document& from_;
  const reading_options& options_;
  file_report& report_;
  int n_;
  index_order order_;
};

} // namespace kanexpr::flexible::sid
