#pragma once

#include "playground/session.hpp"
#include "playground/take_away/files.hpp"

#include <kanexpr/exporting/c/c_file.hpp>
#include <kanexpr/exporting/cpp/cpp_file.hpp>
#include <kanexpr/exporting/exporter.hpp>
#include <kanexpr/exporting/python/python_file.hpp>
#include <kanexpr/exporting/text/scalar.hpp>
#include <kanexpr/runtime/staged_derivation.hpp>

#include <string>

namespace playground {

/// The files of `write_c` with headers for C++ and Python.
inline files export_c(const session& of, const std::string& name) {
  using namespace kanexpr::exporting;
  kanexpr::runtime::staged_derivation derivation(
      [&] { return kanexpr::runtime::derive_in_own_graph(of.builder()); });
  const exported made = exporter(name, derivation, {}).run();
  if (!made.mistake.empty()) return {.mistake = made.mistake};
  constexpr precision number = precision::double_precision;
  if (const std::string mistake = mistake_of_numbers(made.system, number); !mistake.empty())
    return {.mistake = mistake};
  const c_file c(made.system, number);
  return {.all = {{name + ".h", c.header()},
                  {name + ".c", c.source()},
                  {name + ".hpp", cpp_file(made.system, number).text()},
                  {name + ".py", python_file(made.system, number).text()}}};
}

} // namespace playground
