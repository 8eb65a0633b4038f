#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/derivation/model_error.hpp>

#include <Eigen/Core>

#include <string_view>
#include <type_traits>

/// Checks the size of a vector against the size that a system requires.
namespace kanexpr::compiled {

constexpr base::sentence check_size(std::string_view what, std::string_view system, int given, int wanted) {
  if (given == Eigen::Dynamic || given == wanted) return {};
  base::name w, g;
  w.append(wanted), g.append(given);
  return base::sentence({"the ", what, " vector of ", system, " has ", w.view(),
                         wanted == 1 ? " entry, not " : " entries, not ", g.view()});
}

/// Placeholder for omitted arguments.
struct omitted {};

/// Returns the number of entries of an argument, if its type determines it.
template <class Argument>
constexpr int entries_of() {
  if constexpr (std::is_same_v<Argument, omitted>)
    return Eigen::Dynamic;
  else
    return Argument::SizeAtCompileTime;
}

/// Reports a vector of the wrong size.
template <class System, symbols_of which, int given>
struct size_check {
  static constexpr symbol_range wanted = range_of(which, survey_of<System>);
  static constexpr base::sentence mistake = [] {
    if (survey_of<System>.mistake) return base::sentence{};
    return check_size(wanted.vector, type_name<System>(), given, wanted.size);
  }();
  static_assert(derivation::report<size_check>());
  static constexpr bool possible =
      !static_cast<bool>(mistake) && !static_cast<bool>(survey_of<System>.mistake);
};

/// Reports a scalar type that cannot represent the values of a system.
template <class System, class Scalar>
constexpr base::sentence check_scalar() {
  if (!std::is_integral_v<Scalar> || survey_of<System>.mistake) return {};
  return base::sentence({"the values of ", type_name<System>(), " are real numbers, but ",
                         type_name<Scalar>(), " holds only integers; use double"});
}

template <class System, class Scalar>
struct scalar_check {
  static constexpr base::sentence mistake = check_scalar<System, Scalar>();
  static_assert(derivation::report<scalar_check>());
};

constexpr std::string_view name_of_vector(symbols_of which) {
  switch (which) {
  case symbols_of::parameters: return "parameters";
  case symbols_of::inputs: return "inputs";
  case symbols_of::state: break;
  }
  return "state";
}

/// Reports a vector passed in place of a different one, or one of a different system, even if the sizes
/// agree.
template <class System, symbols_of wanted, class Other, symbols_of given>
constexpr base::sentence check_vector_kind(std::string_view caller) {
  if (given == wanted && std::is_same_v<Other, System>) return {};
  if (survey_of<System>.mistake || survey_of<Other>.mistake) return {};
  return base::sentence({caller, type_name_beside<System, Other>(), " is given the ", name_of_vector(given),
                         " of ", type_name_beside<Other, System>(), " in place of its ",
                         name_of_vector(wanted)});
}

template <class System, symbols_of wanted, class Other, symbols_of given>
struct mismatched_vector {
  static constexpr base::sentence mistake = check_vector_kind<System, wanted, Other, given>({});
  static_assert(derivation::report<mismatched_vector>());
  static constexpr bool possible =
      !static_cast<bool>(mistake) && !static_cast<bool>(survey_of<System>.mistake);
};

} // namespace kanexpr::compiled
