#pragma once

#include <kanexpr/derive/read/constraint_reader.hpp>
#include <kanexpr/describe/lagrange_system.hpp>

namespace kanexpr::deriving {

/// What only Lagrange's method needs: the rates of the coordinates as speeds, and the Lagrangian where the
/// model gives it. It is read with its symbols, and evaluated when velocities are known.
class lagrange_reader : public constraint_reader {
public:
  using constraint_reader::constraint_reader;

  /// After `know`.
  constexpr void read_lagrangian() {
    if (mistake_ || !m_.has_lagrangian) return;
    m_.lagrangian = scalar_of(from_.lagrangian[0], {"", the_lagrangian}, the_lagrangian);
  }

protected:
  /// After the list of coordinates.
  constexpr void read_rates() {
    if (!takes_rates_as_speeds()) return;
    m_.derived_by = mechanics::method::lagrange;
    m_.take_rates_as_speeds();
    for (const expression& u : m_.speeds)
      claim_name(m_.g->symbol_at(u.node()).called, symbol_list::rates_of_coordinates);
  }

  constexpr void visit_lagrangian() {
    if (mistake_ || from_.lagrangian.size == 0) return;
    if (from_.lagrangian.size > 1) return fail({"lagrangian<...> takes one expression"});
    const phrase& p = from_.lagrangian[0];
    if (p.kind != shape::scalar) return fail({the_lagrangian, is_a(p.kind), "it must be a scalar"});
    m_.has_lagrangian = true;
    visit(p.tokens, p.size, the_lagrangian);
    for (int i = 0; i < p.size && !mistake_; ++i)
      if (p.tokens[i].symbol != nullptr) symbol(*p.tokens[i].symbol, the_lagrangian);
  }

private:
  static constexpr std::string_view the_lagrangian = "the Lagrangian";
};

} // namespace kanexpr::deriving
