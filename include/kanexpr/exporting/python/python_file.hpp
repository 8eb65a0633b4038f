#pragma once

#include <kanexpr/exporting/python/python_templates.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/names_in_c.hpp>
#include <kanexpr/exporting/text/scalar.hpp>

#include <string>
#include <vector>

namespace kanexpr::exporting {

/// Writes NAME.py, a module that calls the functions of NAME.c through ctypes, with names and plain lists.
class python_file {
public:
  python_file(const exported_system& s, precision number) : mapped_(names_in_c(s)), number_(number) {}

  std::string text() const {
    const exported_system& s = mapped_.system;
    std::vector<std::string> states = s.coordinates;
    states.insert(states.end(), s.speeds.begin(), s.speeds.end());
    std::string all =
        fill_template(python_templates::module, {{"name", s.name},
                                                 {"states", tuple(states)},
                                                 {"speeds", tuple(s.speeds)},
                                                 {"parameters", tuple(s.parameters)},
                                                 {"inputs", tuple(s.inputs)},
                                                 {"number", std::string("c_") + number_.type()}});
    for (const exported_function& f : s.functions) all += definition(f);
    return all;
  }

private:
  static std::string tuple(const std::vector<std::string>& names) {
    std::string all = "(";
    for (const std::string& each : names) all += '"' + each + "\", ";
    if (names.size() > 1) all.resize(all.size() - 2);
    return names.size() == 1 ? all.substr(0, all.size() - 1) + ')' : all + ')';
  }

  std::string definition(const exported_function& f) const {
    std::string sizes, called, causes;
    for (const exported_result& each : f.results) {
      sizes += "(" + std::to_string(each.rows) + ", " + std::to_string(each.columns) + "), ";
      called += (called.empty() ? "" : ", ") + each.name;
    }
    for (const std::string& each : f.causes()) causes += "\n    \"" + each + "\",";
    return fill_template(python_templates::function, {{"function", f.name},
                                                      {"name", mapped_.system.name},
                                                      {"causes", causes + (causes.empty() ? "" : "\n")},
                                                      {"h", f.takes_step ? ", h" : ""},
                                                      {"a", f.takes_rates ? ", a=()" : ""},
                                                      {"more", more_vectors(f)},
                                                      {"called", called},
                                                      {"sizes", sizes.substr(0, sizes.size() - 2)}});
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
