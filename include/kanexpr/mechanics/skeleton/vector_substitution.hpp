#pragma once

#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>

namespace kanexpr::mechanics {

/// Replaces symbols in scalars and in vectors.
class vector_substitution {
public:
  constexpr explicit vector_substitution(graph& g) : images_(g) {}

  /// Registers a replacement; must be called before the first call of `in`.
  constexpr void replace(expression old, expression by) {
    images_.replace(old, by);
    is_empty_ = false;
  }

  constexpr expression in(expression e) { return is_empty_ ? e : images_.in(e); }
  constexpr vector in(const vector& v) {
    if (is_empty_) return v;
    vector out;
    for (const vector::part& p : v.parts)
      out.parts.push({p.frame, {in(p.value.x), in(p.value.y), in(p.value.z)}});
    return out;
  }

private:
  symbolic::substitution images_;
  bool is_empty_ = true;
};

} // namespace kanexpr::mechanics
