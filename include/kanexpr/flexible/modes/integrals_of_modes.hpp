#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/flexible/modes/modal_model.hpp>
#include <kanexpr/flexible/modes/rotary_inertia.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <array>
#include <cstddef>
#include <vector>

/// Forms the integrals of a flexible body from the displacements of its nodes: ∫ a b dm = Σ_ij m_ij a_i b_j.
namespace kanexpr::flexible::modes {

class integrals_of_modes {
public:
  explicit integrals_of_modes(const modal_model& of) : of_(of), n_(of.amplitudes) {}

  mechanics::flexible_data data() const {
    mechanics::flexible_data d(n_);
    for (const modal_model::mass_entry& e : of_.masses) d.mass += e.mass;
    form_first_moment(d);
    form_inertia(d);
    form_angular(d);
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l < n_; ++l) d.modal_mass[k * n_ + l] = trace(products(shape(k), shape(l)));
    add_rotary_inertias(d);
    add_geometric_stiffness(d);
    copy(of_.stiffness, d.stiffness);
    copy(of_.damping, d.damping);
    for (const modal_model::attachment& a : of_.attachments) d.nodes.push(node_of(a));
    return d;
  }

private:
  using vectors = modal_model::vectors;
  using second_moments = std::array<double, 9>; ///< ∫ a_i b_j dm, row by row

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const vectors& shape(int k) const { return of_.shapes[at(k)]; }
  bool bends() const { return !of_.bends.empty(); }
  const vectors& bend(int k, int l) const { return of_.bends[at(k * n_ + l)]; }

  static void copy(const std::vector<double>& from, base::sequence<double>& to) {
    for (int i = 0; i < to.size() && at(i) < from.size(); ++i) to[i] = from[at(i)];
  }

  double integral(const vectors& a, int i) const {
    double sum = 0;
    for (const modal_model::mass_entry& e : of_.masses) sum += e.mass * a[3 * e.row + at(i)];
    return sum;
  }
  second_moments products(const vectors& a, const vectors& b) const {
    second_moments sum{};
    for (const modal_model::mass_entry& e : of_.masses)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) sum[3 * i + j] += e.mass * a[3 * e.row + i] * b[3 * e.column + j];
    return sum;
  }
  static double trace(const second_moments& p) { return p[0] + p[4] + p[8]; }
  /// Entry e of ∫ (2 a·b E − a b − b a) dm, in the order xx, yy, zz, xy, yz, zx.
  static double inertia_entry(const second_moments& p, int e) {
    if (e < 3) return 2 * (trace(p) - p[at(4 * e)]);
    const int i = e - 3, j = (i + 1) % 3;
    return -(p[at(3 * i + j)] + p[at(3 * j + i)]);
  }
  /// Component i of ∫ a × b dm.
  static double cross_entry(const second_moments& p, int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return p[at(3 * j + k)] - p[at(3 * k + j)];
  }

  void form_first_moment(mechanics::flexible_data& d) const {
    for (int i = 0; i < 3; ++i) {
      d.first_moment.constant(i) = integral(of_.positions, i);
      for (int k = 0; k < n_; ++k) {
        d.first_moment.linear(k, i) = integral(shape(k), i);
        for (int l = 0; l < n_ && bends(); ++l) d.first_moment.quadratic(k, l, i) = integral(bend(k, l), i);
      }
    }
  }

  void form_inertia(mechanics::flexible_data& d) const {
    const second_moments constant = products(of_.positions, of_.positions);
    for (int e = 0; e < 6; ++e) d.inertia.constant(e) = inertia_entry(constant, e) / 2;
    for (int k = 0; k < n_; ++k) {
      const second_moments linear = products(of_.positions, shape(k));
      for (int e = 0; e < 6; ++e) d.inertia.linear(k, e) = inertia_entry(linear, e);
      for (int l = 0; l < n_; ++l) {
        second_moments second = products(shape(k), shape(l));
        if (bends()) add(second, products(of_.positions, bend(k, l)));
        for (int e = 0; e < 6; ++e) d.inertia.quadratic(k, l, e) = inertia_entry(second, e);
      }
    }
  }
  static void add(second_moments& to, const second_moments& more) {
    for (std::size_t i = 0; i < 9; ++i) to[i] += more[i];
  }

  void form_angular(mechanics::flexible_data& d) const {
    for (int k = 0; k < n_; ++k) {
      const second_moments constant = products(of_.positions, shape(k));
      for (int i = 0; i < 3; ++i) d.angular.constant(3 * k + i) = cross_entry(constant, i);
      for (int l = 0; l < n_; ++l) {
        second_moments linear = products(shape(l), shape(k));
        if (bends()) add(linear, products(of_.positions, bend(k, l)));
        for (int i = 0; i < 3; ++i) d.angular.linear(l, 3 * k + i) = cross_entry(linear, i);
      }
    }
  }

  void add_rotary_inertias(mechanics::flexible_data& d) const {
    const auto at_node = [](const vectors& of, std::size_t node) {
      return rotary_inertia::vector{of[3 * node], of[3 * node + 1], of[3 * node + 2]};
    };
    for (std::size_t node = 0; node < of_.inertias.size(); ++node) {
      if (of_.inertias[node] == modal_model::tensor{}) continue;
      add_rotary_inertia(
          d, of_.inertias[node], [&](int k) { return at_node(of_.rotations[at(k)], node); },
          [&](int k, int l) {
            return of_.rotation_bends.empty() ? rotary_inertia::vector{}
                                              : at_node(of_.rotation_bends[at(k * n_ + l)], node);
          });
    }
  }

  /// These stiffnesses are the second-order terms of the integrals that multiply the accelerations.
  void add_geometric_stiffness(mechanics::flexible_data& d) const {
    const auto entry = [&](const std::vector<modal_model::matrix>& all, int i, int k, int l) {
      return all.empty() ? 0 : all[at(i)][at(k * n_ + l)];
    };
    for (int k = 0; k < n_; ++k)
      for (int l = 0; l < n_; ++l) {
        for (int i = 0; i < 3; ++i) {
          d.first_moment.quadratic(k, l, i) += entry(of_.by_acceleration, i, k, l);
          d.angular.linear(l, 3 * k + i) += entry(of_.by_angular_acceleration, i, k, l);
        }
        for (int e = 0; e < 6; ++e)
          d.inertia.quadratic(k, l, e) -= (e < 3 ? 2 : 1) * entry(of_.by_rotation, e, k, l);
      }
  }

  mechanics::flexible_node node_of(const modal_model::attachment& a) const {
    mechanics::flexible_node made{.called = base::name(a.called),
                                  .position = mechanics::taylor_series(3, n_)};
    made.orientation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    made.rotation.resize(3 * n_);
    if (!of_.rotation_bends.empty()) made.second_rotation.resize(3 * n_ * n_);
    for (int i = 0; i < 3; ++i) {
      const std::size_t place = 3 * a.node + at(i);
      made.position.constant(i) = of_.positions[place];
      for (int k = 0; k < n_; ++k) {
        made.position.linear(k, i) = shape(k)[place];
        if (!of_.rotations.empty()) made.rotation[3 * k + i] = of_.rotations[at(k)][place];
        for (int l = 0; l < n_ && bends(); ++l) made.position.quadratic(k, l, i) = bend(k, l)[place];
        for (int l = 0; l < n_ && !of_.rotation_bends.empty(); ++l)
          made.second_rotation[3 * (k * n_ + l) + i] = of_.rotation_bends[at(k * n_ + l)][place];
      }
    }
    return made;
  }

  const modal_model& of_;
  int n_;
};

} // namespace kanexpr::flexible::modes
