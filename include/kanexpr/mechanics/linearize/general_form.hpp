#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/partition.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// The equations of a system in the form from which it is linearized, for either method:
///
///     f_c(q,t) = 0                  l configuration constraints
///     f_v(q,u,t) = 0                m velocity constraints
///     f_a(q,q̇,u,u̇,t) = 0            their rates
///     f_0(q,q̇,t) + f_1(q,u,t) = 0   n kinematic differential equations
///     f_2(q,u,u̇,t) + f_3(q,q̇,u,r,t) + f_4(q,λ,t) = 0   o−m+k dynamic differential equations
///
/// for n coordinates q, o speeds u, k multipliers λ and s inputs r; constraints may depend on r as well.
/// Peterson, Gede & Hubbard, Symbolic linearization of equations of motion of constrained multibody systems,
/// Multibody System Dynamics 33 (2015).
struct general_form {
  sequence<expression> q{}, u{}, lambda{}, r{}; ///< symbols
  sequence<expression> qdot{}, udot{};          ///< the symbols of the rates of q and u
  partition coordinates{}, speeds{};            ///< their dependent and independent parts
  sequence<expression> f_c{}, f_v{}, f_a{}, f_0{}, f_1{}, f_2{}, f_3{}, f_4{};

  /// Linear parts of these equations that the derivation already provides; empty ones are formed when needed.
  struct linear_parts {
    sequence<expression> qdot{};   ///< q̇ from f_0 + f_1 = 0
    symbolic::matrix on_q{};       ///< ∂f_c/∂q
    symbolic::matrix on_u{};       ///< ∂f_v/∂u
    symbolic::matrix on_udot{};    ///< ∂f_a/∂u̇
    symbolic::matrix dependency{}; ///< ∂u̇_d/∂u̇_i from f_a = 0
    symbolic::matrix coupling{};   ///< (∂f_2/∂u̇_d)ᵀ
    symbolic::matrix mass{};       ///< ∂f_2/∂u̇_i with the dependent rates eliminated; symmetric
  };
  linear_parts known{};

  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.q, self.u, self.lambda, self.r, self.qdot, self.udot, self.coordinates, self.speeds, self.f_c,
          self.f_v, self.f_a, self.f_0, self.f_1, self.f_2, self.f_3, self.f_4, self.known);
  }

  constexpr int states() const { return coordinates.independent.size() + speeds.independent.size(); }
  constexpr int inputs() const { return r.size(); }
  /// The number of rates q̇ and u̇ and multipliers, n + o + k.
  constexpr int unknowns() const { return q.size() + u.size() + lambda.size(); }
};

constexpr sequence<expression> negative(sequence<expression> list) {
  for (expression& e : list) e = -e;
  return list;
}

/// The sum of two lists, either of which may be empty.
constexpr sequence<expression> summed(const sequence<expression>& a, const sequence<expression>& b) {
  if (a.empty()) return b;
  sequence<expression> sum = a;
  for (int i = 0; i < b.size(); ++i) sum[i] += b[i];
  return sum;
}

} // namespace kanexpr::mechanics
