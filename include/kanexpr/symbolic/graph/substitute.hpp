#pragma once

#include <kanexpr/base/zeros.hpp>
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
  // precedes its callers, because clang++ does not instantiate a template for a constant expression if it is
  // declared later in the class
  template <class Nodes, class Marks>
  static constexpr void visit(const Nodes& nodes, Marks& changes, int first, int last) {
    for (int id = first; id <= last; ++id) {
      const operation op = nodes[id].op;
      if (op <= operation::symbol) continue; // a leaf
      const bool has_second = op > operation::negate && (op <= operation::power || is_binary(op));
      if (changes[nodes[id].a] != 0 || (has_second && changes[nodes[id].b] != 0)) changes[id] = 1;
    }
  }

public:
  constexpr explicit substitution(graph& g) : graph_(g) {}
  substitution(const substitution&) = delete;
  substitution& operator=(const substitution&) = delete;

  /// Registers a replacement; must be called before the first call of `in`.
  constexpr void replace(expression old, expression by) {
    make_room();
    const int id = old.node();
    image_[id] = by.node() + 1;
    change_[id] = 1;
    if (id < visited_) visited_ = id;
  }

  constexpr expression in(expression e) {
    visit_until(e.node());
    return {graph_, in(e.node())};
  }

private:
  static constexpr int unknown = 0;            ///< images are stored as one more than their node
  static constexpr int unvisited = 0x7fffffff; ///< no node was replaced

  constexpr void make_room() {
    if (images_.size() >= graph_.size()) return;
    constexpr int room = base::zeros<int>::room;
    images_.grow(__builtin_is_constant_evaluated() && graph_.size() < room ? room : 2 * graph_.size());
    changes_.grow(images_.size());
    image_ = images_.begin();
    change_ = changes_.begin();
  }

  /// Finds the nodes that depend on replaced ones, so that only these are visited.
  constexpr void visit_until(int last) {
    make_room();
    if (visited_ > last) return;
    if (__builtin_is_constant_evaluated())
      visit(graph_.elements<true>(), changes_.elements<true>(), visited_, last);
    else
      visit(graph_.elements<false>(), changes_.elements<false>(), visited_, last);
    visited_ = last + 1;
  }
  constexpr int in(int id) {
    if (change_[id] == 0) return id;
    if (image_[id] != unknown) return image_[id] - 1;
    const node n = graph_.begin()[id];
    const int a = change_[n.a] != 0 ? in(n.a) : n.a;
    int b = 0;
    if (is_binary(n.op)) b = change_[n.b] != 0 ? in(n.b) : n.b;
    const int image = a != n.a || b != n.b ? build(graph_, n.op, a, b) : id;
    make_room();
    image_[id] = image + 1;
    return image;
  }

  graph& graph_;
  base::zeros<int> images_{};
  base::zeros<char> changes_{};
  int* image_ = nullptr;    ///< by node
  char* change_ = nullptr;  ///< by node: whether it depends on a replaced one
  int visited_ = unvisited; ///< no earlier node was replaced
};

} // namespace kanexpr::symbolic
