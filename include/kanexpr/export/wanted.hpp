#pragma once

#include <kanexpr/derive/request.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What is to be exported.
namespace kanexpr::exporting {

struct wanted_result {
  std::string name{};
  deriving::request request{};
  symbolic::expression written{}; ///< in its place, of what a builder builds
};

/// What the results of a function may be differentiated by.
enum class differentiated_by : unsigned char { states, inputs, time };

/// The results of one call.
struct wanted_function {
  std::string name{};
  std::vector<wanted_result> results{};
  std::string mistake{};
  std::vector<differentiated_by> derivatives{}; ///< of all entries of the results, in their place
};

namespace detail {

/// The parts of a linearization are asked for as a whole.
inline constexpr std::string_view parts_of_linearizations[]{"A", "B", "by_state", "by_inputs", "M", "A", "B"};

inline std::string_view name_of(mechanics::quantity of) {
  if (!mechanics::is_of_linearization(of)) return mechanics::row_of(of).called;
  return parts_of_linearizations[static_cast<int>(of) - static_cast<int>(mechanics::quantity::state_matrix)];
}

} // namespace detail

/// Results by their names, with spaces between them, for one call: "udot", "mass_matrix forcing".
inline wanted_function results(std::string_view names) {
  wanted_function wanted;
  while (!names.empty()) {
    const std::size_t end = (std::min)(names.find(' '), names.size());
    const std::string_view name = names.substr(0, end);
    names.remove_prefix((std::min)(end + 1, names.size()));
    if (name.empty()) continue;
    const std::size_t before = wanted.results.size();
    for (const mechanics::result_row& row : mechanics::results)
      if (row.called == name)
        wanted.results.push_back({std::string(detail::name_of(row.is)),
                                  {.what = deriving::request::kind::result, .wanted = row.is}});
    if (wanted.results.size() == before) wanted.mistake = "no result is called " + std::string(name);
    wanted.name.append(wanted.name.empty() ? "" : "_and_").append(name);
  }
  if (wanted.results.empty() && wanted.mistake.empty()) wanted.mistake = "a function without a result";
  return wanted;
}

/// An expression of the model, by a name of its own: `expression<position_of<P>>("tip")`.
template <auto wanted>
wanted_function expression(std::string name) {
  wanted_function one;
  one.name = name;
  one.results.push_back({std::move(name), deriving::requested<wanted>::value});
  return one;
}

/// The same of what a builder builds.
inline wanted_function expression(std::string name, symbolic::expression written) {
  wanted_function one;
  one.name = name;
  one.results.push_back({std::move(name), {}, written});
  return one;
}

/// What is exported where nothing is said: M and f, u̇, ẋ, and A and B.
inline std::vector<wanted_function> default_results() {
  return {results("mass_matrix forcing"), results("udot"), results("rhs"), results("explicit_form")};
}

} // namespace kanexpr::exporting
