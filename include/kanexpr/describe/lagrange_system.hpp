#pragma once

#include <kanexpr/describe/system.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr {

/// The Lagrangian as an expression of coordinates, their rates, parameters, inputs and time, which replaces
/// the bodies: `lagrangian<m * l * l * dot(q) * dot(q) / 2 + m * g * l * cos(q)>`.
template <auto... expression>
struct lagrangian : describe::system_words {
  static constexpr std::string_view word = "lagrangian";
  static constexpr void add_to(describe::system_record& r) {
    if constexpr (sizeof...(expression) == 0)
      r.lagrangian = describe::list_of<describe::phrase, &describe::phrase_of<nullptr>>::all;
    else
      r.lagrangian = describe::list_of<describe::phrase, &describe::phrase_of<expression>...>::all;
  }
};

/// A system whose equations of motion are derived by Lagrange's method, with its words in any order: `struct
/// System : lagrange_system<inertial<N>, coordinates<q>, bodies<Bob>, loads<gravity<g * N::x>>> {};` The
/// rates of the coordinates replace the speeds and are part of the state, [q; dq/dt].
template <class... Words>
struct lagrange_system : describe::system_of_words<describe::method::lagrange, Words...> {};

} // namespace kanexpr
