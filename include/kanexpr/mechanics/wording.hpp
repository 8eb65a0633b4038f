#pragma once

#include <kanexpr/mechanics/mechanism.hpp>
#include <kanexpr/mechanics/problem.hpp>

/// Parts of sentences about a mechanism.
namespace kanexpr::mechanics {

constexpr std::string_view called(const mechanism& m, expression symbol) {
  return m.g->symbol_at(symbol.node()).called.view();
}

constexpr name counted(int n) {
  name text;
  text.append(n);
  return text;
}

/// "3 configuration constraints".
constexpr problem several(int n, std::string_view one, std::string_view what = {}) {
  return sentence({counted(n).view(), " ", one, n == 1 ? "" : "s", what});
}

/// "q1", "q1 and q2", "q1, q2 and q3"; after a noun, which is made a plural where it has to be.
constexpr problem enumerated(const mechanism& m, const sequence<expression>& symbols,
                             const sequence<int>& places, std::string_view noun = {}) {
  problem p = sentence({noun, noun.empty() ? "" : places.size() == 1 ? " " : "s "});
  for (int i = 0; i < places.size(); ++i)
    p = sentence({p.view(),
                  i == 0                  ? ""
                  : i + 1 < places.size() ? ", "
                                          : " and ",
                  called(m, symbols[places[i]])});
  return p;
}

} // namespace kanexpr::mechanics
