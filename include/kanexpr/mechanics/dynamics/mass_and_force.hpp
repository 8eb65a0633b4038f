#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/factoring.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/sum_shortening.hpp>

namespace kanexpr::mechanics {

/// M and f in M u̇ = f, rewritten together because they share many terms. The nodes in `others` are needed in
/// any case and remain unchanged.
class mass_and_force {
public:
  constexpr mass_and_force(graph& g, symbolic::matrix& mass, sequence<expression>& force)
      : g_(g), mass_(mass), force_(force) {}

  /// Replaces sin² + cos² by 1 where this shortens the sums.
  constexpr void gather(const sequence<int>& others) {
    put_back(symbolic::shorten_sums(g_, in_one_list(), others));
  }

  /// Takes common parts out of the sums.
  constexpr void factor(const sequence<int>& others) {
    put_back(symbolic::factored(g_, in_one_list(), others));
  }

private:
  /// f, followed by the lower triangle of M.
  constexpr sequence<int> in_one_list() const {
    sequence<int> both = symbolic::nodes_of(force_);
    for (int i = 0; i < mass_.rows; ++i)
      for (int j = 0; j <= i; ++j) both.push(mass_(i, j).node());
    return both;
  }

  constexpr void put_back(const sequence<int>& nodes) {
    const sequence<expression> both = symbolic::expressions_of(g_, nodes);
    int k = 0;
    for (expression& e : force_) e = both[k++];
    for (int i = 0; i < mass_.rows; ++i)
      for (int j = 0; j <= i; ++j) mass_(i, j) = mass_(j, i) = both[k++];
  }

  graph& g_;
  symbolic::matrix& mass_;
  sequence<expression>& force_;
};

} // namespace kanexpr::mechanics
