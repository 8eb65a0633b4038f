#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/linear/cofactors.hpp>

namespace kanexpr::symbolic {

namespace detail {

/// The uses of one factorization.
struct solves_of_factors {
  int factorization = 0;
  sequence<int> solutions{};
  int results = 0; ///< number of solution components used
  bool measured = false;
  cofactors::method method{};
};

/// Rewrites the solutions of small systems and of constant systems as ordinary operations. Nodes are visited
/// in ascending order, so operands precede their users.
class expansion {
  // precedes its callers, because clang++ does not instantiate a template for a constant expression if it is
  // declared later in the class
  template <class List, class Marks, class Images>
  constexpr void expand(const List& listed, const Marks& live, Images& image) {
    for (int i = live_.count - 1; i >= 0; --i) {
      const int id = listed[i];
      image[id] = id;
      const node n = g_[id];
      if (n.op <= operation::symbol) continue;
      const int a = image[n.a], b = !is_binary(n.op) ? 0 : live[n.b] != 0 ? image[n.b] : n.b;
      if (n.op == operation::component && is_solution(g_[n.a].op))
        image[id] = element(n, a);
      else if (n.op == operation::singularity_measure && is_small(n.a))
        image[id] = measure(n, a);
      else if (a != n.a || b != n.b)
        image[id] = build(g_, n.op, a, b);
    }
  }

public:
  /// `live` must outlive it.
  constexpr expansion(graph& g, const live_list& live_nodes)
      : g_(g), live_(live_nodes), image_(g.size()), uses_of_(g.size()) {
    const int* const live = live_.nodes.begin();
    const node* const nodes = g.begin();
    for (int i = live_.count - 1; i >= 0; --i)
      if (nodes[live[i]].op > operation::pair) collect(live[i]);
    for (solves_of_factors& uses : uses_)
      if (is_small(uses.factorization)) uses.method = cheapest(uses);
  }

  constexpr int operator[](int id) const { return image_[id]; }

  constexpr void run() {
    if (__builtin_is_constant_evaluated())
      expand(live_.nodes.elements<true>(), live_.marks.elements<true>(), image_.elements<true>());
    else
      expand(live_.nodes.elements<false>(), live_.marks.elements<false>(), image_.elements<false>());
  }

private:
  constexpr bool is_small(int factorization) const {
    return order_of(g_, factorization) <= max_cofactor_order;
  }

  constexpr void collect(int id) {
    const node& n = g_[id];
    if (n.op == operation::factorization) {
      uses_of_[id] = uses_.size();
      uses_.push({id, {}, 0, false, {}});
    } else if (is_solution(n.op)) {
      uses_[uses_of_[n.a]].solutions.push(id);
    } else if (n.op == operation::component && is_solution(g_[n.a].op)) {
      ++uses_[uses_of_[g_[n.a].a]].results;
    } else if (n.op == operation::singularity_measure) {
      uses_[uses_of_[n.a]].measured = true;
    }
  }

  /// Tries all methods on a separate graph in which symbols represent the entries.
  constexpr cofactors::method cheapest(const solves_of_factors& uses) {
    const int order = order_of(g_, uses.factorization);
    const auto entries = placeholder_symbols(entries_of(g_, uses.factorization));
    sequence<sequence<int>> right;
    bool has_plain = false, has_transposed = false;
    for (int id : uses.solutions) {
      right.push(placeholder_symbols(elements_of(g_, g_[id].b)));
      (g_[id].op == operation::solve ? has_plain : has_transposed) = true;
    }
    cofactors::method best;
    int least = -1;
    for (const cofactors::method& each : cofactors::all(order, has_plain, has_transposed)) {
      cofactors by(trial_, entries, order, each, uses.results);
      sequence<int> outputs;
      if (uses.measured) outputs.push(by.determinant());
      for (int i = 0; i < right.size(); ++i)
        for (int j = 0; j < order; ++j)
          if (is_needed(uses.solutions[i], j))
            outputs.push(by.component(right[i], j, g_[uses.solutions[i]].op == operation::transposed_solve));
      const int weight = operation_cost(outputs);
      if (least < 0 || weight < least) best = each, least = weight;
    }
    return best;
  }

  constexpr bool is_needed(int solution, int index) const {
    const int index_node = g_.find_constant(exactly(index));
    const int id = index_node < 0 ? -1 : g_.find({operation::component, solution, index_node});
    return id >= 0 && id < live_.marks.size() && live_.marks[id] != 0;
  }

  constexpr sequence<int> placeholder_symbols(sequence<int> nodes) {
    for (int& id : nodes) {
      const bool negative = g_[id].op == operation::negate;
      if (g_.is_constant(id)) {
        id = trial_.constant(g_.number_at(id));
      } else {
        const int symbol = trial_.find_or_append({operation::symbol, negative ? g_[id].a : id, 0});
        id = negative ? negate(trial_, symbol) : symbol;
      }
    }
    return nodes;
  }

  constexpr int operation_cost(const sequence<int>& outputs) const {
    constexpr int division = 4;
    const live_list needed(trial_, outputs);
    const int* const live = needed.nodes.begin();
    const node* const nodes = trial_.begin();
    int weight = 0;
    for (int i = 0; i < needed.count; ++i) {
      const operation op = nodes[live[i]].op;
      if (op > operation::negate) weight += op == operation::divide ? division : 1;
    }
    return weight;
  }

  constexpr int element(const node& n, int solution) {
    const int index = integer_at(g_, n.b);
    if (solution == graph::zero) return graph::zero;
    const node all = g_[solution];
    const sequence<int> right = elements_of(g_, all.b), entries = entries_of(g_, all.a);
    const bool transposed = all.op == operation::transposed_solve;
    const int order = right.size();
    if (order <= max_cofactor_order) {
      const solves_of_factors& uses = uses_[uses_of_[g_[n.a].a]];
      return cofactors(g_, entries, order, uses.method, uses.results).component(right, index, transposed);
    }
    if (inverted_ != all.a) inverse_ = constant_inverse(g_, all.a);
    inverted_ = all.a;
    if (inverse_.empty()) return component(g_, solution, index);
    int sum = graph::zero;
    for (int j = 0; j < order; ++j) {
      const number& weight = inverse_[transposed ? j * order + index : index * order + j];
      sum = add(g_, sum, multiply(g_, g_.constant(weight), right[j]));
    }
    return sum;
  }

  constexpr int measure(const node& n, int factorization) {
    const sequence<int> entries = entries_of(g_, factorization);
    const cofactors by(g_, entries, order_of(g_, factorization), uses_[uses_of_[n.a]].method, 0);
    return apply(g_, operation::abs, by.determinant());
  }

  graph& g_;
  const live_list& live_;
  base::zeros<int> image_;
  base::zeros<int> uses_of_; ///< by node of the factorization
  sequence<solves_of_factors> uses_{};
  graph trial_{};
  int inverted_ = -1; ///< the constant matrix inverted last
  sequence<number> inverse_{};
};

template <class Nodes, class List>
constexpr bool has_factorization(const Nodes& nodes, const List& live, int count) {
  for (int i = 0; i < count; ++i)
    if (nodes[live[i]].op == operation::factorization) return true;
  return false;
}

} // namespace detail

/// Whether any live node requires `expand_solves`.
constexpr bool has_linear_systems(const graph& g, const live_list& live) {
  if (!g.has_lists()) return false;
  return __builtin_is_constant_evaluated()
             ? detail::has_factorization(g.elements<true>(), live.nodes.elements<true>(), live.count)
             : detail::has_factorization(g.elements<false>(), live.nodes.elements<false>(), live.count);
}

/// Rewrites the outputs so that systems of order 1 to 3 are solved by cofactors, with one determinant and its
/// reciprocal for all right-hand sides. Larger systems are kept. `live` are the live nodes of the outputs.
constexpr sequence<int> expand_solves(graph& g, const sequence<int>& outputs, const live_list& live) {
  detail::expansion expanded(g, live);
  expanded.run();
  sequence<int> images;
  for (int id : outputs) images.push(expanded[id]);
  return images;
}
constexpr sequence<int> expand_solves(graph& g, const sequence<int>& outputs) {
  return expand_solves(g, outputs, live_list(g, outputs));
}

} // namespace kanexpr::symbolic
