#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <cstddef>
#include <string_view>

namespace kanexpr {

namespace describe {

constexpr void copy_numbers(const double* from, base::sequence<double>& to) {
  for (int i = 0; i < to.size(); ++i) to[i] = from[i];
}

/// The size of an array, which cannot be empty.
constexpr std::size_t at_least_one(int count) { return count < 1 ? 1 : static_cast<std::size_t>(count); }

} // namespace describe

/// The numbers of a flexible body in SI units, in a constant that a header defines; `kanexpr-flexible-body`
/// writes such headers from files. Each series lists its constant part, its derivatives with respect to the
/// amplitudes in order, and, except for `angular`, the second derivatives row by row. The last two arguments
/// are the numbers of terms of higher order in the elastic energy and in the damping. Definitions:
/// `mechanics::flexible_data`.
template <int amplitudes, int nodes_count, int elastic_terms_count = 0, int damping_terms_count = 0>
struct flexible_body_data {
  static constexpr int amplitudes_count = amplitudes;
  /// The numbers of amplitudes and of coefficients of a series of second order.
  static constexpr std::size_t count = static_cast<std::size_t>(amplitudes);
  static constexpr std::size_t second_order = 1 + count + count * count;

  struct node {
    base::name called{};
    double position[3 * second_order]{};
    double orientation[9]{1, 0, 0, 0, 1, 0, 0, 0, 1};
    double rotation[3 * count]{};
    double second_rotation[3 * count * count]{};
  };

  double mass = 0;
  double first_moment[3 * second_order]{};
  double inertia[6 * second_order]{};
  double angular[3 * count * (1 + count)]{};
  double modal_mass[count * count]{};
  double stiffness[count * count]{};
  double damping[count * count]{};
  double preload[count]{};
  mechanics::elastic_term elastic_terms[describe::at_least_one(elastic_terms_count)]{};
  mechanics::damping_term damping_terms[describe::at_least_one(damping_terms_count)]{};
  node nodes[describe::at_least_one(nodes_count)]{};

  /// The same numbers as the readers of files return them.
  constexpr mechanics::flexible_data values() const {
    mechanics::flexible_data d(amplitudes);
    d.mass = mass;
    describe::copy_numbers(first_moment, d.first_moment.coefficients);
    describe::copy_numbers(inertia, d.inertia.coefficients);
    describe::copy_numbers(angular, d.angular.coefficients);
    describe::copy_numbers(modal_mass, d.modal_mass);
    describe::copy_numbers(stiffness, d.stiffness);
    describe::copy_numbers(damping, d.damping);
    describe::copy_numbers(preload, d.preload);
    for (int i = 0; i < elastic_terms_count; ++i) d.elastic_terms.push(elastic_terms[i]);
    for (int i = 0; i < damping_terms_count; ++i) d.damping_terms.push(damping_terms[i]);
    for (int i = 0; i < nodes_count; ++i) d.nodes.push(values_of(nodes[i]));
    return d;
  }
  /// The end of a sentence that reports a mistake in the elasticity, such as "has a negative stiffness";
  /// empty if there is none.
  constexpr std::string_view mistake_of_elasticity() const {
    for (std::size_t k = 0; k < count; ++k) {
      if (stiffness[k * (count + 1)] < 0) return "has an amplitude with a negative stiffness";
      if (damping[k * (count + 1)] < 0) return "has an amplitude with a negative damping";
    }
    bool valid = true;
    for (int i = 0; i < elastic_terms_count; ++i) valid = valid && elastic_terms[i].is_valid(amplitudes);
    for (int i = 0; i < damping_terms_count; ++i) valid = valid && damping_terms[i].is_valid(amplitudes);
    return valid ? std::string_view() : "has a term with an index of no amplitude";
  }
  /// The index of the node with the given name, or -1.
  constexpr int find_node(const base::name& called) const {
    for (int i = 0; i < nodes_count; ++i)
      if (nodes[i].called == called) return i;
    return -1;
  }
  static constexpr mechanics::flexible_node values_of(const node& from) {
    mechanics::flexible_node n{.called = from.called, .position = mechanics::taylor_series(3, amplitudes)};
    n.orientation.resize(9), n.rotation.resize(3 * amplitudes);
    describe::copy_numbers(from.position, n.position.coefficients);
    describe::copy_numbers(from.orientation, n.orientation);
    describe::copy_numbers(from.rotation, n.rotation);
    bool bends = false;
    for (const double each : from.second_rotation) bends = bends || each * each > 0;
    n.second_rotation.resize(bends ? 3 * amplitudes * amplitudes : 0);
    describe::copy_numbers(from.second_rotation, n.second_rotation);
    return n;
  }
};

} // namespace kanexpr
