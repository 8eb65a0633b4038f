#pragma once

#include <kanexpr/derivation/request.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <string_view>

/// Requests for linearized results that are not quantities.
namespace kanexpr::derivation {

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

} // namespace kanexpr::derivation
