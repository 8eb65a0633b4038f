#pragma once

#include <kanexpr/derivation/request.hpp>
#include <kanexpr/derivation/result_units.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/derivation/unit_labels.hpp>
#include <kanexpr/describe/token.hpp>
#include <kanexpr/exporting/export_request.hpp>
#include <kanexpr/exporting/exported_system.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// The units of the arguments and the results of a system.
class units_of_export {
public:
  units_of_export() = default;
  explicit units_of_export(const model& of) : known_(of.known()), symbols_(of.units()) {}

  bool are_stated() const { return symbols_.is_stated; }

  /// The unit of a symbol, by its index in the names of the survey.
  exported_unit of_symbol(int place) const {
    using table = mechanics::unit_table;
    const int speed = known_->coordinates, parameter = speed + known_->speeds,
              input = parameter + known_->parameters;
    if (place < speed) return exported_as(symbols_.at(table::coordinates, place));
    if (place < parameter) return exported_as(symbols_.at(table::speeds, place - speed));
    if (place < input) return exported_as(symbols_.of(known_->names[place].view()));
    return exported_as(symbols_.at(table::inputs, place - input));
  }

  /// The units of the entries of a result `found` in a model; empty if none is known.
  std::vector<exported_unit> of_result(const model& from, const requested_result& wanted,
                                       const symbolic::matrix& found) const {
    if (!are_stated() || wanted.derivative.type != requested_derivative::kind::none || !wanted.part.empty())
      return {};
    std::vector<exported_unit> all;
    if (wanted.is_residual)
      all = of_residual(found.rows);
    else if (wanted.written.is_given())
      all.assign(1, exported_as(from.unit_of(found.entries[0])));
    else if (wanted.request.what == derivation::request::kind::result)
      all = of_quantity(wanted.request.wanted, found.rows, found.columns);
    else if (wanted.request.what == derivation::request::kind::expressions)
      for (const describe::phrase& p : wanted.request.phrases)
        all.insert(all.end(), p.kind == describe::shape::vector ? 3u : 1u, exported_as(from.unit_of(p)));
    return any_known(std::move(all));
  }

  /// The units of the state; empty if none is known.
  std::vector<exported_unit> of_states() const {
    const int states = known_->coordinates + known_->speeds;
    std::vector<exported_unit> all;
    all.reserve(static_cast<std::size_t>(states));
    for (int i = 0; i < states; ++i) all.push_back(of_symbol(i));
    return any_known(std::move(all));
  }

private:
  static std::vector<exported_unit> any_known(std::vector<exported_unit> all) {
    for (const exported_unit& each : all)
      if (each.is_known()) return all;
    return {};
  }

  static exported_unit exported_as(const mechanics::possible_unit& u) {
    return u ? written_unit(*u) : exported_unit();
  }

  std::vector<exported_unit> of_residual(int rows) const {
    const derivation::result_units results(symbols_, *known_);
    std::vector<exported_unit> all;
    all.reserve(static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) all.push_back(exported_as(results.of_residual(i)));
    return all;
  }

  std::vector<exported_unit> of_quantity(mechanics::quantity of, int rows, int columns) const {
    const derivation::result_units results(symbols_, *known_);
    std::vector<exported_unit> all;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        all.push_back(exported_as(results.of(of, i, j)));
        if (derivation::is_energy(of) && all.back().is_known()) all.back().text = "J";
      }
    return all;
  }

  std::shared_ptr<const derivation::survey> known_{};
  mechanics::unit_table symbols_{};
};

} // namespace kanexpr::exporting
