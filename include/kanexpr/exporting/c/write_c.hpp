#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/exporting/c/c_file.hpp>
#include <kanexpr/exporting/cpp/cpp_file.hpp>
#include <kanexpr/exporting/exporter.hpp>
#include <kanexpr/exporting/files.hpp>
#include <kanexpr/exporting/format.hpp>
#include <kanexpr/exporting/python/python_file.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <string>
#include <vector>

namespace kanexpr {

namespace exporting {

/// Options of `write_c`: the functions to write, and their scalar type.
struct c_options {
  std::vector<requested_function> functions = default_results();
  std::vector<bound_parameter> bound{}; ///< parameters that are exported as numbers
  precision number = precision::double_precision;
  bool with_python = false; ///< also writes `name`.py, a module that calls the functions through ctypes
  bool with_cpp =
      false; ///< also writes `name`.hpp, which calls them from C++11 and later with the model's names
  function_lengths lengths{}; ///< of functions, in lines; longer ones call functions for their pieces

  operator options() const { return {functions, bound}; }
};

namespace detail {

inline outcome write_c(const exported& of, const std::filesystem::path& folder, const c_options& chosen) {
  if (!of.mistake.empty()) return outcome(of.mistake);
  if (chosen.lengths.longest < 1 || chosen.lengths.piece < 1)
    return outcome("functions must be allowed to have at least one line");
  if (chosen.number == precision::single_precision)
    for (const bound_parameter& each : chosen.bound)
      if (!base::equal(each.value, 0.0) && base::equal(static_cast<float>(each.value), 0.0F))
        return outcome("parameter " + each.name + " is bound to a number that is 0 in float");
  if (const std::string mistake = mistake_of_numbers(of.system, chosen.number); !mistake.empty())
    return outcome(mistake);
  const c_file file(of.system, chosen.number, chosen.lengths);
  std::vector<file_text> files{{folder / (of.system.name + ".h"), file.header()},
                               {folder / (of.system.name + ".c"), file.source()}};
  if (chosen.with_python)
    files.push_back({folder / (of.system.name + ".py"), python_file(of.system, chosen.number).text()});
  if (chosen.with_cpp)
    files.push_back({folder / (of.system.name + ".hpp"), cpp_file(of.system, chosen.number).text()});
  return write_files(files);
}

} // namespace detail

inline constexpr export_format c_format{
    .name = "c",
    .has_functions = true,
    .has_float = true,
    .has_callers = true,
    .write = [](runtime::staged_derivation& derivation, const export_options& given) {
      c_options chosen{.bound = given.bound,
                       .number = given.number,
                       .with_python = given.with_python,
                       .with_cpp = given.with_cpp};
      if (!given.functions.empty()) chosen.functions = given.functions;
      return detail::write_c(exporter(given.name, derivation, chosen).run(), given.folder, chosen);
    }};

} // namespace exporting

/// Writes results of a system as C99 functions to `folder`/`name`.c and .h, or reports why it cannot; no file
/// is left half-written. Their values equal those of the compiled functions to the last bit if neither
/// compiler fuses multiplications with additions. `chosen` specifies the functions to export.
template <class System>
outcome write_c(const std::filesystem::path& folder, const std::string& name,
                const exporting::c_options& chosen = {}) {
  return exporting::detail::write_c(exporting::exported_from<System>(name, chosen), folder, chosen);
}

/// The same for a system built by a builder.
inline outcome write_c(const runtime::builder& of, const std::filesystem::path& folder,
                       const std::string& name, const exporting::c_options& chosen = {}) {
  runtime::staged_derivation derivation([&] { return runtime::derive_in_own_graph(of); });
  return exporting::detail::write_c(exporting::exporter(name, derivation, chosen).run(), folder, chosen);
}

} // namespace kanexpr
