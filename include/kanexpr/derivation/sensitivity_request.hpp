#pragma once

#include <kanexpr/derivation/request.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// The sensitivity of the rates of the state to the given parameters.
template <auto... parameters>
struct sensitivity_to {
  constexpr std::string_view result_name() const { return "sensitivity"; }
};

/// Returns the phrase of an expression, or an empty phrase, which is rejected later.
template <auto wanted>
constexpr phrase phrase_or_none() {
  if constexpr (requires { describe::shape_of(wanted); })
    return describe::phrase_of<wanted>;
  else
    return {};
}

template <auto... parameters, sensitivity_to<parameters...> wanted>
struct requested<wanted> {
  static constexpr phrase words[]{phrase_or_none<parameters>()...};
  static constexpr request value{
      .what = request::kind::parameters, .phrases = words, .whom = "a sensitivity"};
};

} // namespace kanexpr::derivation
