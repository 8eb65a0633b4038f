#pragma once

#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// A component of a vector rotated about an axis: c a − s b or s a + c b, with c and s the cosine and sine of
/// an angle. Its derivative with respect to the angle is, up to sign, the other component, which usually
/// exists already. The chain rule through sine and cosine would need two more products.
struct turned_component {
  int angle = -1; ///< -1: not a rotated component
  /// The factors of the two products: a sine or cosine, and a value.
  int circular[2]{}, value[2]{};
  bool adds = false; ///< whether the second is added to the first

  constexpr explicit operator bool() const { return angle >= 0; }
};

constexpr turned_component turned_component_at(const graph& g, const node& n) {
  const auto is_circular = [&](int id) { return g[id].op == operation::sin || g[id].op == operation::cos; };
  turned_component found;
  if (n.op != operation::add && n.op != operation::subtract) return found;
  const node &first = g[n.a], &second = g[n.b];
  if (first.op != operation::multiply || second.op != operation::multiply) return found;
  for (int i = 0; i < 4; ++i) {
    const bool exchange_first = i % 2 != 0, exchange_second = i / 2 != 0;
    const int t = exchange_first ? first.b : first.a, w = exchange_second ? second.b : second.a;
    if (!is_circular(t) || !is_circular(w) || g[t].op == g[w].op || g[t].a != g[w].a) continue;
    found.angle = g[t].a;
    found.circular[0] = t, found.circular[1] = w;
    found.value[0] = exchange_first ? first.a : first.b;
    found.value[1] = exchange_second ? second.a : second.b;
    found.adds = n.op == operation::add;
    break;
  }
  return found;
}

/// The derivative with respect to the angle: a node, and whether its sign must be changed.
struct turned_slope {
  int value;
  bool is_negative;
};

constexpr turned_slope slope_by_angle(graph& g, const turned_component& x) {
  const int by_first = multiply(g, x.circular[1], x.value[0]),
            by_second = multiply(g, x.circular[0], x.value[1]);
  const bool begins_with_cosine = g[x.circular[0]].op == operation::cos;
  // c a + s b: c b − s a; c a − s b: −(s a + c b); s a + c b: c a − s b; s a − c b: c a + s b
  if (!x.adds) return {add(g, by_first, by_second), begins_with_cosine};
  if (begins_with_cosine) return {subtract(g, by_second, by_first), false};
  return {subtract(g, by_first, by_second), false};
}

} // namespace kanexpr::symbolic
