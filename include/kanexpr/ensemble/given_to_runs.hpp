#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/ensemble/run_values.hpp>
#include <kanexpr/ensemble/study_columns.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// A vector of a system in each run: what it is in all of them, with what differs in its places.
template <class Given, class Vector>
class given_to_runs {
public:
  /// `range` is that of the vector's symbols in the survey.
  given_to_runs(const deriving::survey& known, const compiled::symbol_range& range, const runs& of,
                std::vector<named_value> same) {
    if (!of.mistake().empty()) return;
    const run_values first(of, 0);
    for (std::size_t i = 0; i < of.varied().size(); ++i) {
      const varied_name& what = of.varied()[i];
      if (what.is_factor()) continue;
      for (int k = 0; k < range.size; ++k)
        if (known.names[range.first + k].view() == what.name()) {
          places_.emplace_back(i, k);
          same.push_back({what.name(), first.all()[i]});
        }
    }
    const Given given(same);
    values_ = given.values;
    mistake_ = given.mistake.view();
  }

  bool is_varied() const { return !places_.empty(); }
  const std::string& mistake() const { return mistake_; }

  Vector in(const run_values& run) const {
    Vector values = values_;
    for (const auto& [from, to] : places_) values(to) = run.all()[from];
    return values;
  }

private:
  std::vector<std::pair<std::size_t, int>> places_{};
  Vector values_{};
  std::string mistake_{};
};

/// What the systems of a study are given: states, parameters and constant inputs.
template <class System>
struct given_to_systems {
  static constexpr const deriving::survey& known = compiled::survey_of<System>;
  using symbols_of = compiled::symbols_of;

  template <class Study>
  explicit given_to_systems(const Study& told)
      : states(known, compiled::range_of(symbols_of::state, known), told.runs, told.state),
        parameters(known, compiled::range_of(symbols_of::parameters, known), told.runs, told.parameters),
        inputs(known, compiled::range_of(symbols_of::inputs, known), told.runs, told.inputs),
        gives_inputs(inputs.is_varied() || !told.inputs.empty()) {
    mistake = !told.runs.mistake().empty() ? told.runs.mistake() : mistake_in(told.runs);
    for (const unit_of& each : told.units)
      if (mistake.empty() && !is_symbol(each.what.name()) && !is_varied(told.runs, each.what.name()))
        mistake = "a unit is told of " + each.what.name() + ", which the study does not have";
    if (mistake.empty()) mistake = states.mistake();
    if (mistake.empty()) mistake = parameters.mistake();
    if (mistake.empty() && gives_inputs) mistake = inputs.mistake();
  }

  /// By which a study is known again.
  template <class Study>
  static std::string text(const Study& told) {
    std::string all = told.runs.text();
    for (const auto* list : {&told.state, &told.parameters, &told.inputs})
      for (const named_value& each : *list) {
        bytes_writer value;
        value.put(each.value);
        all += ' ' + each.what.name() + ' ' + value.bytes();
      }
    return all;
  }

  given_to_runs<given_state<System>, state<System>> states;
  given_to_runs<given_parameters<System>, parameter_values<System>> parameters;
  given_to_runs<given_inputs<System>, input_values<System>> inputs;
  bool gives_inputs;
  std::string mistake{};

private:
  static std::string mistake_in(const runs& all) {
    for (const varied_name& each : all.varied())
      if (!each.is_factor() && !is_symbol(each.name()))
        return "the system " + std::string(type_name<System>()) + " has no " + each.name() +
               " that could differ from run to run; if it is none of its symbols, it is a factor, factor{\"" +
               each.name() + "\"}";
    return {};
  }
  static bool is_varied(const runs& all, const std::string& name) {
    return std::ranges::find(all.varied(), name, &varied_name::name) != all.varied().end();
  }
  static bool is_symbol(const std::string& name) {
    for (int i = 0; i < known.symbols(); ++i)
      if (known.names[i].view() == name) return true;
    return false;
  }
};

} // namespace kanexpr::ensembles
