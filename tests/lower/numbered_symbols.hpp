#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::check {

/// The parameters s0, s1, …, each at the position of its number.
class numbered_symbols {
public:
  constexpr explicit numbered_symbols(symbolic::graph& g) : g_(g) {}

  constexpr symbolic::expression next() {
    base::name called("s");
    called.append(count_);
    return symbolic::variable(g_, {symbolic::symbol_kind::parameter, called, count_++});
  }

private:
  symbolic::graph& g_;
  int count_ = 0;
};

} // namespace kanexpr::check
