#pragma once

#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic::detail {

/// The factors of nested products, sorted by node number; none if there are too many.
struct factors_of {
  static constexpr int most = 8;
  int factor[most]{};
  int count = 0;

  constexpr factors_of(const graph& g, int product) {
    take(g, product);
    if (count > most) count = 0;
  }
  constexpr bool operator==(const factors_of& other) const {
    if (count != other.count || count == 0) return false;
    for (int i = 0; i < count; ++i)
      if (factor[i] != other.factor[i]) return false;
    return true;
  }

private:
  constexpr void take(const graph& g, int id) {
    const node& n = g[id];
    if (n.op == operation::multiply) {
      take(g, n.a);
      if (count <= most) take(g, n.b);
    } else if (count++ < most) {
      int place = count - 1;
      for (; place > 0 && factor[place - 1] > id; --place) factor[place] = factor[place - 1];
      factor[place] = id;
    }
  }
};

/// Whether a and b are products of the same factors, possibly grouped differently.
constexpr bool is_same_product(const graph& g, int a, int b) {
  const node &x = g[a], &y = g[b];
  if (x.op != operation::multiply || y.op != operation::multiply) return false;
  const auto is_nested = [&](const node& n) {
    return g[n.a].op == operation::multiply || g[n.b].op == operation::multiply;
  };
  return is_nested(x) && is_nested(y) && factors_of(g, a) == factors_of(g, b);
}

} // namespace kanexpr::symbolic::detail
