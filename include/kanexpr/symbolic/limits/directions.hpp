#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/limits/appraisal.hpp>

namespace kanexpr::symbolic::limits {

/// Straight lines toward a point, given by the steps of the replaced symbols: from two opposite sides and,
/// for several symbols, such that the signs of any two symbols differ on some line and each is the larger one
/// on some line. The last line has equal steps, which give the shortest expressions; it may be a special
/// case.
class directions {
public:
  /// Covers the replaced symbols that the outputs depend on.
  directions(const graph& g, const appraisal& point, const sequence<int>& outputs) {
    const sequence<char> live = live_nodes(g, outputs);
    for (int id = 0; id < live.size(); ++id)
      if (live[id] != 0 && g[id].op == operation::symbol && point.is_moved(id)) moved_.push(id);
    for (int parted = 1; parted < moved_.size(); parted *= 2) ++patterns_;
  }

  int size() const { return moved_.size() == 1 ? 2 : mixed + patterns_ + 1; }
  bool has_equal_steps() const { return moved_.size() > 1; }

  /// Steps without simple ratios.
  int step(int way, int symbol) const {
    if (moved_.size() == 1) return way == 0 ? 1 : -1;
    if (way == size() - 1) return 1;
    const int i = moved_.find(symbol);
    const int shrinking = moved_.size() - 1 - i, growing = 2 * i * i + 7 * i + 3 + way;
    switch (way) {
    case 0: return (i % 2 == 1 ? -1 : 1) * (3 * i * i + 5 * i + 2);
    case 1: return (i % 2 == 1 ? 1 : -1) * (3 * i * i + 5 * i + 2);
    case 2: return 2 * i * i + 5 * i + 1;
    case 3: return 2 * shrinking * shrinking + 3 * shrinking + 1;
    default: return (i >> (way - mixed)) % 2 == 1 ? -growing : growing;
    }
  }

private:
  static constexpr int mixed = 4;

  sequence<int> moved_{};
  int patterns_ = 0; ///< number of sign patterns
};

} // namespace kanexpr::symbolic::limits
