#pragma once

#include <kanexpr/derivation/names_along.hpp>
#include <kanexpr/derivation/result_units.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/derivation/unit_labels.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace kanexpr {

/// Writes the entries of a result, one per line, with the symbols of their rows and columns, and with their
/// units if the model states any:
///
///     mass_matrix(u, u) = l^2*m  [kg m²]
///     forcing(u) = T - c*u - g*l*m*sin(q)  [N m]
///
/// Rows and columns that belong to no symbol are numbered from 0. If the entries have more than `longest`
/// characters, they share named parts, whose definitions follow, as in `symbolic::print`.
inline std::string print_entries(model& of, mechanics::quantity wanted,
                                 std::size_t longest = symbolic::longest_text) {
  const mechanics::result_row& result = mechanics::row_of(wanted);
  const std::shared_ptr<const derivation::survey> known = of.known();
  const mechanics::unit_table symbols = known->states_units ? of.units() : mechanics::unit_table();
  const derivation::result_units units(symbols, *known);
  const symbolic::matrix entries = of.get(wanted);
  const std::vector<std::string> rows = derivation::names_along(*known, result.rows),
                                 columns = derivation::names_along(*known, result.columns);
  const auto called = [](const std::vector<std::string>& names, int place) {
    return names.empty() ? std::to_string(place) : names[static_cast<std::size_t>(place)];
  };
  const symbolic::text_with_parts written = symbolic::print_each(entries.entries, longest);
  std::string text;
  for (int i = 0; i < entries.rows; ++i)
    for (int j = 0; j < entries.columns; ++j) {
      text += result.called;
      if (result.columns != mechanics::extent_by::one && result.columns != mechanics::extent_by::scalar)
        text += '(' + called(rows, i) + ", " + called(columns, j) + ')';
      else if (entries.rows > 1 || !rows.empty())
        text += '(' + called(rows, i) + ')';
      text += " = " + written.expressions[static_cast<std::size_t>(i * entries.columns + j)];
      const std::string unit = derivation::is_energy(wanted) && symbols.is_stated
                                   ? "J"
                                   : derivation::unit_label(units.of(wanted, i, j));
      text += unit.empty() ? "\n" : "  [" + unit + "]\n";
    }
  if (!written.parts.empty()) text += "where\n";
  for (const symbolic::text_with_parts::part& each : written.parts)
    text += "  " + each.name + " = " + each.text + '\n';
  return text;
}

} // namespace kanexpr
