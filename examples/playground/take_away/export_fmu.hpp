#pragma once

#include "playground/session.hpp"
#include "playground/take_away/files.hpp"

#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/exporting/c/c_file.hpp>
#include <kanexpr/exporting/fmi/fmu_maker.hpp>
#include <kanexpr/exporting/fmi/model_description.hpp>
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
  const c_file model(made.of.system, precision::double_precision);
  const fmu_source source(made.of);
  const std::string header = model.header(),
                    code = "#define " + name + "_ANGLES_WITHOUT_END\n" + model.source();
  const std::string token =
      content_hash({model_description(made.of).text({}), source.text({}), header, code});
  return {.all = {{"modelDescription.xml", model_description(made.of).text(token)},
                  {"sources/buildDescription.xml", build_description(name)},
                  {"sources/" + name + ".h", header},
                  {"sources/" + name + ".c", code},
                  {"sources/" + name + "_fmi.c", source.text(token)}}};
}

} // namespace playground
