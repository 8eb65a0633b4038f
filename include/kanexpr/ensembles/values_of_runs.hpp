#pragma once

#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/ensembles/study.hpp>
#include <kanexpr/ensembles/study_columns.hpp>
#include <kanexpr/ensembles/study_interface.hpp>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// A vector of a system for each run, composed of constant and varied values.
template <class System, compiled::symbols_of which, class Vector>
class vector_of_runs {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr compiled::symbol_range range = compiled::range_of(which, known);

public:
  /// If a function of the study sets values later, some may be missing here.
  vector_of_runs(const runs& of, std::vector<named_value> constants, bool is_set_later) {
    for (std::size_t i = 0; i < of.varied().size(); ++i) {
      const varied_name& varied = of.varied()[i];
      const int k = symbol_index<System>(varied.name()) - range.first;
      if (varied.is_factor() || k < 0 || k >= range.size) continue;
      places_.emplace_back(i, k);
      constants.push_back({varied.name(), 0.0}); // valid; only runs with an invalid value fail
    }
    if (is_set_later)
      take(compiled::given_values<System, which, Vector, true>(constants));
    else
      take(compiled::given_values<System, which, Vector, false>(constants));
    for (int k = 0; k < range.size && is_set_later; ++k)
      if (is_left_out(static_cast<std::size_t>(k)) && !known.may_be_omitted(range.first + k))
        values_(k) = std::numeric_limits<double>::quiet_NaN();
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
template <class Kind>
struct values_of_runs {
  using System = typename Kind::System;
  using symbols_of = compiled::symbols_of;

  explicit values_of_runs(const study_of<Kind>& of)
      : states(of.runs, of.state, static_cast<bool>(of.for_each_run)),
        parameters(of.runs, of.parameters, static_cast<bool>(of.for_each_run)),
        inputs(of.runs, of.inputs, static_cast<bool>(of.for_each_run)),
        specifies_inputs(inputs.is_varied() || !of.inputs.empty()) {}

  /// Returns the first mistake in the constant and varied values, as a sentence.
  std::string mistake(const study_of<Kind>& of) const {
    if (std::string mistake = mistake_in(of.runs); !mistake.empty()) return mistake;
    for (const unit_of& each : of.units)
      if (symbol_index<System>(each.what.name()) < 0 && !of.runs.varies(each.what.name()))
        return "the study has no " + each.what.name() + " to assign a unit to";
    if (!states.mistake().empty()) return states.mistake();
    if (!parameters.mistake().empty()) return parameters.mistake();
    return specifies_inputs ? inputs.mistake() : std::string();
  }

  /// Returns the setup of a run before a function of the study changes it.
  run_setup<System> in(const run_values& run) const {
    return {states.in(run), parameters.in(run), inputs.in(run)};
  }
  /// Returns false if neither the study nor its function sets this dependent coordinate or speed.
  bool sets(const state<System>& x, std::size_t i) const {
    return !states.is_left_out(i) || std::abs(x(static_cast<Eigen::Index>(i))) > 0;
  }

  vector_of_runs<System, symbols_of::state, state<System>> states;
  vector_of_runs<System, symbols_of::parameters, parameter_values<System>> parameters;
  vector_of_runs<System, symbols_of::inputs, input_values<System>> inputs;
  bool specifies_inputs;

private:
  static std::string mistake_in(const runs& all) {
    const std::string system(type_name<System>());
    for (const varied_name& each : all.varied())
      if (each.is_factor() && symbol_index<System>(each.name()) >= 0)
        return "the factor " + each.name() + " has the name of a symbol of the system " + system;
      else if (!each.is_factor() && symbol_index<System>(each.name()) < 0)
        return "the system " + system + " has no " + each.name() +
               " to vary; for a quantity that is not a symbol of the system, use factor{\"" + each.name() +
               "\"} or, if it is a column of a table, runs_of(table, {factor{\"" + each.name() + "\"}})";
    if (!all.mistake().empty()) return all.mistake();
    return exception_in([&] { run_values(all, 0); }).value_or(""); // from a user's distribution
  }
};

} // namespace kanexpr::ensembles
