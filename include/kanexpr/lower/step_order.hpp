#pragma once

#include <kanexpr/symbolic/graph/graph.hpp>

namespace kanexpr::lower {

using symbolic::graph;
using symbolic::operation;
using symbolic::sequence;

/// Puts nodes in an order in which few values are held at once, so that more of them stay in registers.
///
/// Of the nodes whose operands are there, the next is always one that is the last to use the most values; of
/// equals, the first in the graph. Products that nothing but one sum uses stand just before it, as processors
/// do a product and a sum in one operation. It looks into arrays directly, as compilers interpret every call.
class step_order {
public:
  /// Of the `live` nodes, in the order of the graph, without leaves and those that have a slot already.
  constexpr step_order(const graph& g, const sequence<int>& live, const sequence<int>& slot_of,
                       const sequence<int>& results)
      : nodes_(g.begin()), slot_(slot_of.begin()), uses_of_(g.size() + 1, 0), waits_for_(g.size(), 0),
        first_user_of_(g.size() + 1, 0), rank_of_(g.size(), none), uses_(uses_of_.begin()),
        waits_(waits_for_.begin()), first_user_(first_user_of_.begin()), rank_(rank_of_.begin()) {
    for (int id : live)
      if (slot_[id] == none && nodes_[id].op > operation::symbol) steps_.push(id);
    for (int id : results) ++uses_[id];
    join_products();
    list_users();
  }
  step_order(const step_order&) = delete;
  step_order& operator=(const step_order&) = delete;

  constexpr sequence<int> run() {
    for (int id : steps_)
      if (rank_[id] != joined && waits_[id] == 0) offer(id);
    while (true) {
      const int id = take();
      if (id == none) return static_cast<sequence<int>&&>(order_);
      put(id);
    }
  }

private:
  static constexpr int none = -1, joined = -2, done = -3;
  static constexpr int ranks = 6; ///< a step ends the use of up to four values, and is one or none itself

  /// What a step is made of, with the products that are joined to it, each value once.
  struct operands {
    int count = 0;
    int id[4]{};

    constexpr void add(int operand) {
      for (int i = 0; i < count; ++i)
        if (id[i] == operand) return;
      id[count++] = operand;
    }
  };

  constexpr void add_operand(operands& all, int id) const {
    if (nodes_[id].op <= operation::symbol) return; // no step gives it
    if (rank_[id] == joined)
      add_operands(all, id);
    else
      all.add(id);
  }
  constexpr void add_operands(operands& all, int id) const {
    const symbolic::node& n = nodes_[id];
    add_operand(all, n.a);
    if (symbolic::is_binary(n.op) && !symbolic::is_numbered(n.op)) add_operand(all, n.b);
  }
  constexpr operands operands_of(int id) const {
    operands all;
    add_operands(all, id);
    return all;
  }

  constexpr void join_products() {
    for (int id : steps_) {
      const operands all = operands_of(id);
      for (int i = 0; i < all.count; ++i) ++uses_[all.id[i]];
    }
    for (int id : steps_) {
      const symbolic::node& n = nodes_[id];
      if (n.op != operation::add && n.op != operation::subtract) continue;
      for (int product : {n.a, n.b})
        if (nodes_[product].op == operation::multiply && uses_[product] == 1 && slot_[product] == none)
          rank_[product] = joined;
    }
  }

  /// For each value those that use it, one after another.
  constexpr void list_users() {
    const int end = uses_of_.size();
    for (int id = 0; id < end; ++id) uses_[id] = 0;
    for (int id : steps_) {
      if (rank_[id] == joined) continue;
      const operands all = operands_of(id);
      for (int i = 0; i < all.count; ++i) {
        ++uses_[all.id[i]];
        if (slot_[all.id[i]] == none) ++waits_[id];
      }
    }
    int place = 0;
    for (int id = 0; id + 1 < end; ++id) {
      first_user_[id] = place;
      place += uses_[id];
    }
    first_user_[end - 1] = place;
    users_of_.resize(place);
    users_ = users_of_.begin();
    sequence<int> filled(end, 0);
    int* const count = filled.begin();
    for (int id : steps_) {
      if (rank_[id] == joined) continue;
      const operands all = operands_of(id);
      for (int i = 0; i < all.count; ++i) users_[first_user_[all.id[i]] + count[all.id[i]]++] = id;
    }
  }

  /// How many values fewer there are after a step, and one.
  constexpr int rank_now(int id) const {
    const operands all = operands_of(id);
    int rank = uses_[id] > 0 ? 0 : 1;
    for (int i = 0; i < all.count; ++i) rank += uses_[all.id[i]] == 1;
    return rank;
  }

  constexpr void offer(int id) { offer(id, rank_now(id)); }
  constexpr void offer(int id, int rank) {
    rank_[id] = rank;
    sequence<int>& heap = ready_[rank];
    int place = heap.push(id);
    int* const all = heap.begin();
    for (; place > 0 && all[(place - 1) / 2] > id; place = (place - 1) / 2) all[place] = all[(place - 1) / 2];
    all[place] = id;
  }

  /// The best that is ready; what has changed its rank since stands in another list too.
  constexpr int take() {
    for (int rank = ranks - 1; rank >= 0; --rank)
      while (!ready_[rank].empty()) {
        const int id = first_of(ready_[rank]);
        if (rank_[id] == rank) return id;
      }
    return none;
  }

  static constexpr int first_of(sequence<int>& heap) {
    int* const all = heap.begin();
    const int first = all[0], last = heap.back();
    heap.pop();
    const int size = heap.size();
    int place = 0;
    for (int child = 1; child < size; child = 2 * place + 1) {
      if (child + 1 < size && all[child + 1] < all[child]) ++child;
      if (all[child] >= last) break;
      all[place] = all[child];
      place = child;
    }
    if (size > 0) all[place] = last;
    return first;
  }

  constexpr void put(int id) {
    const operands all = operands_of(id);
    push(id);
    for (int i = 0; i < all.count; ++i)
      if (--uses_[all.id[i]] == 1) favour_last_user_of(all.id[i]);
    for (int i = first_user_[id]; i < first_user_[id + 1]; ++i)
      if (--waits_[users_[i]] == 0) offer(users_[i]);
  }

  constexpr void push(int id) {
    const symbolic::node& n = nodes_[id];
    if (n.op == operation::add || n.op == operation::subtract)
      for (int product : {n.a, n.b})
        if (rank_[product] == joined) push(product);
    order_.push(id);
    rank_[id] = done;
  }

  constexpr void favour_last_user_of(int value) {
    for (int i = first_user_[value]; i < first_user_[value + 1]; ++i) {
      const int user = users_[i];
      if (rank_[user] == done) continue;
      if (rank_[user] >= 0) offer(user, rank_[user] + 1);
      return;
    }
  }

  const symbolic::node* nodes_;
  const int* slot_;
  sequence<int> steps_{}; ///< to be ordered
  sequence<int> uses_of_, waits_for_, first_user_of_, rank_of_;
  sequence<int> users_of_{};
  sequence<int> ready_[ranks]{};
  sequence<int> order_{};
  int* uses_;       ///< that are left, by value
  int* waits_;      ///< operands that are not there yet, by step
  int* first_user_; ///< where the users of a value begin
  int* rank_;       ///< of what is ready; else why it is not
  int* users_ = nullptr;
};

} // namespace kanexpr::lower
