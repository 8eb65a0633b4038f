#pragma once

#include <kanexpr/export/casadi/casadi_file.hpp>
#include <kanexpr/export/write_c.hpp>

namespace kanexpr {

namespace exporting {

struct casadi_options {
  std::vector<bound_parameter> bound{}; ///< are numbers in what is exported
};

namespace detail {

/// Why CasADi would not take a function of this name, or nothing.
inline std::string mistake_of_casadi_name(const std::string& name) {
  identifiers known;
  known.reserve_words();
  known.reserve_words_of_mathematics();
  for (const char* own : {"null", "jac", "hess"}) known.reserve(own);
  if (!name.empty() && name[0] != '_' && name.find("__") == name.npos && known.of(name) == name) return {};
  return "a function of CasADi needs a name that begins with a letter, has no two underscores in a row and "
         "is "
         "none of C's or CasADi's words; \"" +
         name + "\" is none";
}

inline bool holds_time(const exported_function& f) {
  return std::any_of(f.code.arguments.begin(), f.code.arguments.end(),
                     [](const lower::load& l) { return l.from == symbolic::symbol_kind::time; });
}

inline outcome write_casadi(const std::function<model()>& derive, const std::filesystem::path& folder,
                            const std::string& name, const casadi_options& chosen) {
  if (const std::string mistake = mistake_of_casadi_name(name); !mistake.empty()) return outcome(mistake);
  options wanted{{casadi_kernels::rates()}, chosen.bound};
  const exported rates = exporter(name + "_casadi", derive, wanted).run();
  if (!rates.mistake.empty()) return outcome(rates.mistake);
  const exported_system& s = rates.system;
  std::vector<casadi_argument> arguments{
      {"x", symbols::state, static_cast<int>(s.coordinates.size() + s.speeds.size())},
      {"r", symbols::inputs, static_cast<int>(s.inputs.size())},
      {"p", symbols::parameters, static_cast<int>(s.parameters.size())}};
  if (holds_time(s.functions[0])) arguments.push_back({"t", symbols::time, 1});
  wanted.functions = casadi_kernels(arguments).all();
  const exported all = exporter(name + "_casadi", derive, wanted).run();
  if (!all.mistake.empty()) return outcome(all.mistake);
  if (const std::string mistake = mistake_of_numbers(all.system, precision::double_precision);
      !mistake.empty())
    return outcome(mistake);
  const c_file file(all.system, precision::double_precision);
  return write_files(
      {{folder / (all.system.name + ".h"), file.header()},
       {folder / (all.system.name + ".c"), file.source() + casadi_file(name, all.system, arguments).text()}});
}

} // namespace detail

} // namespace exporting

/// Writes the rates of a system's state for CasADi, a function `name`(x, r, p) with exact first and second
/// derivatives: `folder`/`name`_casadi.c and .h, which a compiler of C makes a shared library of. States are
/// the coordinates and then the speeds; a system that changes with time takes it as a fourth argument, t.
/// Says why not where it cannot; nothing is left half-written.
template <class System>
outcome write_casadi(const std::filesystem::path& folder, const std::string& name,
                     const exporting::casadi_options& chosen = {}) {
  return exporting::detail::write_casadi([] { return derive<System>(); }, folder, name, chosen);
}

/// The same of what a builder built.
inline outcome write_casadi(const runtime::builder& of, const std::filesystem::path& folder,
                            const std::string& name, const exporting::casadi_options& chosen = {}) {
  return exporting::detail::write_casadi([&] { return runtime::derive_in_own_graph(of); }, folder, name, chosen);
}

} // namespace kanexpr
