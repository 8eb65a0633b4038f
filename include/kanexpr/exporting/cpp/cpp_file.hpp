#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/names_in_c.hpp>
#include <kanexpr/exporting/text/scalar.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// The text of C++ headers.
namespace cpp {

inline constexpr std::string_view header = template_text(
#include <kanexpr/exporting/cpp/header.hpp.in>
);

inline constexpr std::string_view structure = template_text(
#include <kanexpr/exporting/cpp/structure.hpp.in>
);

inline constexpr std::string_view function = template_text(
#include <kanexpr/exporting/cpp/function.hpp.in>
);

} // namespace cpp

/// Writes NAME.hpp, which calls the functions of NAME.c from C++11 and later: structures with the names of
/// the model, and results with a status.
class cpp_file {
public:
  cpp_file(const exported_system& s, precision number) : mapped_(names_in_c(s)), number_(number) {}

  std::string text() const {
    const exported_system& s = mapped_.system;
    identifiers namespaces;
    namespaces.reserve_words();
    namespaces.reserve_words_of_mathematics();
    namespaces.reserve("std");
    const std::string own = namespaces.unique(s.name);
    std::string all = fill_template(
        cpp::header, {{"name", s.name},
                      {"own_header", "#include \"" + s.name + ".h\""},
                      {"own", own},
                      {"state", structure("state", s.states(), "0", s.units_of_states)},
                      {"parameters", structure("parameters", s.parameters, not_set(), s.units_of_parameters)},
                      {"inputs", structure("inputs", s.inputs, not_set(), s.units_of_inputs)},
                      {"rates", structure("rates", s.speeds, not_set(), {})}});
    identifiers functions;
    functions.reserve_words();
    functions.reserve("state parameters inputs rates status status_of");
    for (const exported_function& f : s.functions) all += definition(f, functions.unique(f.name));
    return all + "\n} // namespace " + own + "\n\n#endif\n";
  }

private:
  std::string not_set() const {
    return std::string("std::numeric_limits<") + number_.type() + ">::quiet_NaN()";
  }

  /// A structure of named numbers that is read from and written to an array, with their units as comments.
  std::string structure(const std::string& name, const std::vector<std::string>& symbols,
                        const std::string& at_first, const std::vector<exported_unit>& units) const {
    identifiers names;
    names.reserve_words();
    names.reserve_words_of_mathematics();
    names.reserve("from put std entries");
    names.reserve(name);
    std::string declared, read, written;
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      const std::string member = names.unique(symbols[i]), entry = "entries[" + std::to_string(i) + ']';
      declared.append("  ").append(number_.type()).append(" ").append(member).append(" = ").append(at_first);
      declared += ';';
      if (!units.empty() && units[i].is_known()) declared += " // " + units[i].text;
      declared += '\n';
      read.append("    found.").append(member).append(" = ").append(entry).append(";\n");
      written.append("    ").append(entry).append(" = ").append(member).append(";\n");
    }
    const bool is_empty = symbols.empty();
    return fill_template(cpp::structure, {{"name", name},
                                          {"number", number_.type()},
                                          {"entries", is_empty ? "" : "entries"},
                                          {"declared", declared},
                                          {"read", read},
                                          {"written", written}});
  }

  /// Declares and fills a vector argument of a C function.
  std::string given(const std::string& name, std::size_t entries) const {
    return std::string("  ") + number_.type() + " given_" + name + '[' +
           std::to_string(entries > 0 ? entries : 1) + "];\n  " + name + ".put(given_" + name + ");\n";
  }

  /// A parameter of a function. Trailing parameters have a default if the system has no such quantities.
  static std::string taken(const std::string& type, const char* name, bool is_empty) {
    return "const " + type + " &" + name + (is_empty ? " = " + type + "()" : "");
  }

  std::string definition(const exported_function& f, const std::string& name) const {
    const exported_system& s = mapped_.system;
    const std::string number = number_.type();
    std::string declared, called, filled_in;
    identifiers members;
    members.reserve("made");
    for (const exported_result& each : f.results) {
      const std::string member = members.unique(each.name), place = "found." + member;
      if (f.takes_step) {
        declared += "  state " + member + ";\n";
        filled_in += "  " + place + " = state::from(given_x);\n";
        called += ", given_x";
        continue;
      }
      declared.append("  ").append(number).append(" ").append(member);
      declared.append("[").append(std::to_string(each.rows)).append("]");
      if (each.columns > 1) declared += '[' + std::to_string(each.columns) + ']';
      declared += ";\n";
      called += ", " + place + (each.columns > 1 ? "[0]" : "");
    }
    return fill_template(
        cpp::function,
        {{"name", name},
         {"function", f.name},
         {"system", s.name},
         {"number", number},
         {"declared", declared},
         {"x", taken("state", "x", false)},
         {"h", f.takes_step ? ", " + number + " h" : ""},
         {"p", taken("parameters", "p", s.parameters.empty() && s.inputs.empty() && !f.takes_rates)},
         {"r", taken("inputs", "r", s.inputs.empty() && !f.takes_rates)},
         {"a", f.takes_rates ? ", " + taken("rates", "a", false) : ""},
         {"given", given("x", s.coordinates.size() + s.speeds.size()) + given("p", s.parameters.size()) +
                       given("r", s.inputs.size()) + (f.takes_rates ? given("a", s.speeds.size()) : "")},
         {"with_h", f.takes_step ? ", h" : ""},
         {"with_a", f.takes_rates ? ", given_a" : ""},
         {"called", called},
         {"causes", f.checks.empty() ? "nullptr" : s.name + '_' + f.name + "_causes"},
         {"filled", filled_in}});
  }

  system_with_c_names mapped_;
  scalar number_;
};

} // namespace kanexpr::exporting
