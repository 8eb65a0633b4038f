#pragma once

#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the values that a model binds to parameters.
class value_reader : part_reader {
public:
  using part_reader::part_reader;

  constexpr void read(const phrase& p) {
    phrases_.check_misuse(p, "values<...>"sv);
    if (reading_.mistake) return;
    const symbol_record* s = p.kind == shape::equation ? p.tokens[0].symbol : nullptr;
    phrase right{shape::scalar, p.tokens + 1, p.size - 2};
    if (s == nullptr && p.kind == shape::equation) { // 2.5 == m
      s = p.tokens[p.size - 2].symbol;
      right.tokens = p.tokens;
    }
    if (s == nullptr || !is_whole(right)) {
      const std::string_view held = name_in(p);
      return reading_.fail(
          {"values<...> takes equations such as m == 2.5 for parameters, but contains a different expression",
           held.empty() ? "" : " with ", held});
    }
    if (s->kind != symbolic::symbol_kind::parameter)
      return reading_.fail(
          {kind_of(*s), s->called.view(), " is bound to a value; only parameters can be bound"});
    if (symbols_.is_bound(s->called))
      return reading_.fail({"parameter ", s->called.view(), " is bound to two values"});
    for (const describe::token& t : right)
      if (t.symbol != nullptr)
        return reading_.fail({"the value of parameter ", s->called.view(), " is not a number: it contains ",
                              t.symbol->called.view()});
    for (const describe::token& t : right)
      if (t.what == describe::token_kind::number && t.index == describe::whole_zero)
        return reading_.fail({"the value of parameter ", s->called.view(),
                              describe::misuse_message(describe::misuse::zero).view()});
    const value number = phrases_.evaluate_part("the value of parameter "sv, right, s->called.view());
    if (!reading_.mistake && (number.kind != shape::scalar || !number.scalar.is_constant()))
      reading_.fail({"the value of parameter ", s->called.view(), " is not a number"});
    symbols_.bind(*s, number.scalar);
  }
};

} // namespace kanexpr::derivation
