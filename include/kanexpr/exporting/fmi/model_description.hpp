#pragma once

#include <kanexpr/exporting/fmi/fmu.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>
#include <kanexpr/exporting/text/scalar.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <tinyxml2.h>

#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// An XML document that is written from beginning to end.
class xml_file {
public:
  using attributes = std::initializer_list<std::pair<const char*, std::string>>;

  xml_file() { printer_.PushDeclaration(R"(xml version="1.0" encoding="UTF-8")"); }

  void open(const char* name, attributes all = {}) {
    printer_.OpenElement(name);
    add_attributes(all);
  }
  void add_attributes(attributes all) {
    for (const auto& [attribute, value] : all) printer_.PushAttribute(attribute, value.c_str());
  }
  void close() { printer_.CloseElement(); }
  void add(const char* name, attributes all) {
    open(name, all);
    close();
  }

  std::string text() const { return printer_.CStr(); }

private:
  tinyxml2::XMLPrinter printer_{};
};

/// The text of buildDescription.xml, which is stored with the sources.
inline std::string build_description(const std::string& name) {
  xml_file xml;
  xml.open("fmiBuildDescription", {{"fmiVersion", "3.0"}});
  xml.open("BuildConfiguration", {{"modelIdentifier", name}});
  xml.open("SourceFileSet", {{"language", "C99"}});
  for (const char* end : {".c", "_fmi.c"}) xml.add("SourceFile", {{"name", name + end}});
  for (int i = 0; i < 3; ++i) xml.close();
  return xml.text();
}

/// Writes modelDescription.xml of FMI 3.0.
class model_description {
public:
  explicit model_description(const fmu& of) : of_(of) {}

  std::string text(const std::string& token) {
    xml_.open("fmiModelDescription", {{"fmiVersion", "3.0"},
                                      {"modelName", of_.system.name},
                                      {"instantiationToken", '{' + token + '}'},
                                      {"generationTool", generator()},
                                      {"variableNamingConvention", "flat"}});
    const bool is_watched = of_.system.function(fmu::correction) != nullptr || !of_.indicators.empty();
    add_interface("ModelExchange", {{"needsCompletedIntegratorStep", is_watched ? "true" : "false"}});
    add_interface("CoSimulation", {{"canHandleVariableCommunicationStepSize", "true"},
                                   {"fixedInternalStepSize", number(of_.step_length)}});
    define_units();
    xml_.open("LogCategories");
    xml_.add("Category",
             {{"name", "logStatusDiscard"}, {"description", "results that cannot be computed at a state"}});
    xml_.add("Category", {{"name", "logStatusError"}, {"description", "invalid calls"}});
    xml_.close();
    xml_.open("ModelVariables");
    add_variables();
    xml_.close();
    xml_.open("ModelStructure");
    add_structure();
    xml_.close();
    xml_.close();
    return xml_.text();
  }

private:
  static std::string number(double value) { return scalar(precision::double_precision).number(value); }

  void add_interface(const char* name, xml_file::attributes own) {
    xml_.open(name, {{"modelIdentifier", of_.system.name}});
    xml_.add_attributes(own);
    xml_.add_attributes({{"providesDirectionalDerivatives", "true"}, {"providesAdjointDerivatives", "true"}});
    xml_.close();
  }

  /// Defines the units of the variables, in terms of base units; FMI knows only their integer powers.
  void define_units() {
    if (!of_.system.states_units) return;
    std::map<std::string, units::unit> all{{"s", units::si::second}};
    for (const auto* list :
         {&of_.states, &of_.rates_of_states, &of_.parameters, &of_.inputs, &of_.outputs, &of_.indicators})
      for (const fmu_variable& each : *list)
        if (each.unit.is_known()) all.emplace(each.unit.text, each.unit.unit);
    xml_.open("UnitDefinitions");
    for (const auto& [text, unit] : all) {
      xml_.open("Unit", {{"name", text}});
      if (has_integer_powers(unit)) add_base_unit(unit);
      xml_.close();
    }
    xml_.close();
  }

  static bool has_integer_powers(const units::unit& u) {
    for (int i = 0; i < units::base_units; ++i)
      if (!u.exponent_of(units::base_unit_at(i)).is_integer()) return false;
    return true;
  }

  void add_base_unit(const units::unit& u) {
    constexpr const char* names[units::base_units]{"kg", "m", "s", "A", "K", "mol", "cd", "rad"};
    xml_.open("BaseUnit");
    for (int i = 0; i < units::base_units; ++i)
      if (const int power = u.exponent_of(units::base_unit_at(i)).numerator; power != 0)
        xml_.add_attributes({{names[i], std::to_string(power)}});
    xml_.close();
  }

  /// The attributes that all variables of one kind have in common.
  struct variable_kind {
    const char* causality = "local";
    const char* initial = nullptr;
    bool has_start = false;
    const char* variability = "continuous";
    int derivative_of = 0; ///< a value reference
  };

  /// Adds a variable with the next value reference.
  void add(const fmu_variable& v, const variable_kind& of) {
    xml_.open("Float64", {{"name", v.name},
                          {"valueReference", std::to_string(next_reference_++)},
                          {"causality", of.causality},
                          {"variability", of.variability}});
    if (v.unit.is_known()) xml_.add_attributes({{"unit", v.unit.text}});
    if (of.initial != nullptr) xml_.add_attributes({{"initial", of.initial}});
    if (of.derivative_of != 0) xml_.add_attributes({{"derivative", std::to_string(of.derivative_of)}});
    if (of.has_start) xml_.add_attributes({{"start", number(v.start)}});
    if (!v.name_in_model.empty())
      xml_.add_attributes({{"description", printable(v.name_in_model) + " in the model"}});
    xml_.close();
  }

  void add_variables() {
    fmu_variable time{.name = of_.time};
    if (of_.system.states_units) time.unit = written_unit(units::si::second);
    add(time, {.causality = "independent"});
    for (const fmu_variable& v : of_.states)
      add(v, {.causality = "output", .initial = v.is_dependent ? "approx" : "exact", .has_start = true});
    int state = fmu::first_state;
    for (const fmu_variable& v : of_.rates_of_states)
      add(v, {.initial = "calculated", .derivative_of = state++});
    for (const fmu_variable& v : of_.parameters)
      add(v, {.causality = "parameter", .initial = "exact", .has_start = true, .variability = "tunable"});
    for (const fmu_variable& v : of_.inputs) add(v, {.causality = "input", .has_start = true});
    for (const fmu_variable& v : of_.outputs) add(v, {.causality = "output", .initial = "calculated"});
    for (const fmu_variable& v : of_.indicators) add(v, {.initial = "calculated"});
  }

  /// Lists each unknown with its dependencies.
  void add_structure() {
    const int states = of_.count_of_states(), outputs = static_cast<int>(of_.outputs.size());
    for (int i = 0; i < states; ++i) add_unknown("Output", fmu::first_state + i, {fmu::first_state + i});
    for (int i = 0; i < outputs; ++i) add_unknown("Output", of_.first_output() + i, measured_depends_on(i));
    for (int i = 0; i < states; ++i)
      add_unknown("ContinuousStateDerivative", of_.first_rate() + i, rate_depends_on(i));
    for (int i = 0; i < states; ++i)
      if (of_.states[static_cast<std::size_t>(i)].is_dependent) add_initial_unknown(fmu::first_state + i);
    for (int i = 0; i < outputs; ++i) add_initial_unknown(of_.first_output() + i);
    for (int i = 0; i < states; ++i) add_initial_unknown(of_.first_rate() + i);
    for (int i = 0; i < static_cast<int>(of_.indicators.size()); ++i)
      add_unknown("EventIndicator", of_.first_indicator() + i, measured_depends_on(outputs + i));
  }

  void add_unknown(const char* kind, int reference, const std::vector<int>& on) {
    xml_.add(kind, {{"valueReference", std::to_string(reference)}, {"dependencies", joined(on, " ")}});
  }
  /// During initialization, parameters also matter, and values that follow from the constraints depend on all
  /// states; CasADi requires the full list, so all known variables are listed.
  void add_initial_unknown(int reference) {
    std::vector<int> on{0};
    int state = fmu::first_state;
    for (const fmu_variable& v : of_.states) {
      if (!v.is_dependent) on.push_back(state);
      ++state;
    }
    for (int i = of_.first_parameter(); i < of_.first_output(); ++i) on.push_back(i);
    add_unknown("InitialUnknown", reference, on);
  }

  std::vector<int> rate_depends_on(int i) const {
    return depends_on(of_.system.function(fmu::jacobian), of_.system.function(fmu::rates_by_time), i);
  }
  std::vector<int> measured_depends_on(int i) const {
    const exported_function* by_all = of_.system.function(fmu::measured_derivatives);
    return depends_on(by_all, by_all, i);
  }

  /// The columns of the nonzero entries in a row.
  std::vector<int> depends_on(const exported_function* by_state, const exported_function* by_time,
                              int row) const {
    std::vector<int> on;
    const auto look = [&](const exported_function* f, const char* matrix, int first) {
      if (f == nullptr) return;
      for (const exported_result& each : f->results)
        if (each.name == matrix)
          for (int j = 0; j < each.columns; ++j)
            if (!fmu::is_zero(*f, each.first + row * each.columns + j)) on.push_back(first + j);
    };
    look(by_time, "by_time", 0);
    look(by_state, "by_state", fmu::first_state);
    look(by_state, "by_inputs", of_.first_input());
    return on;
  }

  const fmu& of_;
  xml_file xml_{};
  int next_reference_ = 0;
};

} // namespace kanexpr::exporting
