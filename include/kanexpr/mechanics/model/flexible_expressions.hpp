#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <cstddef>
#include <type_traits>

namespace kanexpr::mechanics {

/// Forms the expressions of a flexible body from its numbers.
class flexible_expressions {
  /// The product of a coefficient and amplitudes; above its uses, where clang++ needs it for constant
  /// expressions.
  template <std::size_t count>
  constexpr expression product(double coefficient, const int (&amplitudes)[count]) const {
    expression value = number(coefficient);
    for (const int k : amplitudes)
      if (k >= 0) value = value * q_[k];
    return value;
  }

public:
  /// The body has at least one amplitude.
  constexpr flexible_expressions(const flexible_data& data, const sequence<expression>& amplitudes)
      : data_(data), q_(amplitudes), g_(amplitudes[0].owner()) {}

  constexpr flexible_body body(const base::name& called, int frame, int reference) const {
    flexible_body b{.called = called, .frame = frame, .reference = reference, .amplitudes = q_};
    b.mass = number(data_.mass);
    b.first_moment = vector_of(data_.first_moment, 0);
    const auto entry = [&](int e) { return value_of(data_.inertia, e); };
    b.inertia.xx = entry(0), b.inertia.yy = entry(1), b.inertia.zz = entry(2);
    b.inertia.xy = entry(3), b.inertia.yz = entry(4), b.inertia.zx = entry(5);
    for (int k = 0; k < size(); ++k) b.angular.push(vector_of(data_.angular, 3 * k));
    b.modal_mass = matrix_of(data_.modal_mass);
    if (!std::is_constant_evaluated()) b.nodes.all = data_.nodes;
    return b;
  }

  constexpr symbolic::matrix stiffness() const { return matrix_of(data_.stiffness); }
  constexpr symbolic::matrix damping() const {
    symbolic::matrix d = matrix_of(data_.damping);
    for (const damping_term& t : data_.damping_terms) {
      const expression value = product(t.coefficient, t.amplitudes);
      d(t.row, t.column) += value;
      if (t.row != t.column) d(t.column, t.row) += value;
    }
    return d;
  }

  /// The energy of the reference stresses, f·q, and the terms of higher than second order.
  constexpr expression further_energy() const {
    expression energy = zero();
    for (int k = 0; k < size(); ++k) energy += number(data_.preload[k]) * q_[k];
    for (const elastic_term& t : data_.elastic_terms) energy += product(t.coefficient, t.amplitudes);
    return energy;
  }

  /// The position of a node from the reference point.
  constexpr components position(const flexible_node& node) const { return vector_of(node.position, 0); }

  /// The modified Rodrigues parameters of the rotation at a node: a quarter of the rotation vector, which
  /// equals them to the second order.
  constexpr components turn(const flexible_node& node) const {
    components quarter(g_);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < size() && !node.rotation.empty(); ++k)
        quarter[i] += number(node.rotation[3 * k + i] / 4) * q_[k];
      for (int k = 0; k < size() && !node.second_rotation.empty(); ++k)
        for (int l = 0; l <= k; ++l) {
          const double second = node.second_rotation[3 * (k * size() + l) + i];
          quarter[i] += number(second / (l == k ? 8 : 4)) * (q_[k] * q_[l]);
        }
    }
    return quarter;
  }

  /// The direction cosines of the axes of a node in the undeformed body.
  constexpr matrix3 orientation(const flexible_node& node) const {
    matrix3 cosines;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        cosines(i, j) = number(node.orientation.empty() ? i == j : node.orientation[3 * i + j]);
    return cosines;
  }

private:
  constexpr int size() const { return q_.size(); }
  constexpr expression zero() const { return {g_, graph::zero}; }
  constexpr expression number(double value) const { return symbolic::constant(g_, symbolic::real(value)); }

  /// c + Σ_k q_k (c_k + ½ c_kk q_k + Σ_{l < k} c_kl q_l).
  constexpr expression value_of(const taylor_series& f, int i) const {
    expression sum = number(f.constant(i));
    for (int k = 0; k < size(); ++k) {
      expression factor = number(f.linear(k, i));
      for (int l = 0; l <= k && f.has_quadratic(); ++l)
        factor += number(f.quadratic(k, l, i) / (l == k ? 2 : 1)) * q_[l];
      sum += q_[k] * factor;
    }
    return sum;
  }

  /// The vector whose components begin at quantity `first`.
  constexpr components vector_of(const taylor_series& f, int first) const {
    components v;
    for (int i = 0; i < 3; ++i) v[i] = value_of(f, first + i);
    return v;
  }

  constexpr symbolic::matrix matrix_of(const sequence<double>& entries) const {
    symbolic::matrix m(g_, size(), size());
    for (int i = 0; i < entries.size(); ++i) m.entries[i] = number(entries[i]);
    return m;
  }

  const flexible_data& data_;
  const sequence<expression>& q_;
  graph& g_;
};

} // namespace kanexpr::mechanics
