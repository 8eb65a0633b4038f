#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/symbolic/graph/copied.hpp>

#include <optional>
#include <type_traits>

namespace kanexpr::runtime {

/// Calls `use` with each expression of a system, in the order of its members.
template <class Use>
class each_expression {
public:
  explicit each_expression(const Use& use) : use_(use) {}

  template <class Number>
  void operator()(Number& part) const {
    if constexpr (std::is_scalar_v<Number>)
      return;
    else if constexpr (requires { Number::each_member(part, *this); })
      Number::each_member(part, *this);
    else
      for_each_member(part, *this);
  }
  template <class Number>
  void operator()(symbolic::sequence<Number>& parts) const {
    for (Number& each : parts) (*this)(each);
  }
  template <class Number>
  void operator()(std::optional<Number>& part) const {
    if (part) (*this)(*part);
  }
  void operator()(symbolic::expression& e) const { use_(e); }
  void operator()(symbolic::name&) const {}

private:
  const Use& use_;
};

/// Gives a system a graph of its own. What users write numbers its nodes in the order in which their compiler
/// evaluates operands, and models of one builder share a graph; here neither matters.
inline void move_to(symbolic::graph& own, mechanics::multibody_system& system) {
  const symbolic::graph& shared = *system.mechanism.g;
  symbolic::sequence<int> nodes;
  const auto collect = [&](const symbolic::expression& e) {
    if (e.lives_in(shared)) nodes.push(e.node());
  };
  each_expression{collect}(system);
  const symbolic::sequence<int> place = symbolic::copied(shared, nodes, own);
  const auto move = [&](symbolic::expression& e) {
    if (e.lives_in(shared)) e = {own, place[e.node()]};
  };
  each_expression{move}(system);
  system.mechanism.g = &own;
}

} // namespace kanexpr::runtime
