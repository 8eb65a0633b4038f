#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// The replacement of a symbol: a number, or an expression in the remaining symbols.
struct replacement {
  expression symbol;
  expression by;
};

/// Replaces nodes throughout an expression simultaneously and simplifies the result.
class substitution {
public:
  constexpr explicit substitution(graph& g) : graph_(g) {}
  substitution(const substitution&) = delete;
  substitution& operator=(const substitution&) = delete;

  /// Registers a replacement; must be called before the first call of `in`.
  constexpr void replace(expression old, expression by) { remember(old.node(), by.node()); }

  constexpr expression in(expression e) { return {graph_, in(e.node())}; }

private:
  static constexpr int unknown = -1;

  constexpr void remember(int id, int by) {
    if (known_ <= id) make_room();
    image_[id] = by;
  }
  constexpr void make_room() {
    known_ = graph_.size() + 64;
    images_.resize(known_, unknown);
    image_ = images_.begin();
  }

  constexpr int in(int id) {
    if (id < known_ && image_[id] != unknown) return image_[id];
    const node n = graph_[id];
    int image = id;
    if (n.op > operation::symbol) { // compilers interpret every call
      const int a = n.a < known_ && image_[n.a] != unknown ? image_[n.a] : in(n.a);
      int b = 0;
      if (is_binary(n.op)) b = n.b < known_ && image_[n.b] != unknown ? image_[n.b] : in(n.b);
      if (a != n.a || b != n.b) image = build(graph_, n.op, a, b);
    }
    if (known_ <= id) make_room();
    return image_[id] = image;
  }

  graph& graph_;
  sequence<int> images_{};
  int* image_ = nullptr; ///< by node
  int known_ = 0;        ///< number of nodes whose entries are valid or `unknown`
};

} // namespace kanexpr::symbolic
