#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/symbolic/graph/build.hpp>
#include <kanexpr/symbolic/graph/canonical_order.hpp>

#include <optional>
#include <type_traits>

namespace kanexpr::runtime {

/// Calls `use` with each expression of a system, in the order of its members.
template <class Use>
class each_expression {
public:
  explicit each_expression(const Use& use) : use_(use) {}

  template <class T>
  void operator()(T& part) const {
    if constexpr (std::is_scalar_v<T>)
      return;
    else if constexpr (requires { T::each_member(part, *this); })
      T::each_member(part, *this);
    else
      for_each_member(part, *this);
  }
  template <class T>
  void operator()(symbolic::sequence<T>& parts) const {
    for (T& each : parts) (*this)(each);
  }
  template <class T>
  void operator()(std::optional<T>& part) const {
    if (part) (*this)(*part);
  }
  void operator()(symbolic::expression& e) const { use_(e); }
  void operator()(symbolic::name&) const {}

private:
  const Use& use_;
};

/// Nodes of one graph, and what their expressions need, in another. They are numbered by what they are.
inline symbolic::sequence<int> copied(const symbolic::graph& from, const symbolic::sequence<int>& wanted,
                                      symbolic::graph& to) {
  using symbolic::operation;
  for (const symbolic::external_function* f : from.externals()) to.externals().push(f);
  symbolic::sequence<int> place(from.size(), symbolic::graph::zero);
  const symbolic::sequence<int> order = symbolic::users_first(from, wanted);
  for (int i = order.size() - 1; i >= 0; --i) {
    const int id = order[i];
    const symbolic::node n = from[id];
    if (n.op == operation::constant)
      place[id] = to.constant(from.number_at(id));
    else if (n.op == operation::symbol)
      place[id] = to.variable(from.symbol_at(id));
    else
      place[id] = symbolic::build(to, n.op, place[n.a], symbolic::is_binary(n.op) ? place[n.b] : 0);
  }
  return place;
}

/// Gives a system a graph of its own. What users write numbers its nodes in the order in which their compiler
/// evaluates operands, and models of one builder share a graph; here neither matters.
inline void move_to(symbolic::graph& own, mechanics::multibody_system& system) {
  const symbolic::graph& shared = *system.mechanism.g;
  symbolic::sequence<int> nodes;
  const auto collect = [&](const symbolic::expression& e) {
    if (e.lives_in(shared)) nodes.push(e.node());
  };
  each_expression{collect}(system);
  const symbolic::sequence<int> place = copied(shared, nodes, own);
  const auto move = [&](symbolic::expression& e) {
    if (e.lives_in(shared)) e = {own, place[e.node()]};
  };
  each_expression{move}(system);
  system.mechanism.g = &own;
}

} // namespace kanexpr::runtime
