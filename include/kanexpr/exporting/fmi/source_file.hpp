#pragma once

#include <kanexpr/exporting/c/c_file.hpp>
#include <kanexpr/exporting/fmi/fmu.hpp>
#include <kanexpr/exporting/fmi/model_description.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/scalar.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// The C code of FMUs. It is the same for all models and uses `counts`, which precedes it. Memory is
/// allocated only when an instance is created; instances share nothing.
namespace fmi {

inline constexpr std::string_view counts = template_text(
#include <kanexpr/exporting/fmi/counts.c.in>
);

/// Types of FMI 3.0 as defined by the standard, and the instance.
inline constexpr std::string_view declarations = template_text(
#include <kanexpr/exporting/fmi/declarations.c.in>
);

/// Used by functions that have checks.
inline constexpr std::string_view failure = template_text(
#include <kanexpr/exporting/fmi/failure.c.in>
);

/// The parts that call the functions of the model: constraints, events and steps of fixed length; creation,
/// modes and steps of an instance; values and derivatives; functions that are not supported.
inline constexpr std::string_view functions[]{template_text(
#include <kanexpr/exporting/fmi/events_and_steps.c.in>
                                                  ),
                                              template_text(
#include <kanexpr/exporting/fmi/lifecycle.c.in>
                                                  ),
                                              template_text(
#include <kanexpr/exporting/fmi/values.c.in>
                                                  ),
                                              template_text(
#include <kanexpr/exporting/fmi/unsupported.c.in>
                                                  )};

} // namespace fmi

/// Writes NAME_fmi.c: the functions of FMI 3.0, based on those of NAME.c.
class fmu_source {
public:
  explicit fmu_source(const fmu& of) : of_(of), name_(of.system.name) {}

  std::string text(const std::string& token) const {
    std::string text = "/* The functions of FMI 3.0 for " + name_ + ". */\n#include \"" + name_ + ".h\"\n\n";
    for (const char* header : {"math", "stdbool", "stddef", "stdint", "stdlib", "string"})
      text += std::string("#include <") + header + ".h>\n";
    text += "\nstatic const char token[] = \"{" + token + "}\";\n" + counts() + tables();
    text += fmi::declarations;
    const std::string evaluated = evaluations();
    if (evaluated.find(" failed(") != evaluated.npos) text += fmi::failure;
    text += evaluated;
    for (const std::string_view part : fmi::functions) text += part;
    return text;
  }

private:
  std::string counts() const {
    return fill_template(fmi::counts,
                         {{"name", name_},
                          {"outputs", std::to_string(of_.outputs.size())},
                          {"indicators", std::to_string(of_.indicators.size())},
                          {"changes", std::to_string(of_.changed.size())},
                          {"drifts", of_.system.function(fmu::correction) == nullptr ? "0" : "1"}});
  }

  /// Returns an array; if there are no entries, it has a single entry 0.
  template <class Entries, class TextOf>
  static std::string array(const char* type, const char* called, const Entries& all, const TextOf& text_of) {
    return std::string("static const ") + type + ' ' + called + "[] = {" +
           (all.empty() ? "0" : joined(all, ", ", text_of)) + "};\n";
  }

  std::string tables() const {
    const auto number = [](double value) { return scalar(precision::double_precision).number(value); };
    const auto start = [&](const fmu_variable& v) { return number(v.start); };
    return '\n' + array("double", "start_of_states", of_.states, start) +
           array("double", "start_of_parameters", of_.parameters, start) +
           array("double", "start_of_inputs", of_.inputs, start) +
           array("int", "direction", of_.directions,
                 [](crossing each) { return std::to_string(static_cast<int>(each)); }) +
           array("bool", "ends_motion", of_.ends, [](bool each) { return each ? "true" : "false"; }) +
           array("int", "changed_by", of_.changed,
                 [](const fmu_change& each) { return std::to_string(each.event); }) +
           array("int", "changed_place", of_.changed,
                 [](const fmu_change& each) { return std::to_string(each.place); }) +
           "static const double internal_step = " + number(of_.step_length) + ";\n";
  }

  std::string evaluations() const {
    using f = fmu;
    return evaluation("rates", "rates_are_known", {{f::rates, {"rates"}}}) +
           evaluation("measured", "measured_is_known", {{f::measured, {"measured"}}}) +
           evaluation("jacobian", "jacobian_is_known",
                      {{f::jacobian, {"by_state", "by_inputs"}}, {f::rates_by_time, {"by_time"}}}) +
           evaluation(
               "measured_derivatives", "measured_jacobian_is_known",
               {{f::measured_derivatives, {"measured_by_state", "measured_by_inputs", "measured_by_time"}}}) +
           evaluation("changes", "", {{f::changes, {"changes"}}}) +
           evaluation("step", "", {{f::step, {"next"}}}, "instance *of, double h") +
           evaluation("correction", "", {{f::correction, {"next"}}});
  }

  struct call {
    const char* function;
    std::vector<std::string> into; ///< members of the instance
  };

  /// Returns a C function that stores results of the system in members of an instance.
  std::string evaluation(const std::string& called, const std::string& known, const std::vector<call>& calls,
                         const std::string& given = "instance *of") const {
    std::string text = "\nstatic fmi3Status find_" + called + '(' + given + ") {\n", made;
    for (const call& each : calls)
      if (const exported_function* const f = of_.system.function(each.function))
        made += evaluated(*f, each.into);
    if (made.empty()) return text + "  (void)of;\n  return fmi3OK;\n}\n";
    text += "  unsigned long long status;\n";
    if (!known.empty()) text += "  if (of->known & " + known + ") return fmi3OK;\n";
    text += made;
    if (!known.empty()) text += "  of->known |= " + known + ";\n";
    return text + "  return fmi3OK;\n}\n";
  }

  /// Several results that share a member of the instance are stored there one after another. Without inputs
  /// there is no derivative with respect to them.
  std::string evaluated(const exported_function& f, const std::vector<std::string>& into) const {
    const std::string whole = name_ + '_' + f.name;
    const char* const step = !f.takes_step ? "" : f.name == fmu::step ? "h, " : "0, ";
    std::string arguments = std::string("of->t, of->x, ") + step + "of->p, of->r", finite;
    for (const exported_result& each : f.results) {
      const std::string* to = &into[0];
      for (const std::string& other : into)
        if (into.size() > 1 && other.ends_with(each.name)) to = &other;
      const int first = into.size() > 1 ? 0 : each.first;
      arguments += ", of->" + *to + (first > 0 ? " + " + std::to_string(first) : "");
      finite += "  if (finite(of, of->" + *to + (first > 0 ? " + " + std::to_string(first) : "") + ", " +
                std::to_string(each.entries()) + ") != fmi3OK) return fmi3Discard;\n";
    }
    std::string text = "  status = " + whole + '(' + arguments + ");\n";
    text += f.checks.empty()
                ? "  (void)status;\n"
                : "  if (status) return failed(of, status, " + whole + "_causes, " + whole + "_checks);\n";
    return text + finite;
  }

  const fmu& of_;
  const std::string& name_;
};

/// The texts of an FMU: all of its contents except compiled libraries.
struct fmu_texts {
  std::string description{}, sources_description{}; ///< modelDescription.xml and buildDescription.xml
  std::string header{}, code{}, functions{};        ///< `name`.h, `name`.c and `name`_fmi.c
};

inline fmu_texts texts_of(const fmu& of) {
  const std::string& name = of.system.name;
  const c_file model(of.system, precision::double_precision);
  const fmu_source source(of);
  fmu_texts all{.sources_description = build_description(name), .header = model.header()};
  all.code = "#define " + name + "_ANGLES_WITHOUT_END\n" + model.source();
  // computed from everything that defines the model
  const std::string token =
      content_hash({model_description(of).text({}), source.text({}), all.header, all.code});
  all.description = model_description(of).text(token);
  all.functions = source.text(token);
  return all;
}

} // namespace kanexpr::exporting
