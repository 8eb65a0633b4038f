#pragma once

#include <kanexpr/export/c/c_file.hpp>
#include <kanexpr/export/exporter.hpp>
#include <kanexpr/export/files.hpp>
#include <kanexpr/export/fmi/model_description.hpp>
#include <kanexpr/export/fmi/source_file.hpp>
#include <kanexpr/export/fmu_maker.hpp>
#include <kanexpr/runtime/builder.hpp>

namespace kanexpr {

namespace exporting::detail {

inline outcome write_fmu(const made_fmu& made, const std::filesystem::path& folder) {
  if (!made.mistake.empty()) return outcome(made.mistake);
  const std::string& name = made.of.system.name;
  const std::filesystem::path sources = folder / "sources";
  const c_file model(made.of.system, precision::double_precision);
  const model_description description(made.of);
  const fmu_source source(made.of);
  const std::string header = model.header(), code = model.source();
  // of all that says what the model is
  const std::string token = token_of({description.text({}), source.text({}), header, code});
  return write_files({{folder / "modelDescription.xml", description.text(token)},
                      {sources / "buildDescription.xml", description.build()},
                      {sources / (name + ".h"), header},
                      {sources / (name + ".c"), code},
                      {sources / (name + "_fmi.c"), source.text(token)}});
}

} // namespace exporting::detail

/// Writes what an FMU of FMI 3.0 holds into `folder`, modelDescription.xml and the sources, or says why not;
/// nothing is left half-written. A tool compiles these, or `kanexpr_export` in CMake, which leaves `name`.fmu
/// with a library too. The functions of `chosen` are its outputs.
template <class System>
outcome write_fmu(const std::filesystem::path& folder, const std::string& name,
                  const exporting::fmu_options& chosen = {}) {
  return exporting::detail::write_fmu(
      exporting::fmu_maker(name, [] { return kanexpr::derive<System>(); }, chosen).run(), folder);
}

/// The same of what a builder built.
inline outcome write_fmu(const runtime::builder& of, const std::filesystem::path& folder,
                         const std::string& name, const exporting::fmu_options& chosen = {}) {
  return exporting::detail::write_fmu(
      exporting::fmu_maker(name, [&] { return derive(of); }, chosen).run(), folder);
}

} // namespace kanexpr
