#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/ensemble/run_setup.hpp>
#include <kanexpr/ensemble/run_values.hpp>
#include <kanexpr/ensemble/study_columns.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// A vector of a system in each run: what it is in all of them, with what differs in its places.
template <class System, compiled::symbols_of which, class Vector>
class given_to_runs {
  template <bool may_be_incomplete>
  using given = compiled::given_values<System, which, Vector, may_be_incomplete>;

public:
  /// What `is_set_later`, by a function, may be left out.
  given_to_runs(const runs& of, std::vector<named_value> same, bool is_set_later) {
    if (!of.mistake().empty()) return;
    try {
      read(of, std::move(same), is_set_later);
    } catch (const std::exception& thrown) { // by a distribution of the user
      mistake_ = thrown.what();
    }
  }

  bool is_varied() const { return !places_.empty(); }
  const std::string& mistake() const { return mistake_; }
  bool is_left_out(std::size_t i) const { return is_left_out_[i]; }

  Vector in(const run_values& run) const {
    Vector values = values_;
    for (const auto& [from, to] : places_) values(to) = run.all()[from];
    return values;
  }

private:
  static constexpr const deriving::survey& known = compiled::survey_of<System>;
  static constexpr compiled::symbol_range range = compiled::range_of(which, known);

  void read(const runs& of, std::vector<named_value> same, bool is_set_later) {
    static_cast<void>(run_values(of, 0)); // throws where a distribution of the user does
    for (std::size_t i = 0; i < of.varied().size(); ++i) {
      const varied_name& what = of.varied()[i];
      if (what.is_factor()) continue;
      for (int k = 0; k < range.size; ++k)
        if (known.names[range.first + k].view() == what.name()) {
          places_.emplace_back(i, k);
          // A run whose number is wrong fails, the first like others.
          same.push_back({what.name(), 0.0});
        }
    }
    if (is_set_later) {
      take(given<true>(same));
      for (int k = 0; k < range.size; ++k)
        if (const int place = range.first + k;
            !known.dependent[place] && !is_told(known.names[place].view(), same))
          values_(k) = std::numeric_limits<double>::quiet_NaN();
    } else {
      take(given<false>(same));
    }
  }

  template <class Given>
  void take(const Given& told) {
    values_ = told.values;
    is_left_out_ = told.is_left_out;
    mistake_ = told.mistake.view();
  }
  static bool is_told(std::string_view name, const std::vector<named_value>& all) {
    return std::ranges::any_of(all, [&](const named_value& each) { return each.what.name() == name; });
  }

  std::vector<std::pair<std::size_t, int>> places_{};
  Vector values_{};
  std::array<bool, static_cast<std::size_t>(range.size)> is_left_out_{};
  std::string mistake_{};
};

/// What the systems of a study are given: states, parameters and constant inputs.
template <class System>
struct given_to_systems {
  static constexpr const deriving::survey& known = compiled::survey_of<System>;
  using symbols_of = compiled::symbols_of;

  template <class Study>
  explicit given_to_systems(const Study& told)
      : states(told.runs, told.state, static_cast<bool>(told.for_each_run)),
        parameters(told.runs, told.parameters, static_cast<bool>(told.for_each_run)),
        inputs(told.runs, told.inputs, static_cast<bool>(told.for_each_run)),
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
    bytes_writer all;
    all.put(told.runs.text());
    for (const auto* list : {&told.state, &told.parameters, &told.inputs}) {
      all.put(list->size());
      for (const named_value& each : *list) all.put(each.what.name()), all.put(each.value);
    }
    return all.bytes();
  }

  /// Of a run, before a function changes it.
  run_setup<System> in(const run_values& run) const {
    return {states.in(run), parameters.in(run), inputs.in(run)};
  }

  /// Whether the study, or the function that changed its run, told this coordinate or speed; where neither
  /// did, the constraints give it.
  bool tells(const state<System>& x, std::size_t i) const {
    return !states.is_left_out(i) || std::abs(x(static_cast<Eigen::Index>(i))) > 0;
  }

  given_to_runs<System, symbols_of::state, state<System>> states;
  given_to_runs<System, symbols_of::parameters, parameter_values<System>> parameters;
  given_to_runs<System, symbols_of::inputs, input_values<System>> inputs;
  bool gives_inputs;
  std::string mistake{};

private:
  static std::string mistake_in(const runs& all) {
    for (const varied_name& each : all.varied())
      if (each.is_factor() && is_symbol(each.name()))
        return "the factor " + each.name() + " is called as a symbol of the system " +
               std::string(type_name<System>());
      else if (!each.is_factor() && !is_symbol(each.name()))
        return "the system " + std::string(type_name<System>()) + " has no " + each.name() +
               " that could differ from run to run; if it is none of its symbols, it is a factor, factor{\"" +
               each.name() + "\"}, or of a table runs_of(table, {factor{\"" + each.name() + "\"}})";
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
