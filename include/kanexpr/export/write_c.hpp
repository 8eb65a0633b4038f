#pragma once

#include <kanexpr/export/c/c_file.hpp>
#include <kanexpr/export/exporter.hpp>
#include <kanexpr/export/files.hpp>
#include <kanexpr/runtime/builder.hpp>

namespace kanexpr {

namespace exporting {

struct c_options : options {
  precision number = precision::double_precision;
};

namespace detail {

inline outcome write_c(const exported& of, const std::filesystem::path& folder, precision number) {
  if (!of.mistake.empty()) return outcome(of.mistake);
  const c_file file(of.system, number);
  return write_files(
      {{folder / (of.system.name + ".h"), file.header()}, {folder / (of.system.name + ".c"), file.source()}});
}

} // namespace detail

} // namespace exporting

/// Writes results of a system as functions of C99, `folder`/`name`.c and .h, or says why not; nothing is left
/// half-written. Their values are those of the compiled functions to the last bit, where neither compiler
/// fuses multiplications with additions. What is exported stands in `chosen`.
template <class System>
outcome write_c(const std::filesystem::path& folder, const std::string& name,
                const exporting::c_options& chosen = {}) {
  return exporting::detail::write_c(exporting::exported_from<System>(name, chosen), folder, chosen.number);
}

/// The same of what a builder built.
inline outcome write_c(const runtime::builder& of, const std::filesystem::path& folder,
                       const std::string& name, const exporting::c_options& chosen = {}) {
  exporting::exporter each(name, [&] { return derive(of); }, chosen);
  return exporting::detail::write_c(each.run(), folder, chosen.number);
}

} // namespace kanexpr
