#pragma once

#include <kanexpr/exporting/exported_system.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// Functions that C lacks; a file defines those that its code calls.
inline std::vector<symbolic::operation> written_functions() {
  std::vector<symbolic::operation> all;
  for (const auto& f : symbolic::functions)
    if (*f.in_c.body != '\0') all.push_back(f.op);
  for (const auto& f : symbolic::binary_functions)
    if (*f.in_c.body != '\0') all.push_back(f.op);
  return all;
}

/// A system with the names used in a C file.
struct system_with_c_names {
  exported_system system{};
  std::vector<std::pair<std::string, std::string>> changed{}; ///< model names and their replacements
};

/// Maps all names to C identifiers. Symbols and functions share one set of names, because all have the prefix
/// `NAME_`.
inline system_with_c_names names_in_c(exported_system s) {
  identifiers taken;
  taken.reserve("states coordinates speeds parameters inputs bits FUNCTION INLINE SINES_OF_THE_LIBRARY "
                "ANGLES_WITHOUT_END has_bits_of_that_size sine_and_cosine choose is_singular is_infinite "
                "is_not_above is_any_infinite");
  for (const symbolic::operation each : written_functions()) taken.reserve(symbolic::function_name(each));
  identifiers functions = taken;
  functions.reserve(words_of_python);
  if (s.states_units) functions.reserve("units");
  std::vector<std::pair<std::string, std::string>> changed;
  const auto map = [&](std::string& name, identifiers& among) {
    const std::string mapped = among.unique(name);
    if (mapped != name) changed.emplace_back(name, mapped);
    name = mapped;
  };
  for (exported_function& f : s.functions) {
    map(f.name, functions);
    taken.reserve(f.name);
    taken.reserve(f.name + "_checks");
    taken.reserve(f.name + "_causes");
    identifiers arguments; // of this function
    arguments.reserve_words();
    arguments.reserve_words_of_mathematics();
    arguments.reserve("t x p r a w");
    if (f.takes_step) arguments.reserve("h");
    for (exported_result& each : f.results) {
      map(each.name, arguments);
      for (const char* size : {"_rows", "_columns", "_entries"})
        taken.reserve((each.name == f.name ? f.name : f.name + '_' + each.name) + size);
    }
  }
  // the lists of rows contain the same symbols
  std::vector<std::pair<std::string, std::string>> symbols;
  for (std::vector<std::string>* names : {&s.coordinates, &s.speeds, &s.parameters, &s.inputs})
    for (std::string& each : *names) {
      const std::string before = each;
      map(each, taken);
      symbols.emplace_back(before, each);
    }
  for (exported_function& f : s.functions)
    for (exported_result& of : f.results)
      for (std::string& row : of.row_symbols) {
        const auto found =
            std::find_if(symbols.begin(), symbols.end(), [&](const auto& each) { return each.first == row; });
        if (found != symbols.end()) row = found->second;
      }
  return {std::move(s), std::move(changed)};
}

} // namespace kanexpr::exporting
