#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/value_order.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::lower {

using symbolic::graph;
using symbolic::operation;

/// Orders the nodes of a graph so that few of their values are live simultaneously (value_order).
///
/// Products used by only one sum directly precede it, because processors can contract a product and a sum
/// into one operation. Symmetric systems wait until nothing else is available.
template <bool is_constant>
class step_order {
public:
  /// Orders the `count` nodes in `live`, except leaves and nodes that already have a slot (stored as one
  /// more).
  constexpr step_order(const graph& g, const base::zeros<int>& live, int count,
                       const base::zeros<int>& slot_of, const sequence<int>& results)
      : g_(g), places_(g.size()), ids_(count), order_(count), all_(count, 2 * count) {
    const auto& nodes = g.elements<is_constant>();
    const auto& lives = live.elements<is_constant>();
    const auto& slot_at = slot_of.elements<is_constant>();
    auto& place = places_.elements<is_constant>();
    auto& own = ids_.elements<is_constant>();
    auto& when = all_.turns.elements<is_constant>();
    int values = 0;
    for (int i = 0; i < count; ++i) {
      const int id = lives[i];
      const operation op = nodes[id].op;
      if (op <= operation::symbol) continue;
      if (slot_at[id] != 0)
        when[values] = turn::done;
      else if (op == operation::pair)
        when[values] = turn::list;
      else if (op == operation::symmetric_solve)
        when[values] = turn::last;
      own[values] = id;
      place[id] = ++values;
    }
    all_.count = values;
    join_products(results);
    list_operands();
  }

  /// Returns the nodes in order.
  constexpr const base::zeros<int>& run() {
    size_ = value_order<is_constant>(all_).put_all(order_, 0);
    auto& order = order_.elements<is_constant>();
    const auto& own = ids_.elements<is_constant>();
    for (int i = 0; i < size_; ++i) order[i] = own[order[i]];
    return order_;
  }
  constexpr int size() const { return size_; }

private:
  static constexpr int none = -1;

  static constexpr bool has_second_operand(operation op) {
    return op <= operation::power ? op != operation::negate
                                  : symbolic::is_binary(op) && !symbolic::has_index_operand(op);
  }

  /// Joins products that only one sum uses; a result counts as used by the caller.
  constexpr void join_products(const sequence<int>& results) {
    const auto& nodes = g_.elements<is_constant>();
    const auto& place = places_.elements<is_constant>();
    const auto& own = ids_.elements<is_constant>();
    base::zeros<int> all_uses(all_.count), uses_in_sums(all_.count);
    auto &uses = all_uses.elements<is_constant>(), &in_sums = uses_in_sums.elements<is_constant>();
    for (int id : results)
      if (place[id] != 0) ++uses[place[id] - 1];
    for (int k = 0; k < all_.count; ++k) {
      const int id = own[k];
      const operation op = nodes[id].op;
      const bool is_sum = op == operation::add || op == operation::subtract;
      const int a = nodes[id].a, first = place[a];
      if (first != 0) {
        ++uses[first - 1];
        if (is_sum && nodes[a].op == operation::multiply) ++in_sums[first - 1];
      }
      if (op > operation::power ? !has_second_operand(op) : op == operation::negate) continue;
      const int b = nodes[id].b, second = place[b];
      if (second == 0) continue;
      ++uses[second - 1];
      if (is_sum && nodes[b].op == operation::multiply) ++in_sums[second - 1];
    }
    auto& when = all_.turns.elements<is_constant>();
    for (int k = 0; k < all_.count; ++k)
      if (in_sums[k] == 1 && uses[k] == 1 && when[k] == turn::by_rank) when[k] = turn::joined;
  }

  /// Lists the operands of every value, including those of joined products.
  constexpr void list_operands() {
    const auto& nodes = g_.elements<is_constant>();
    const auto& place = places_.elements<is_constant>();
    const auto& own = ids_.elements<is_constant>();
    const auto& when = all_.turns.elements<is_constant>();
    auto& first_operand = all_.first_operands.elements<is_constant>();
    auto& operands = all_.operands.elements<is_constant>();
    int listed = 1;
    for (int k = 0; k < all_.count; ++k) {
      if (when[k] >= turn::joined) continue;
      const int id = own[k], a = nodes[id].a;
      int open[4]{a}, count = 1; // the operands that remain to be listed, the last one first
      if (const operation op = nodes[id].op;
          (op > operation::power ? has_second_operand(op) : op != operation::negate) && nodes[id].b != a)
        open[0] = nodes[id].b, open[1] = a, count = 2;
      for (int i = 0; i < count; ++i) {
        const int operand = place[open[i]] - 1;
        if (operand != none && when[operand] == turn::joined)
          operands[listed++] = unordered_values::joined(operand);
      }
      const int first = first_operand[k] = listed;
      while (count > 0) {
        const int each = open[--count], operand = place[each] - 1;
        if (operand == none) continue; // not computed by a step
        if (when[operand] == turn::joined) {
          open[count++] = nodes[each].b, open[count++] = nodes[each].a;
          continue;
        }
        int i = first;
        while (i < listed && operands[i] != operand) ++i;
        if (i == listed) operands[listed++] = operand;
      }
      operands[listed++] = unordered_values::end;
    }
  }

  const graph& g_;
  base::zeros<int> places_; ///< by node: one more than its number among the values
  base::zeros<int> ids_;    ///< by value: its node
  base::zeros<int> order_;
  unordered_values all_;
  int size_ = 0; ///< the number of nodes in order
};

} // namespace kanexpr::lower
