#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::mechanics {

/// The amplitudes of beams, whose units are expected, and their rates. Numbers by which they are multiplied
/// are values of shapes and their derivatives, which have units.
class deformation_amplitudes {
public:
  constexpr void mark(const mechanism& m) {
    for (const expected_unit& each : m.expected_units)
      if (const int place = m.coordinates.find(each.value); place >= 0) {
        nodes_.push(m.coordinates[place].node());
        nodes_.push(m.coordinate_rates[place].node());
      }
    if (nodes_.empty()) return;
    for (const expression& e : m.kinematics) // the speeds that are rates of amplitudes
      if (const symbolic::node& n = (*m.g)[e.node()];
          n.op == symbolic::operation::subtract && nodes_.contains(n.a))
        nodes_.push(n.b);
  }

  /// Whether an expression is a polynomial in the amplitudes.
  constexpr bool form(const symbolic::graph& g, int id) const {
    using symbolic::operation;
    if (nodes_.empty()) return false;
    const symbolic::node& n = g[id];
    const auto fits = [&](int operand) { return g.is_constant(operand) || form(g, operand); };
    if (n.op == operation::symbol) return nodes_.contains(id);
    if (n.op == operation::negate) return form(g, n.a);
    if (n.op == operation::divide || n.op == operation::power) return form(g, n.a) && g.is_constant(n.b);
    const bool is_any = n.op == operation::add || n.op == operation::subtract || n.op == operation::multiply;
    return is_any && fits(n.a) && fits(n.b);
  }

private:
  sequence<int> nodes_{};
};

} // namespace kanexpr::mechanics
