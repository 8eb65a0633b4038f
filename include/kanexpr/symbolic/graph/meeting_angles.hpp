#pragma once

#include <kanexpr/symbolic/graph/graph.hpp>

#include <cstdint>

/// In which sums of a graph sin² and cos² of one angle may meet.
namespace kanexpr::symbolic {

namespace detail {

constexpr bool is_sum(operation op) { return op == operation::add || op == operation::subtract; }

/// Where sums may have terms that meet, by a look at each node. Sets of angles are bits at even places; a
/// cosine is told from a sine by the bit beside it. More than 32 angles share bits.
class meeting_angles {
public:
  using set = std::uint64_t;

  struct of_node {
    set factors = 0; ///< sines and cosines by which it is a product
    set shared = 0;  ///< the same, of every term of a sum
    set inside = 0;  ///< angles of factors of the terms of sums that it is a product of
    set twice = 0;   ///< angles that it has twice where those are multiplied out
    set meeting = 0; ///< angles that two terms of a sum have twice, or all of them once
  };

  constexpr const of_node& operator[](int id) const { return known_[id]; }

  /// Looks at the nodes that are new.
  constexpr void look(const graph& g) {
    for (int id = known_.size(), end = g.size(); id < end; ++id) known_.push(look_at(g[id]));
  }

private:
  static constexpr set angles_of(set factors) { return (factors | factors >> 1) & 0x5555555555555555u; }

  constexpr of_node look_at(const node& n) {
    of_node found;
    if (n.op == operation::sin || n.op == operation::cos) {
      const set bit = n.op == operation::sin ? 1 : 2;
      found.factors = found.shared = bit << place_of(n.a);
    } else if (n.op == operation::negate) {
      found = known_[n.a];
    } else if (n.op == operation::divide) {
      found = known_[n.a];
      found.meeting = 0;
    } else if (n.op == operation::multiply) {
      const of_node &a = known_[n.a], &b = known_[n.b];
      found.factors = found.shared = a.factors | b.factors;
      found.inside = a.inside | b.inside;
      found.twice =
          a.twice | b.twice | ((angles_of(a.factors) | a.inside) & (angles_of(b.factors) | b.inside));
    } else if (is_sum(n.op)) {
      const of_node &a = known_[n.a], &b = known_[n.b];
      found.shared = a.shared & b.shared;
      found.inside = angles_of(a.factors | b.factors);
      for (const of_node* part : {&a, &b})
        if (part->factors == 0) found.inside |= part->inside; // a sum, not its product
      found.twice = a.twice | b.twice;
      found.meeting = a.meeting | b.meeting | (a.twice & b.twice) | angles_of(found.shared);
    }
    return found;
  }
  constexpr int place_of(int angle) {
    const int found = angles_.find(angle);
    return 2 * ((found < 0 ? angles_.push(angle) : found) % 32);
  }

  sequence<of_node> known_{};
  sequence<int> angles_{};
};

} // namespace detail

} // namespace kanexpr::symbolic
