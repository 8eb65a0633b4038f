#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/names_in_c.hpp>
#include <kanexpr/exporting/text/scalar.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// The text of Python modules.
namespace python {

inline constexpr std::string_view module = template_text(
#include <kanexpr/exporting/python/module.py.in>
);

inline constexpr std::string_view function = template_text(
#include <kanexpr/exporting/python/function.py.in>
);

} // namespace python

/// Writes NAME.py, a module that calls the functions of NAME.c through ctypes, with names and plain lists.
class python_file {
public:
  python_file(const exported_system& s, precision number) : mapped_(names_in_c(s)), number_(number) {}

  std::string text() const {
    const exported_system& s = mapped_.system;
    std::string all = fill_template(python::module, {{"name", s.name},
                                                     {"states", tuple(s.states())},
                                                     {"speeds", tuple(s.speeds)},
                                                     {"parameters", tuple(s.parameters)},
                                                     {"inputs", tuple(s.inputs)},
                                                     {"units", units()},
                                                     {"number", std::string("c_") + number_.type()}});
    for (const exported_function& f : s.functions) all += definition(f);
    return all;
  }

private:
  static std::string tuple(const std::vector<std::string>& names) {
    return '(' + joined(names, ", ", [](const std::string& each) { return '"' + each + '"'; }) +
           (names.size() == 1 ? ",)" : ")");
  }

  /// A dictionary of the known units; empty if the model states none.
  std::string units() const {
    const exported_system& s = mapped_.system;
    if (!s.states_units) return {};
    std::string text = "units = {\n";
    const auto add = [&](const std::vector<std::string>& names, const std::vector<exported_unit>& of) {
      for (std::size_t i = 0; i < names.size(); ++i)
        if (of[i].is_known()) text += "    \"" + names[i] + "\": \"" + of[i].text + "\",\n";
    };
    add(s.states(), s.units_of_states);
    add(s.parameters, s.units_of_parameters);
    add(s.inputs, s.units_of_inputs);
    return text + "}\n";
  }

  static std::string size_of(const exported_result& of) {
    return '(' + std::to_string(of.rows) + ", " + std::to_string(of.columns) + ')';
  }

  std::string definition(const exported_function& f) const {
    std::string causes;
    for (const std::string& each : f.causes()) causes += "\n    \"" + each + "\",";
    return fill_template(python::function,
                         {{"function", f.name},
                          {"name", mapped_.system.name},
                          {"causes", causes + (causes.empty() ? "" : "\n")},
                          {"h", f.takes_step ? ", h" : ""},
                          {"a", f.takes_rates ? ", a=()" : ""},
                          {"more", more_vectors(f)},
                          {"called", joined(f.results, ", ", [](const auto& each) { return each.name; })},
                          {"sizes", joined(f.results, ", ", size_of)}});
  }

  /// The arguments that a function takes in addition to states, parameters and inputs.
  std::string more_vectors(const exported_function& f) const {
    if (f.takes_step) return std::string("    vectors.insert(1, ctypes.c_") + number_.type() + "(h))\n";
    return f.takes_rates ? "    vectors.append(_vector(a, speeds, \"rates of the speeds\"))\n" : "";
  }

  system_with_c_names mapped_;
  scalar number_;
};

} // namespace kanexpr::exporting
