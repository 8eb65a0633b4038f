#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/exporting/c/write_c.hpp>
#include <kanexpr/exporting/fmi/fmu_maker.hpp>
#include <kanexpr/exporting/fmi/library.hpp>
#include <kanexpr/exporting/fmi/source_file.hpp>
#include <kanexpr/exporting/fmi/zip_archive.hpp>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

namespace exporting {

/// The outcome of writing an FMU.
class [[nodiscard]] written_fmu : public outcome {
public:
  using outcome::outcome;

  /// Explains why the FMU contains only sources; empty if it contains a library.
  const std::string& note() const { return note_; }
  void set_note(std::string why) { note_ = std::move(why); }

private:
  std::string note_{};
};

namespace detail {

inline written_fmu write_fmu(runtime::staged_derivation& derivation, const std::filesystem::path& folder,
                             const std::string& name, const fmu_options& chosen) {
  const made_fmu made = fmu_maker(name, derivation, chosen).run();
  if (!made.mistake.empty()) return written_fmu(made.mistake);
  if (const std::string mistake = mistake_of_numbers(made.of.system, precision::double_precision);
      !mistake.empty())
    return written_fmu(mistake);
  const fmu_texts texts = texts_of(made.of);
  const std::vector<file_text> sources{
      {name + ".h", texts.header}, {name + ".c", texts.code}, {name + "_fmi.c", texts.functions}};
  const library compiled = compiled_library(name, sources, chosen.compiler);
  if (!compiled.mistake.empty()) return written_fmu(compiled.mistake);
  std::vector<file_text> all{{"modelDescription.xml", texts.description},
                             {"sources/buildDescription.xml", texts.sources_description}};
  for (const file_text& each : sources) all.push_back({"sources" / each.path, each.text});
  if (!compiled.bytes.empty())
    all.push_back({"binaries/" + library::platform() + '/' + name + library::ending(), compiled.bytes});
  const std::string bytes = zipped(all);
  if (bytes.empty()) return written_fmu("not enough memory for the archive of " + name + ".fmu");
  const outcome written = write_files({{folder / (name + ".fmu"), bytes}});
  if (!written) return written_fmu(written.cause());
  written_fmu done;
  if (!compiled.note.empty()) done.set_note(name + ".fmu " + compiled.note);
  return done;
}

} // namespace detail

inline constexpr export_format fmi_format{
    .name = "fmi",
    .has_functions = true,
    .has_simulation = true,
    .write = [](runtime::staged_derivation& derivation, const export_options& given) -> outcome {
      fmu_options chosen{.outputs = given.functions, .bound = given.bound, .start = given.start};
      if (given.step) chosen.step = *given.step;
      if (given.compiler) chosen.compiler = *given.compiler;
      written_fmu written = detail::write_fmu(derivation, given.folder, given.name, chosen);
      if (!written.note().empty()) std::fprintf(stderr, "kanexpr-export: note: %s\n", written.note().c_str());
      return written;
    }};

} // namespace exporting

/// Writes `folder`/`name`.fmu, an FMI 3.0 FMU with its sources and a library for the host machine, or reports
/// why it cannot; no file is left half-written. The library is compiled by `chosen.compiler`; if it is not
/// available, the FMU contains only the sources, and `note()` explains why. The functions of `chosen` are its
/// outputs.
template <class System>
exporting::written_fmu write_fmu(const std::filesystem::path& folder, const std::string& name,
                                 const exporting::fmu_options& chosen = {}) {
  runtime::staged_derivation derivation([] { return derive<System>(); });
  return exporting::detail::write_fmu(derivation, folder, name, chosen);
}

/// The same for a system built by a builder. Its expressions may be outputs and events.
inline exporting::written_fmu write_fmu(const runtime::builder& of, const std::filesystem::path& folder,
                                        const std::string& name, const exporting::fmu_options& chosen = {}) {
  runtime::staged_derivation derivation([&] { return runtime::derive_in_own_graph(of); });
  return exporting::detail::write_fmu(derivation, folder, name, chosen);
}

} // namespace kanexpr
