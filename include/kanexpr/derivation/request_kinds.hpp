#pragma once

#include <kanexpr/derivation/request.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <string_view>

/// Requests for results that are not quantities.
namespace kanexpr::derivation {

/// The derivatives of a result, row by row in the order of its entries, with respect to the state [q; u], the
/// inputs, or the rates of the speeds if the result contains them.
struct derivatives_of_result {
  quantity of;
  with_respect_to symbols;

  constexpr std::string_view result_name() const { return mechanics::row_of(of).called; }
};

template <derivatives_of_result wanted>
struct requested<wanted> {
  static constexpr request value{
      .what = request::kind::derivatives, .wanted = wanted.of, .symbols = wanted.symbols};
};

/// A quantity evaluated at rates of the speeds that are passed by the caller.
struct at_given_rates {
  quantity wanted;

  /// The name of the function that returns it.
  constexpr std::string_view result_name() const {
    const bool in_states = wanted == quantity::state_matrix || wanted == quantity::input_matrix;
    return in_states ? "explicit_form_at" : "implicit_form_at";
  }
};

template <at_given_rates wanted>
struct requested<wanted> {
  static constexpr request value{
      .what = request::kind::result, .wanted = wanted.wanted, .is_at_given_rates = true};
};

/// The sensitivity of expressions of the model to the state or to the inputs.
template <bool to_inputs, auto... outputs>
struct sensitivity {
  constexpr std::string_view result_name() const { return "outputs"; }
};

template <bool to_inputs, auto... outputs, sensitivity<to_inputs, outputs...> wanted>
struct requested<wanted> {
  static constexpr phrase words[]{requested<outputs>::value.phrases[0]...};
  static constexpr request value{
      .what = request::kind::sensitivity, .phrases = words, .is_to_inputs = to_inputs};
};

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
