#pragma once

#include <kanexpr/base/version.hpp>
#include <kanexpr/exporting/fmi/escaped_for_xml.hpp>
#include <kanexpr/exporting/fmi/fmi_source.hpp>
#include <kanexpr/exporting/fmi/fmu.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/scalar.hpp>

#include <string>

namespace kanexpr::exporting {

/// Writes modelDescription.xml and buildDescription.xml of FMI 3.0.
class model_description {
public:
  explicit model_description(const fmu& of) : of_(of), system_(of.system) {}

  std::string text(const std::string& token) const {
    return fill_template(
        fmi_source::model_description,
        {{"name", system_.name},
         {"token", token},
         {"version", version()},
         {"watched", of_.function(fmu::correction) == nullptr && of_.indicators.empty() ? "false" : "true"},
         {"step", number(of_.step_length)},
         {"variables", variables()},
         {"structure", structure()}});
  }

  /// The text of buildDescription.xml, which is stored with the sources.
  std::string build() const { return fill_template(fmi_source::build_description, {{"name", system_.name}}); }

private:
  static std::string version() {
    return std::to_string(KANEXPR_VERSION_MAJOR) + '.' + std::to_string(KANEXPR_VERSION_MINOR) + '.' +
           std::to_string(KANEXPR_VERSION_PATCH);
  }
  static std::string number(double value) { return scalar(precision::double_precision).number(value); }

  static std::string variable(const fmu_variable& v, int reference, const std::string& attributes) {
    std::string text = "    <Float64 name=\"" + escaped_for_xml(v.name) + "\" valueReference=\"" +
                       std::to_string(reference) + "\" " + attributes;
    if (!v.of.empty()) text += " description=\"" + escaped_for_xml(v.of) + " in the model\"";
    return text + "/>\n";
  }
  static std::string start_of(const fmu_variable& v) { return " start=\"" + number(v.start) + '"'; }

  std::string variables() const {
    std::string text = variable({of_.time, {}, 0}, 0, R"(causality="independent" variability="continuous")");
    for (int i = 0; i < of_.count_of_states(); ++i) {
      const fmu_variable& v = of_.states[static_cast<std::size_t>(i)];
      text +=
          variable(v, fmu::first_state + i,
                   std::string(R"(causality="output" variability="continuous" initial=")") +
                       (of_.dependent[static_cast<std::size_t>(i)] ? "approx\"" : "exact\"") + start_of(v));
    }
    for (int i = 0; i < of_.count_of_states(); ++i)
      text += variable(of_.rates_of_states[static_cast<std::size_t>(i)], of_.first_rate() + i,
                       R"(causality="local" variability="continuous" initial="calculated" derivative=")" +
                           std::to_string(fmu::first_state + i) + '"');
    int reference = of_.first_parameter();
    for (const fmu_variable& v : of_.parameters)
      text += variable(v, reference++,
                       R"(causality="parameter" variability="tunable" initial="exact")" + start_of(v));
    for (const fmu_variable& v : of_.inputs)
      text += variable(v, reference++, R"(causality="input" variability="continuous")" + start_of(v));
    for (const fmu_variable& v : of_.outputs)
      text += variable(v, reference++, R"(causality="output" variability="continuous" initial="calculated")");
    for (const fmu_variable& v : of_.indicators)
      text += variable(v, reference++, R"(causality="local" variability="continuous" initial="calculated")");
    return text;
  }

  /// Lists each unknown with its dependencies.
  std::string structure() const {
    std::string text;
    for (int i = 0; i < of_.count_of_states(); ++i)
      text += unknown("Output", fmu::first_state + i, ' ' + std::to_string(fmu::first_state + i));
    for (int i = 0; i < static_cast<int>(of_.outputs.size()); ++i)
      text += unknown("Output", of_.first_output() + i, measured_depends_on(i));
    for (int i = 0; i < of_.count_of_states(); ++i)
      text += unknown("ContinuousStateDerivative", of_.first_rate() + i, rate_depends_on(i));
    for (int i = 0; i < of_.count_of_states(); ++i)
      if (of_.dependent[static_cast<std::size_t>(i)]) text += initial_unknown(fmu::first_state + i);
    for (int i = 0; i < static_cast<int>(of_.outputs.size()); ++i)
      text += initial_unknown(of_.first_output() + i);
    for (int i = 0; i < of_.count_of_states(); ++i) text += initial_unknown(of_.first_rate() + i);
    for (int i = 0; i < static_cast<int>(of_.indicators.size()); ++i)
      text += unknown("EventIndicator", of_.first_indicator() + i,
                      measured_depends_on(static_cast<int>(of_.outputs.size()) + i));
    return text;
  }

  static std::string unknown(const char* kind, int reference, const std::string& on) {
    return std::string("    <") + kind + " valueReference=\"" + std::to_string(reference) +
           "\" dependencies=\"" + (on.empty() ? on : on.substr(1)) + "\"/>\n";
  }
  /// During initialization, parameters matter too, and values that follow from the constraints depend on all
  /// states; CasADi requires the full list, so all known variables are listed.
  std::string initial_unknown(int reference) const {
    std::string on;
    for (int i = 0; i < of_.count_of_states(); ++i)
      if (!of_.dependent[static_cast<std::size_t>(i)]) on += ' ' + std::to_string(fmu::first_state + i);
    for (int i = of_.first_parameter(); i < of_.first_output(); ++i) on += ' ' + std::to_string(i);
    return unknown("InitialUnknown", reference, " 0" + on);
  }

  std::string rate_depends_on(int i) const {
    return depends_on(of_.function(fmu::jacobian), of_.function(fmu::rates_by_time), i);
  }
  std::string measured_depends_on(int i) const {
    const exported_function* by_all = of_.function(fmu::measured_derivatives);
    return depends_on(by_all, by_all, i);
  }

  /// The columns of the nonzero entries in a row.
  std::string depends_on(const exported_function* by_state, const exported_function* by_time, int row) const {
    std::string on;
    const auto look = [&](const exported_function* f, const char* matrix, int first) {
      if (f == nullptr) return;
      for (const exported_result& each : f->results)
        if (each.name == matrix)
          for (int j = 0; j < each.columns; ++j)
            if (!fmu::is_zero(*f, each.first + row * each.columns + j)) on += ' ' + std::to_string(first + j);
    };
    look(by_time, "by_time", 0);
    look(by_state, "by_state", fmu::first_state);
    look(by_state, "by_inputs", of_.first_input());
    return on;
  }

  const fmu& of_;
  const exported_system& system_;
};

} // namespace kanexpr::exporting
