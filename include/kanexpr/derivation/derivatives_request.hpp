#pragma once

#include <kanexpr/derivation/request.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// The derivatives of a result, row by row in the order of its entries, with respect to the state [q; u], the
/// inputs, or the rates of the speeds if the result contains them.
struct derivatives_of_result {
  quantity of;
  with_respect_to symbols;

  constexpr std::string_view result_name() const { return mechanics::row_of(of).called; }
};

template <derivatives_of_result wanted>
struct requested<wanted> {
  static constexpr request value{
      .what = request::kind::derivatives, .wanted = wanted.of, .symbols = wanted.symbols};
};

} // namespace kanexpr::derivation
