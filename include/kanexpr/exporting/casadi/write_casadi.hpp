#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/exporting/c/write_c.hpp>
#include <kanexpr/exporting/casadi/casadi_file.hpp>
#include <kanexpr/exporting/casadi/step_file.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

namespace exporting {

inline constexpr std::string_view casadi_helpers_template = template_text(
#include <kanexpr/exporting/casadi/helpers.c.in>
);

struct casadi_options {
  std::vector<bound_parameter> bound{}; ///< parameters that are exported as numbers
  std::string step = "runge_kutta_4";   ///< method of `name`_step, without corrections
};

namespace detail {

/// Returns the reason why CasADi would reject a function of this name; empty if it would accept it.
inline std::string mistake_of_casadi_name(const std::string& name) {
  identifiers known;
  known.reserve_words();
  known.reserve_words_of_mathematics();
  known.reserve(base::library_words::words_of_the_library);
  known.reserve("null jac hess");
  const bool has_two = (name + "_step").find("__") != name.npos;
  if (!name.empty() && name[0] != '_' && !has_two && known.unique(name) == name) return {};
  return "the name of a CasADi function must begin with a letter, must not contain two consecutive "
         "underscores or end with one, and must not be a reserved name in C, its library or CasADi; \"" +
         name + "\" is not a valid name";
}

inline bool depends_on_time(const exported_system& s) {
  for (const exported_function& f : s.functions)
    for (const lower::load& from : f.code.arguments)
      if (from.from == symbolic::symbol_kind::time) return true;
  return false;
}

inline std::string casadi_helpers(const std::string& library, int most) {
  return fill_template(casadi_helpers_template, {{"library", library}, {"most", std::to_string(most)}});
}

inline outcome write_casadi(runtime::staged_derivation& derivation, const std::filesystem::path& folder,
                            const std::string& name, const casadi_options& chosen) {
  for (const std::string& mistake : {mistake_of_casadi_name(name), mistake_of_method(chosen.step)})
    if (!mistake.empty()) return outcome(mistake);
  std::vector<casadi_argument> arguments, of_residual;
  options wanted{{casadi_kernels(false, arguments).column(), casadi_kernels(true, arguments).column()},
                 chosen.bound};
  const exported columns = exporter(name + "_casadi", derivation, wanted).run();
  if (!columns.mistake.empty()) return outcome(columns.mistake);
  const exported_system& s = columns.system;
  const int states = static_cast<int>(s.coordinates.size() + s.speeds.size());
  arguments = {{"x", symbols::state, states},
               {"r", symbols::inputs, static_cast<int>(s.inputs.size())},
               {"p", symbols::parameters, static_cast<int>(s.parameters.size())}};
  if (depends_on_time(s)) arguments.push_back({"t", symbols::time, 1});
  of_residual = arguments;
  of_residual.insert(of_residual.begin() + 1, {"xdot", symbols::rates, states});
  wanted.functions = casadi_kernels(false, arguments).all();
  for (const requested_function& each : casadi_kernels(true, of_residual).all())
    wanted.functions.push_back(each);
  exported all = exporter(name + "_casadi", derivation, wanted).run();
  if (!all.mistake.empty()) return outcome(all.mistake);
  if (const std::string mistake = mistake_of_numbers(all.system, precision::double_precision);
      !mistake.empty())
    return outcome(mistake);
  for (exported_function& f : all.system.functions)
    for (exported_function& other : all.system.functions)
      if (other.name == f.name + "_by_all") common_shapes::unify(f, other);
  const c_file file(all.system, precision::double_precision);
  int most = 1;
  for (const casadi_argument& each : arguments) most = (std::max)(most, each.size);
  return write_files(
      {{folder / (all.system.name + ".h"), file.header()},
       {folder / (all.system.name + ".c"),
        file.source() + casadi_helpers(name, most) + casadi_file(name, false, all.system, arguments).text() +
            casadi_file(name, true, all.system, of_residual).text() +
            casadi_step(name, *steps::find_tableau(chosen.step), all.system, arguments).text()}});
}

} // namespace detail

inline constexpr export_format casadi_format{
    .name = "casadi", .write = [](runtime::staged_derivation& derivation, const export_options& given) {
      return detail::write_casadi(derivation, given.folder, given.name, {.bound = given.bound});
    }};

} // namespace exporting

/// Writes the rates of a system's state for CasADi as a function `name`(x, r, p) with exact first and second
/// derivatives, in `folder`/`name`_casadi.c and .h, which a C compiler turns into a shared library. The state
/// x consists of the coordinates followed by the speeds; a system that depends on time takes it as the last
/// argument, t. The library also has a step, `name`_step(x, r, p, h), and the residual of the implicit form,
/// `name`_implicit(x, xdot, r, p), with the same kinds of derivatives. Reports the reason if this fails; no
/// file is left half-written.
template <class System>
outcome write_casadi(const std::filesystem::path& folder, const std::string& name,
                     const exporting::casadi_options& chosen = {}) {
  runtime::staged_derivation derivation([] { return derive<System>(); });
  return exporting::detail::write_casadi(derivation, folder, name, chosen);
}

/// The same for a system built by a builder.
inline outcome write_casadi(const runtime::builder& of, const std::filesystem::path& folder,
                            const std::string& name, const exporting::casadi_options& chosen = {}) {
  runtime::staged_derivation derivation([&] { return runtime::derive_in_own_graph(of); });
  return exporting::detail::write_casadi(derivation, folder, name, chosen);
}

} // namespace kanexpr
