#pragma once

#include "playground/session.hpp"
#include "playground/take_away/files.hpp"

#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/exporting/c/c_file.hpp>
#include <kanexpr/exporting/fmi/fmu_maker.hpp>
#include <kanexpr/exporting/fmi/source_file.hpp>
#include <kanexpr/runtime/staged_derivation.hpp>

#include <string>
#include <vector>

namespace playground {

/// The values of all symbols that a user of the FMU may set.
inline std::vector<kanexpr::named_value> start_values(const session& of) {
  const auto& known = of.moving().known();
  std::vector<kanexpr::named_value> start;
  for (int i = 0; i < known.symbols(); ++i)
    if (!known.dependent[i] || i < known.coordinates) start.push_back({known.names[i].view(), of.value(i)});
  return start;
}

/// The files of an FMU as `write_fmu` writes it without a compiler: descriptions and sources.
inline files export_fmu(const session& of, const std::string& name) {
  using namespace kanexpr::exporting;
  kanexpr::runtime::staged_derivation derivation(
      [&] { return kanexpr::runtime::derive_in_own_graph(of.builder()); });
  fmu_options chosen;
  chosen.start = start_values(of);
  const made_fmu made = fmu_maker(name, derivation, chosen).run();
  if (!made.mistake.empty()) return {.mistake = made.mistake};
  if (const std::string mistake = mistake_of_numbers(made.of.system, precision::double_precision);
      !mistake.empty())
    return {.mistake = mistake};
  const fmu_texts texts = texts_of(made.of);
  return {.all = {{"modelDescription.xml", texts.description},
                  {"sources/buildDescription.xml", texts.sources_description},
                  {"sources/" + name + ".h", texts.header},
                  {"sources/" + name + ".c", texts.code},
                  {"sources/" + name + "_fmi.c", texts.functions}}};
}

} // namespace playground
