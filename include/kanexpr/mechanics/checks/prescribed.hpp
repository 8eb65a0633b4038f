#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

namespace detail {

/// The node of an input's rate, or none.
constexpr int rate_of_input(const mechanism& m, int input) {
  for (const prescribed_rate& p : m.prescribed_rates)
    if (p.quantity.node() == input) return p.rate.node();
  return none;
}

} // namespace detail

/// The end of an error sentence about an unknown derivative.
inline constexpr std::string_view is_not_known =
    " is not known; declare it prescribed and list its rates among the inputs";

/// An input that is differentiated although its derivative is not known; `input` is empty if all are known.
struct unknown_derivative {
  std::string_view input;
  std::string_view what; ///< such as "rate" or "second derivative"

  constexpr explicit operator bool() const { return !input.empty(); }
};

constexpr unknown_derivative find_unknown_derivative(const mechanism& m, const contents& held, expression e,
                                                     int derivatives) {
  if (!held.holds(e, symbolic::symbol_kind::input)) return {};
  sequence<int> inputs;
  held.collect(e, symbolic::symbol_kind::input, inputs);
  for (int input : inputs) {
    int at = input;
    for (int order = 1; order <= derivatives; ++order) {
      at = detail::rate_of_input(m, at);
      if (at == none) return {m.g->symbol_at(input).called.view(), order == 1 ? "rate" : "second derivative"};
    }
  }
  return {};
}

} // namespace kanexpr::mechanics
