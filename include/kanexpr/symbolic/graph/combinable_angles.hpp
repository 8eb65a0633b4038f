#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstdint>

/// Finds sums in which sin² and cos² of the same angle may combine.
namespace kanexpr::symbolic {

namespace detail {

constexpr bool is_sum(operation op) { return op == operation::add || op == operation::subtract; }

/// Sums whose terms may combine, found by visiting each node once. A set of angles is stored as bits at even
/// positions; the bit that follows distinguishes a cosine from a sine. If there are more than 32 angles, some
/// of them share bits.
class combinable_angles {
public:
  using set = std::uint64_t;

  struct angle_sets {
    set factors = 0;   ///< sines and cosines that are factors of the node
    set shared = 0;    ///< sines and cosines that every term of a sum has as factors
    set inside = 0;    ///< angles in factors of the terms of sums that are factors of the node
    set twice = 0;     ///< angles that occur twice when those sums are multiplied out
    set combining = 0; ///< angles that occur twice in each of two terms of a sum, or once in every term
  };

  constexpr const angle_sets& operator[](int id) const { return known_[id]; }

  /// Visits the new nodes.
  constexpr void update(const graph& g) {
    for (int id = known_.size(), end = g.size(); id < end; ++id) known_.push(sets_of(g[id]));
  }

private:
  static constexpr set angles_of(set factors) { return (factors | factors >> 1) & 0x5555555555555555u; }

  constexpr angle_sets sets_of(const node& n) {
    angle_sets found;
    if (n.op == operation::sin || n.op == operation::cos) {
      const set bit = n.op == operation::sin ? 1 : 2;
      found.factors = found.shared = bit << place_of(n.a);
    } else if (n.op == operation::negate) {
      found = known_[n.a];
    } else if (n.op == operation::divide) {
      found = known_[n.a];
      found.combining = 0;
    } else if (n.op == operation::multiply) {
      const angle_sets &a = known_[n.a], &b = known_[n.b];
      found.factors = found.shared = a.factors | b.factors;
      found.inside = a.inside | b.inside;
      found.twice =
          a.twice | b.twice | ((angles_of(a.factors) | a.inside) & (angles_of(b.factors) | b.inside));
    } else if (is_sum(n.op)) {
      const angle_sets &a = known_[n.a], &b = known_[n.b];
      found.shared = a.shared & b.shared;
      found.inside = angles_of(a.factors | b.factors);
      for (const angle_sets* part : {&a, &b})
        if (part->factors == 0) found.inside |= part->inside; // the node is a sum, not a product
      found.twice = a.twice | b.twice;
      found.combining = a.combining | b.combining | (a.twice & b.twice) | angles_of(found.shared);
    }
    return found;
  }
  constexpr int place_of(int angle) {
    const int found = angles_.find(angle);
    return 2 * ((found < 0 ? angles_.push(angle) : found) % 32);
  }

  sequence<angle_sets> known_{};
  sequence<int> angles_{};
};

} // namespace detail

} // namespace kanexpr::symbolic
