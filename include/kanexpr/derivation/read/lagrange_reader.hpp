#pragma once

#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the parts that are specific to Lagrange's method: the rates of the coordinates as speeds, and the
/// Lagrangian if the model specifies it. The symbols of the Lagrangian are read with all others; it is
/// evaluated once velocities are known.
class lagrange_reader : part_reader {
public:
  using part_reader::part_reader;

  /// Evaluates the Lagrangian; requires that `set_known_motion` was called.
  constexpr void read_lagrangian() {
    if (reading_.mistake || !reading_.into.loads.has_lagrangian) return;
    reading_.into.loads.lagrangian =
        phrases_.scalar_of(reading_.from.lagrangian[0], {"", the_lagrangian}, the_lagrangian);
  }

  /// Takes the rates of the coordinates as speeds; requires that the list of coordinates was read.
  constexpr void read_rates() {
    if (!reading_.takes_rates_as_speeds()) return;
    m_.derived_by = mechanics::method::lagrange;
    m_.take_rates_as_speeds();
    for (const expression& u : m_.speeds)
      symbols_.claim_name(m_.g->symbol_at(u.node()).called, symbol_list::rates_of_coordinates);
  }

  constexpr void visit_lagrangian() {
    if (reading_.mistake || reading_.from.lagrangian.size == 0) return;
    if (reading_.from.lagrangian.size > 1) return reading_.fail({"lagrangian<...> takes one expression"});
    const phrase& p = reading_.from.lagrangian[0];
    if (p.kind != shape::scalar && p.kind != shape::vector &&
        p.kind != shape::dyadic) // `read_lagrangian` reports vectors and dyadics
      return reading_.fail({the_lagrangian, is_a(p.kind), "it must be a scalar"});
    reading_.into.loads.has_lagrangian = true;
    mention(p, the_lagrangian);
  }

private:
  static constexpr std::string_view the_lagrangian = "the Lagrangian"sv;
};

} // namespace kanexpr::derivation
