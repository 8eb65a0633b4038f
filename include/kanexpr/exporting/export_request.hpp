#pragma once

#include <kanexpr/derivation/request.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/steps/tableaux.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The specification of the functions to export.
namespace kanexpr::exporting {

/// The symbols with respect to which a result is differentiated; `rates` denotes the rates of the state,
/// `parameters` the parameters that are not bound.
enum class symbols : unsigned char { state, rates, inputs, parameters, time };

/// A derivative of a column y with respect to symbols z.
struct requested_derivative {
  enum class kind : unsigned char {
    none,                 ///< y itself
    jacobian,             ///< ∂y/∂z for z in `by`
    directional,          ///< (∂y/∂z) w for a direction w
    directional_jacobian, ///< ∂((∂y/∂z) w)/∂z' for z' in `by`
    weighted,             ///< ∂(wᵀy)/∂z for weights w and z in `by`
    weighted_jacobian     ///< ∂²(wᵀy)/∂z∂z' for z in `by` and z' in `and_by`
  };
  kind type = kind::none;
  std::vector<symbols> along{}; ///< the symbols for which the direction has entries
  symbols by{}, and_by{};
};

struct requested_result {
  std::string name{};
  derivation::request request{};
  symbolic::expression written{}; ///< an expression of a builder, in place of the request
  bool is_residual = false;       ///< the residual of the implicit form, in place of the request
  requested_derivative derivative{};
  std::vector<symbols> part{}; ///< symbols of the rows and the columns of a second-order result
  bool is_sparse = false;      ///< omits the entries that are identically zero
};

/// A step of fixed length, like that of `runge_kutta_4<System, corrections>`.
struct requested_step {
  std::string method = "runge_kutta_4"; ///< name of the method; empty: only corrects the state
  int corrections = 1;
};

/// A function to export, with the results of one call.
struct requested_function {
  std::string name{};
  std::vector<requested_result> results{};
  std::optional<requested_step> step{}; ///< replaces the results
  std::string mistake{};
  std::vector<symbols> derivatives{}; ///< replace the results by the derivatives of all of their entries
};

namespace detail {

/// Names of the parts of linearizations, which are requested as a whole.
inline constexpr std::string_view parts_of_linearizations[]{"A", "B", "by_state", "by_inputs", "M", "A", "B"};

inline std::string_view name_of(mechanics::quantity of) {
  if (!mechanics::is_of_linearization(of)) return mechanics::row_of(of).called;
  return parts_of_linearizations[static_cast<int>(of) - static_cast<int>(mechanics::quantity::state_matrix)];
}

/// "mass_matrix, forcing or udot".
inline std::string alternatives(const std::vector<std::string_view>& names) {
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i)
    all.append(i == 0 ? "" : i + 1 == names.size() ? " or " : ", ").append(names[i]);
  return all;
}

} // namespace detail

/// "runge_kutta_4, ralston_3 or semi_implicit_euler".
inline std::string names_of_steps() {
  std::vector<std::string_view> names;
  names.reserve(steps::tableaux.size());
  for (const steps::tableau* each : steps::tableaux) names.emplace_back(each->name);
  return detail::alternatives(names);
}

/// "mass_matrix, forcing, … or jacobian": the results that exported functions can return.
inline std::string names_of_results() {
  std::vector<std::string_view> names;
  for (const mechanics::result_row& row : mechanics::results)
    if (!row.takes_weights && !row.takes_direction && (names.empty() || names.back() != row.called))
      names.push_back(row.called);
  return detail::alternatives(names);
}

/// The mistake in a result that does not exist.
inline std::string mistake_of_result(std::string_view name) {
  std::string mistake = "there is no result ";
  mistake.append(name).append("; ");
  for (const std::string_view linear : {"A", "B", "state_matrix", "input_matrix", "linearization"})
    if (name == linear) return mistake.append("A and B are explicit_form; M, A and B are implicit_form");
  mistake.append("expected ").append(names_of_results());
  return mistake.append(", or a step, ").append(names_of_steps());
}

/// Returns the reason why there is no such method; empty if there is one.
inline std::string mistake_of_method(const std::string& name) {
  if (steps::find_tableau(name) != nullptr) return {};
  return "unknown step method " + name + "; expected " + names_of_steps();
}

/// A step of a given method, exported under a given name: `fixed_step("step", {"runge_kutta_4", 2})`.
inline requested_function fixed_step(std::string name, const requested_step& how) {
  requested_function wanted{.name = std::move(name), .step = how};
  if (!how.method.empty()) wanted.mistake = mistake_of_method(how.method);
  if (how.corrections < 0) wanted.mistake = "the number of corrections of a step must be at least 0";
  return wanted;
}

/// A function that returns the named results, whose names are separated by spaces: "udot", "mass_matrix
/// forcing", or one of the steps, such as "runge_kutta_4".
inline requested_function results(std::string_view names) {
  if (steps::find_tableau(names) != nullptr) return fixed_step(std::string(names), {std::string(names)});
  requested_function wanted;
  while (!names.empty()) {
    const std::size_t end = (std::min)(names.find(' '), names.size());
    const std::string_view name = names.substr(0, end);
    names.remove_prefix((std::min)(end + 1, names.size()));
    if (name.empty()) continue;
    const std::size_t before = wanted.results.size();
    for (const mechanics::result_row& row : mechanics::results)
      if (row.called == name)
        wanted.results.push_back({std::string(detail::name_of(row.is)),
                                  {.what = derivation::request::kind::result, .wanted = row.is}});
    if (wanted.results.size() == before)
      wanted.mistake =
          steps::find_tableau(name) != nullptr
              ? std::string(name) + " is a separate function and cannot be combined with other results"
              : mistake_of_result(name);
    wanted.name.append(wanted.name.empty() ? "" : "_and_").append(name);
  }
  if (wanted.results.empty() && wanted.mistake.empty())
    wanted.mistake = "a function must have at least one result";
  return wanted;
}

/// An expression of the model, exported under a given name: `expression<position_of<P>>("tip")`.
template <auto wanted, class Where = describe::file_of<wanted>>
requested_function expression(std::string name) {
  requested_function one;
  one.name = name;
  one.results.push_back({std::move(name), derivation::requested<wanted>::value});
  return one;
}

/// The same for an expression of a builder.
inline requested_function expression(std::string name, symbolic::expression written) {
  requested_function one;
  one.name = name;
  one.results.push_back({std::move(name), {}, written});
  return one;
}

/// The functions exported by default: M and f, u̇, ẋ, and A and B.
inline std::vector<requested_function> default_results() {
  return {results("mass_matrix forcing"), results("udot"), results("rhs"), results("explicit_form")};
}

} // namespace kanexpr::exporting
