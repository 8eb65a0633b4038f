#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/flexible/agreement.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/options.hpp>
#include <kanexpr/flexible/sid/dense.hpp>
#include <kanexpr/flexible/sid/document.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace kanexpr::flexible::sid {

/// Translates the elastic forces and the damping of standard input data. The forces, ksigma(q) + Ke(q) q,
/// must be the derivatives of a potential energy. The terms of ksigma and Ke may be of any order that a file
/// can contain, because this energy is used without truncation; De(q) may depend on the amplitudes likewise.
class elasticity_translation {
public:
  elasticity_translation(const document& from, index_order order, const reading_options& options,
                         file_report& report, mechanics::flexible_data& into)
      : options_(options), report_(report), data_(into), n_(from.amplitudes),
        preload_line_(from[matrix::ksigma].line), stiffness_line_(from[matrix::ke].line),
        damping_line_(from[matrix::de].line), preload_(dense_of(from[matrix::ksigma], n_, 1, n_, order)),
        stiffness_(dense_of(from[matrix::ke], n_, n_, n_, order)),
        damping_(dense_of(from[matrix::de], n_, n_, n_, order)),
        has_quadratic_force_(!from[matrix::ksigma].m2.empty() || !from[matrix::ke].m1.empty()),
        varies_damping_(!from[matrix::de].m1.empty() || !from[matrix::de].m2.empty()) {}

  /// Whether the matrices are consistent; otherwise, the report contains the mistake.
  bool translate() {
    for (int k = 0; k < n_; ++k) data_.preload[k] = preload_.zeroth(k, 0);
    return translate_stiffness() && translate_cubic_energy() && translate_quartic_energy() &&
           translate_damping();
  }

private:
  static auto entry_of(std::string_view called) {
    return [called](int k, int l) { return std::string(called) + at(k, l); };
  }
  static auto coefficient_in(std::string_view called) {
    return [called](int k, int l) {
      return "the coefficient of amplitude " + at(l) + " in " + std::string(called) + at(k, 0);
    };
  }

  /// Ke, and the stiffness due to reference stresses in the linear part of ksigma.
  bool translate_stiffness() {
    return add_symmetric([&](int k, int l) { return stiffness_.zeroth(k, l); }, n_, data_.stiffness,
                         stiffness_line_, entry_of("Ke"), options_, report_) &&
           add_symmetric([&](int k, int l) { return preload_.first(k, 0, l); }, n_, data_.stiffness,
                         preload_line_, coefficient_in("ksigma"), options_, report_);
  }

  /// The line of the matrix with terms of a given order in the elastic force.
  int line_of_force() const { return stiffness_line_ != 0 ? stiffness_line_ : preload_line_; }

  /// Adds the term of the potential energy with the given amplitudes, if the elastic force on each of them
  /// has the coefficient `force` with the other ones, for each of their orders.
  template <std::size_t count>
  void add_energy(std::array<int, count> k, double force) {
    double orders = 0;
    std::array<int, count> permuted = k;
    do orders += 1;
    while (std::next_permutation(permuted.begin(), permuted.end()));
    mechanics::elastic_term term{.coefficient = force * orders / static_cast<double>(count)};
    std::copy(k.begin(), k.end(), term.amplitudes);
    if (std::abs(term.coefficient) > 0) data_.elastic_terms.push(term);
  }

  /// The coefficient of q_l q_m, and of q_m q_l, in the elastic force on amplitude k.
  double quadratic_force(int k, int l, int m) const {
    return (preload_.second(k, 0, l, m) + stiffness_.first(k, l, m) + stiffness_.first(k, m, l)) / 2;
  }

  bool translate_cubic_energy() {
    if (!has_quadratic_force_) return true;
    comparison potential;
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l < n_; ++l)
        for (int m = 0; m <= l; ++m) {
          const double one = quadratic_force(k, l, m), two = quadratic_force(l, k, m),
                       three = quadratic_force(m, k, l), mean = (one + two + three) / 3;
          potential.add(one, mean);
          if (l <= k) add_energy(std::array{m, l, k}, mean);
        }
    const auto name = [&](std::size_t e) {
      const auto [k, l, m] = indices_of(e);
      return "the coefficient of amplitudes " + at(m) + " and " + at(l) +
             " in the elastic force on amplitude " + at(k);
    };
    return agrees(potential, line_of_force(), name, "a potential energy gives", options_, report_);
  }
  /// The indices k, l and m ≤ l at a place of the list that `translate_cubic_energy` compares.
  std::array<int, 3> indices_of(std::size_t place) const {
    const int pairs = n_ * (n_ + 1) / 2, k = static_cast<int>(place) / pairs;
    int l = 0, m = static_cast<int>(place) % pairs;
    while (m > l) m -= ++l;
    return {k, l, m};
  }

  /// The coefficient of q_l q_m q_n, for each of their orders, in the elastic force on amplitude k.
  double cubic_force(int k, int l, int m, int n) const {
    return (stiffness_.second(k, l, m, n) + stiffness_.second(k, m, l, n) + stiffness_.second(k, n, l, m)) /
           6;
  }

  bool translate_quartic_energy() {
    if (stiffness_.m2.empty()) return true;
    comparison potential;
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l < n_; ++l)
        for (int m = 0; m <= l; ++m)
          for (int n = 0; n <= m; ++n) {
            const double own = cubic_force(k, l, m, n),
                         mean = (own + cubic_force(l, k, m, n) + cubic_force(m, k, l, n) +
                                 cubic_force(n, k, l, m)) /
                                4;
            potential.add(own, mean);
            if (l <= k) add_energy(std::array{n, m, l, k}, mean);
          }
    const auto name = [](std::size_t) { return std::string("a coefficient of second order in Ke"); };
    return agrees(potential, stiffness_line_, name, "a potential energy gives", options_, report_);
  }

  bool translate_damping() {
    if (!add_symmetric([&](int k, int l) { return damping_.zeroth(k, l); }, n_, data_.damping, damping_line_,
                       entry_of("De"), options_, report_))
      return false;
    return !varies_damping_ || translate_varying_damping();
  }
  bool translate_varying_damping() {
    comparison symmetry;
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l <= k; ++l)
        for (int m = 0; m < n_; ++m) {
          const double one = damping_.first(k, l, m), other = damping_.first(l, k, m);
          symmetry.add(one, other);
          add_damping({.coefficient = (one + other) / 2, .row = k, .column = l, .amplitudes = {m, -1}});
          for (int n = 0; n <= m && !damping_.m2.empty(); ++n) {
            const double second = damping_.second(k, l, m, n), opposite = damping_.second(l, k, m, n);
            symmetry.add(second, opposite);
            add_damping({.coefficient = (second + opposite) / (m == n ? 4 : 2),
                         .row = k,
                         .column = l,
                         .amplitudes = {m, n}});
          }
        }
    const auto name = [](std::size_t) { return std::string("a coefficient of an amplitude in De"); };
    return agrees(symmetry, damping_line_, name, "the opposite entry has", options_, report_);
  }
  void add_damping(const mechanics::damping_term& term) {
    if (std::abs(term.coefficient) > 0) data_.damping_terms.push(term);
  }

  const reading_options& options_;
  file_report& report_;
  mechanics::flexible_data& data_;
  int n_;
  int preload_line_, stiffness_line_, damping_line_;
  dense preload_, stiffness_, damping_;
  bool has_quadratic_force_, varies_damping_;
};

} // namespace kanexpr::flexible::sid
