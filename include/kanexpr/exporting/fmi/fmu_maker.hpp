#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/exporting/exporter.hpp>
#include <kanexpr/exporting/fmi/fmu.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/units/si.hpp>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// An assignment of a new value to an entry of the state at an event: `set<-0.8 * u>(u)`.
struct assignment_at_event {
  symbol_name what;
  requested_result to{};
};

/// The new value of a coordinate or a speed when an event occurs: `exporting::set<-0.8 * u>(u)`.
template <auto value, class Where = describe::file_of<value>>
assignment_at_event set(const symbol_name& what) {
  return {what, {what.name(), derivation::requested<value>::value}};
}
inline assignment_at_event set(const symbol_name& what, symbolic::expression to) {
  return {what, {what.name(), {}, to}};
}

/// An event at which an expression of the model crosses zero, as in a simulation.
struct exported_event {
  std::string name{};
  requested_result watched{};
  crossing direction = crossing::either;
  std::vector<assignment_at_event> changes{};
  after_event then = after_event::go_on;
};

/// An event that occurs when an expression of the model crosses zero, or when an equation becomes satisfied:
/// `exporting::when<h>("bounce", crossing::falling, {exporting::set<-0.8 * u>(u)})`.
template <auto watched, class Where = describe::file_of<watched>>
exported_event when(const std::string& name, crossing direction = crossing::either,
                    std::vector<assignment_at_event> changes = {}, after_event then = after_event::go_on) {
  return {name, {name, derivation::requested<watched>::value}, direction, std::move(changes), then};
}
/// The same for an expression of a builder.
inline exported_event when(const std::string& name, symbolic::expression passes_zero,
                           crossing direction = crossing::either,
                           std::vector<assignment_at_event> changes = {},
                           after_event then = after_event::go_on) {
  return {name, {name, {}, passes_zero}, direction, std::move(changes), then};
}

/// The options of an FMU.
struct fmu_options {
  std::vector<requested_function> outputs{}; ///< in addition to the state
  std::vector<bound_parameter> bound{};
  std::vector<named_value> start{}; ///< for every parameter; states and inputs default to 0
  std::vector<exported_event> events{};
  double step = 1e-3;                   ///< internal step of the co-simulation, s
  std::string method = "runge_kutta_4"; ///< method of the internal steps
  std::string compiler = "cc"; ///< the C compiler as a shell command; if empty, only sources are written
};

struct made_fmu {
  fmu of{};
  std::string mistake{};
};

/// Creates an FMU from a system.
class fmu_maker {
public:
  fmu_maker(std::string name, runtime::staged_derivation& derivation, const fmu_options& chosen)
      : name_(std::move(name)), derivation_(derivation), chosen_(chosen) {}

  made_fmu run() {
    if (!(chosen_.step > 0 && numeric::is_finite(chosen_.step)))
      refuse("the internal step of a co-simulation must be positive");
    if (const std::string mistake = mistake_of_method(chosen_.method); !mistake.empty()) refuse(mistake);
    collect_functions();
    if (made_.mistake.empty()) {
      exported found = exporter(name_, derivation_, wanted_).run();
      made_.of.system = std::move(found.system);
      made_.mistake = std::move(found.mistake);
    }
    if (made_.mistake.empty()) describe();
    if (made_.mistake.empty()) set_start_values();
    return std::move(made_);
  }

private:
  /// Collects the functions to export.
  void collect_functions() {
    const model first = derivation_.resume();
    survey_ = first.known();
    if (!first.mistake().empty()) return refuse(first.mistake());
    wanted_.bound = chosen_.bound;
    wanted_.functions = {results(fmu::rates), results(fmu::jacobian)};
    requested_function by_time = results(fmu::rates);
    by_time.name = fmu::rates_by_time, by_time.derivatives = {symbols::time};
    wanted_.functions.push_back(by_time);
    requested_function measured{.name = fmu::measured}, changes{.name = fmu::changes};
    for (const requested_function& each : chosen_.outputs) {
      if (!each.mistake.empty()) return refuse(each.mistake);
      if (each.step) return refuse(each.name + " is a step and cannot be an output");
      for (const requested_result& one : each.results) {
        if (one.name.empty()) return refuse("an output of an FMU needs a name");
        measured.results.push_back(one);
      }
    }
    for (const exported_event& each : chosen_.events) {
      if (each.name.empty()) return refuse("an event of an FMU needs a name");
      measured.results.push_back(each.watched);
    }
    for (const exported_event& each : chosen_.events)
      for (const assignment_at_event& one : each.changes) changes.results.push_back(one.to);
    if (!measured.results.empty()) {
      wanted_.functions.push_back(measured);
      measured.name = fmu::measured_derivatives;
      measured.derivatives = {symbols::state, symbols::inputs, symbols::time};
      wanted_.functions.push_back(measured);
    }
    if (!changes.results.empty()) wanted_.functions.push_back(changes);
    wanted_.functions.push_back(fixed_step(fmu::step, {chosen_.method}));
    if (survey_->constraints > 0 || survey_->quaternions > 0)
      wanted_.functions.push_back(fixed_step(fmu::correction, {""}));
  }

  void describe() {
    fmu& f = made_.of;
    const exported_system& s = f.system;
    f.step_length = chosen_.step;
    int last_quaternion = 0;
    for (const std::string& each : s.states()) {
      const int i = f.count_of_states();
      f.states.push_back(variable(each));
      f.states.back().is_dependent = survey_->dependent[i];
      if (i >= survey_->coordinates || survey_->quaternion_of[i] <= last_quaternion) continue;
      last_quaternion = survey_->quaternion_of[i];
      f.states.back().start = 1; // the identity rotation
    }
    for (const std::string& each : s.parameters) f.parameters.push_back(variable(each));
    for (const std::string& each : s.inputs) f.inputs.push_back(variable(each));
    for (const fmu_variable& each : f.states)
      f.rates_of_states.push_back({variable("der(" + each.name + ')').name, {}, 0});
    f.time = variable("time").name;
    if (s.states_units) give_units();
    describe_measured();
  }

  void give_units() {
    fmu& f = made_.of;
    const exported_system& s = f.system;
    for (std::size_t i = 0; i < f.states.size(); ++i) {
      const exported_unit& unit = f.states[i].unit = s.units_of_states[i];
      if (unit.is_known()) f.rates_of_states[i].unit = written_unit(unit.unit / units::si::second);
    }
    for (std::size_t i = 0; i < f.parameters.size(); ++i) f.parameters[i].unit = s.units_of_parameters[i];
    for (std::size_t i = 0; i < f.inputs.size(); ++i) f.inputs[i].unit = s.units_of_inputs[i];
  }

  /// The unit of an entry of a result; unknown if the result has none.
  static exported_unit unit_of(const exported_result& of, int entry) {
    return of.units.empty() ? exported_unit() : of.units[static_cast<std::size_t>(entry)];
  }

  void describe_measured() {
    fmu& f = made_.of;
    const exported_function* const measured = f.system.function(fmu::measured);
    const std::size_t events = chosen_.events.size(),
                      outputs = measured == nullptr ? 0 : measured->results.size() - events;
    for (std::size_t k = 0; k < outputs; ++k) {
      const exported_result& each = measured->results[k];
      for (int i = 0; i < each.entries(); ++i) {
        f.outputs.push_back(
            variable(each.entries() == 1 ? each.name : each.name + '[' + std::to_string(i + 1) + ']'));
        f.outputs.back().unit = unit_of(each, i);
      }
    }
    for (std::size_t k = 0; k < events; ++k) {
      const exported_event& each = chosen_.events[k];
      if (measured->results[outputs + k].entries() != 1)
        return refuse("the expression of event " + each.name + " must be a scalar");
      f.indicators.push_back(variable(each.name));
      f.indicators.back().unit = unit_of(measured->results[outputs + k], 0);
      f.directions.push_back(each.direction);
      f.ends.push_back(each.then == after_event::stop);
      for (const assignment_at_event& one : each.changes) {
        const int place = place_of(f.states, one.what.name());
        if (place < 0)
          return refuse("event " + each.name + " sets " + one.what.name() +
                        ", which is neither a coordinate nor a speed");
        if (f.system.function(fmu::changes)->results[f.changed.size()].entries() != 1)
          return refuse("event " + each.name + " sets " + one.what.name() +
                        " to a value that is not a scalar");
        f.changed.push_back({static_cast<int>(k), place});
      }
    }
  }

  void set_start_values() {
    fmu& f = made_.of;
    std::set<std::string> given;
    for (const named_value& each : chosen_.start) {
      fmu_variable* found = nullptr;
      for (std::vector<fmu_variable>* among : {&f.states, &f.parameters, &f.inputs})
        if (const int place = place_of(*among, each.what.name()); place >= 0)
          found = &(*among)[static_cast<std::size_t>(place)];
      const std::string& name = each.what.name();
      if (found == nullptr)
        return refuse("there is no coordinate, speed, parameter or input " + name +
                      " to set a start value for");
      if (!numeric::is_finite(each.value)) return refuse("the start value of " + name + " is not finite");
      if (!given.insert(name).second) return refuse(name + " has two start values");
      if (found->is_dependent && place_of(f.states, name) >= survey_->coordinates &&
          survey_->nonlinear_constraints == 0) // otherwise it is where the search starts
        return refuse("speed " + name +
                      " is dependent and cannot have a start value; it follows from the constraints");
      found->start = each.value;
    }
    for (const fmu_variable& each : f.parameters)
      if (const std::string& name = model_name(each); !given.contains(name))
        return refuse("parameter " + name + " has no start value");
    if (const base::sentence impossible = compiled::check_masses(*survey_, first_parameters().data()))
      refuse(std::string(impossible.view()));
  }

  /// The values of the bound parameters, and the start values of the others.
  std::vector<double> first_parameters() const {
    std::vector<double> all;
    using symbolic::symbol_kind;
    for (int i = 0; i < survey_->parameters; ++i) {
      const std::string_view name = survey_->names[survey_->first_of(symbol_kind::parameter) + i].view();
      all.push_back(numeric::not_a_number<double>);
      for (const bound_parameter& each : chosen_.bound)
        if (each.name == name) all.back() = each.value;
      for (const fmu_variable& each : made_.of.parameters)
        if (model_name(each) == name) all.back() = each.start;
    }
    return all;
  }

  static const std::string& model_name(const fmu_variable& v) {
    return v.name_in_model.empty() ? v.name : v.name_in_model;
  }

  static int place_of(const std::vector<fmu_variable>& among, const std::string& name) {
    for (std::size_t i = 0; i < among.size(); ++i)
      if (model_name(among[i]) == name) return static_cast<int>(i);
    return -1;
  }

  /// Returns a variable with this name, or with a similar one if the name is taken or cannot be written in
  /// XML.
  fmu_variable variable(const std::string& name) {
    std::string own = printable(name);
    while (!names_.insert(own).second) own += '_';
    return {own, own == name ? std::string() : name, 0};
  }

  void refuse(std::string because) {
    if (made_.mistake.empty()) made_.mistake = std::move(because);
  }

  std::string name_;
  runtime::staged_derivation& derivation_;
  const fmu_options& chosen_;
  options wanted_{};
  std::shared_ptr<const derivation::survey> survey_{};
  std::set<std::string> names_{};
  made_fmu made_{};
};

} // namespace kanexpr::exporting
