#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstdint>

namespace kanexpr::symbolic {

/// The directions along which nodes change, found for all directions in one pass over the graph. Most nodes
/// change along few of them, and the others need not be visited when derivatives are formed.
class dependence {
public:
  using word = std::uint64_t;

  /// Covers the nodes that `outputs` need.
  constexpr dependence(const graph& g, const sequence<int>& outputs, int directions)
      : g_(g), words_((directions + 63) / 64) {
    for (int id : outputs)
      if (id >= size_) size_ = id + 1;
    directions_ = base::zeros<word>(size_ * words_);
    first_ = size_;
  }

  /// Marks a node that changes along a direction by itself: a symbol, or a node that is treated as one.
  constexpr void mark(int id, int direction) {
    if (id >= size_) return;
    directions_[id * words_ + direction / 64] |= word{1} << (direction % 64);
    if (id < first_) first_ = id;
  }

  /// Extends the marks to all nodes that depend on marked ones.
  constexpr void spread() {
    const node* const nodes = g_.begin(); // pointers, because compilers interpret every call
    word* const all = directions_.begin();
    const int words = words_;
    for (int id = first_, end = size_; id < end; ++id) {
      const node& n = nodes[id];
      if (n.op <= operation::symbol) continue; // a leaf
      const bool is_of_two = n.op > operation::negate && (n.op <= operation::power || is_binary(n.op));
      for (int w = 0; w < words; ++w) {
        word changes = all[n.a * words + w];
        if (is_of_two) changes |= all[n.b * words + w];
        if (changes != 0) all[id * words + w] |= changes;
      }
    }
  }

  /// Whether a node that is covered may change along a direction.
  constexpr bool changes(int id, int direction) const {
    return (directions_[id * words_ + direction / 64] >> (direction % 64) & 1) != 0;
  }

  /// The directions along which any of these nodes may change, in ascending order.
  constexpr sequence<int> directions_of(const sequence<int>& nodes) const {
    sequence<int> all;
    for (int w = 0; w < words_; ++w) {
      word any = 0;
      for (int id : nodes) any |= directions_[id * words_ + w];
      for (int i = 64 * w; any != 0; ++i, any >>= 1)
        if ((any & 1) != 0) all.push(i);
    }
    return all;
  }

  /// The number of nodes that are covered; later ones may depend on anything.
  constexpr int size() const { return size_; }
  constexpr int words() const { return words_; }
  /// The directions of node i as bits, from `words() * i` on.
  constexpr const word* begin() const { return directions_.begin(); }

private:
  const graph& g_;
  int words_ = 0, size_ = 0, first_ = 0;
  base::zeros<word> directions_{};
};

} // namespace kanexpr::symbolic
