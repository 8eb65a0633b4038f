#pragma once

#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/run_setup.hpp>
#include <kanexpr/ensembles/run_values.hpp>
#include <kanexpr/ensembles/study_columns.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// A vector of a system in each run: its constant values, and varied values in their places.
template <class System, compiled::symbols_of which, class Vector>
class vector_of_runs {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr compiled::symbol_range range = compiled::range_of(which, known);

public:
  /// If a function of the study sets values later, some may be missing here.
  vector_of_runs(const runs& of, std::vector<named_value> constants, bool is_set_later) {
    if (!of.mistake().empty()) return;
    try {
      static_cast<void>(run_values(of, 0)); // throws if a distribution of the user does
    } catch (const std::exception& thrown) {
      mistake_ = thrown.what();
      return;
    }
    for (std::size_t i = 0; i < of.varied().size(); ++i)
      for (int k = 0; k < range.size && !of.varied()[i].is_factor(); ++k)
        if (name(k) == of.varied()[i].name()) {
          places_.emplace_back(i, k);
          constants.push_back(
              {of.varied()[i].name(), 0.0}); // any valid value: a run with an invalid one fails alone
        }
    if (is_set_later)
      take(compiled::given_values<System, which, Vector, true>(constants));
    else
      take(compiled::given_values<System, which, Vector, false>(constants));
    for (int k = 0; k < range.size && is_set_later; ++k) {
      const bool is_set = std::ranges::any_of(
          constants, [&](const named_value& each) { return each.what.name() == name(k); });
      if (!is_set && !known.dependent[range.first + k]) values_(k) = std::numeric_limits<double>::quiet_NaN();
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
  static std::string_view name(int k) { return known.names[range.first + k].view(); }
  template <class Given>
  void take(const Given& given) {
    values_ = given.values;
    is_left_out_ = given.is_left_out;
    mistake_ = given.mistake.view();
  }

  std::vector<std::pair<std::size_t, int>> places_{}; ///< indices of a varied value and of its symbol
  Vector values_{};
  std::array<bool, static_cast<std::size_t>(range.size)> is_left_out_{};
  std::string mistake_{};
};

/// The initial state, parameters and constant inputs of the runs of a study.
template <class System>
struct values_of_runs {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  using symbols_of = compiled::symbols_of;

  template <class Study>
  explicit values_of_runs(const Study& of)
      : states(of.runs, of.state, static_cast<bool>(of.for_each_run)),
        parameters(of.runs, of.parameters, static_cast<bool>(of.for_each_run)),
        inputs(of.runs, of.inputs, static_cast<bool>(of.for_each_run)),
        gives_inputs(inputs.is_varied() || !of.inputs.empty()), mistake(mistake_in(of.runs)) {
    for (const unit_of& each : of.units)
      if (mistake.empty() && !is_symbol(each.what.name()) && !of.runs.varies(each.what.name()))
        mistake = "the study has no " + each.what.name() + " that could have a unit";
    if (mistake.empty()) mistake = states.mistake();
    if (mistake.empty()) mistake = parameters.mistake();
    if (mistake.empty() && gives_inputs) mistake = inputs.mistake();
  }

  template <class Study>
  static std::string identity(const Study& of) {
    saver all;
    all(of.runs.identity());
    for (const auto* list : {&of.state, &of.parameters, &of.inputs}) save(*list, all);
    return all.bytes();
  }

  static void save(const std::vector<named_value>& list, saver& all) {
    all(list.size());
    for (const named_value& each : list) all(each.what.name(), each.value);
  }

  /// The setup of a run, before a function of the study changes it.
  run_setup<System> in(const run_values& run) const {
    return {states.in(run), parameters.in(run), inputs.in(run)};
  }
  /// False if neither the study nor its function set this dependent coordinate or speed.
  bool sets(const state<System>& x, std::size_t i) const {
    return !states.is_left_out(i) || std::abs(x(static_cast<Eigen::Index>(i))) > 0;
  }

  vector_of_runs<System, symbols_of::state, state<System>> states;
  vector_of_runs<System, symbols_of::parameters, parameter_values<System>> parameters;
  vector_of_runs<System, symbols_of::inputs, input_values<System>> inputs;
  bool gives_inputs;
  std::string mistake;

private:
  static std::string mistake_in(const runs& all) {
    const std::string system(type_name<System>());
    for (const varied_name& each : all.varied())
      if (each.is_factor() && is_symbol(each.name()))
        return "the factor " + each.name() + " has the name of a symbol of the system " + system;
      else if (!each.is_factor() && !is_symbol(each.name()))
        return "the system " + system + " has no " + each.name() +
               " to vary; a quantity that is not a symbol of the system is a factor: factor{\"" +
               each.name() + "\"}, or of a table runs_of(table, {factor{\"" + each.name() + "\"}})";
    return all.mistake();
  }
  static bool is_symbol(const std::string& name) {
    for (int i = 0; i < known.symbols(); ++i)
      if (known.names[i].view() == name) return true;
    return false;
  }
};

} // namespace kanexpr::ensembles
