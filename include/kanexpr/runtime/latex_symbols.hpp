#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/derivation/unit_labels.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <string>
#include <utility>

namespace kanexpr {

/// Writes the symbols of a system as the rows of a LaTeX table, one per line, with their meaning, and with
/// their units if the model states any:
///
///     $q$ & coordinate & $\mathrm{rad}$
///
/// Each row ends with a double backslash. The cell of a unit that is not determined is empty.
inline std::string latex_symbols(const model& of) {
  const mechanics::mechanism& m = of.mechanism();
  const mechanics::unit_table units = of.known()->states_units ? of.units() : mechanics::unit_table();
  const std::pair<const char*, const base::sequence<symbolic::expression>*> lists[]{
      {"coordinate", &m.coordinates},
      {"speed", &m.speeds},
      {"parameter", &m.parameters},
      {"input", &m.inputs},
      {"auxiliary speed", &m.auxiliary_speeds}};
  std::string text;
  unsigned char list = mechanics::unit_table::coordinates;
  for (const auto& [meaning, symbols] : lists) {
    const auto in = static_cast<mechanics::unit_table::list>(list++);
    for (int i = 0; i < symbols->size(); ++i) {
      text += '$' + symbolic::latex((*symbols)[i]) + "$ & " + meaning;
      const std::string unit = derivation::unit_label(units.at(in, i), units::spelling::latex);
      if (units.is_stated) text += unit.empty() ? " &" : " & $" + unit + '$';
      text += " \\\\\n";
    }
  }
  return text;
}

} // namespace kanexpr
