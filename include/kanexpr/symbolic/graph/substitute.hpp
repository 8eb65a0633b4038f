#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::symbolic {

/// Replaces nodes by others, everywhere at once, and simplifies on the way.
class substitution {
public:
  constexpr explicit substitution(graph& g) : graph_(g) {}

  /// To be set before the first `in`.
  constexpr void replace(expression old, expression by) { remember(old.node(), by.node()); }

  constexpr expression in(expression e) { return {graph_, in(e.node())}; }

private:
  static constexpr int unknown = -1;

  constexpr void remember(int id, int by) {
    if (images_.size() <= id) images_.resize(graph_.size() + 64, unknown);
    images_[id] = by;
  }

  constexpr int in(int id) {
    if (id < images_.size() && images_[id] != unknown) return images_[id];
    const node n = graph_[id];
    int image = id;
    if (!is_leaf(n.op)) {
      const int a = in(n.a);
      const int b = is_binary(n.op) ? in(n.b) : 0;
      if (a != n.a || b != n.b) image = build(graph_, n.op, a, b);
    }
    remember(id, image);
    return image;
  }

  graph& graph_;
  sequence<int> images_{};
};

} // namespace kanexpr::symbolic
