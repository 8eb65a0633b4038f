#pragma once

#include <kanexpr/derive/derivation.hpp>

/// What can be asked of a linearization beside its quantities.
namespace kanexpr::derivation {

/// A quantity at rates of the speeds that the caller gives.
struct at_given_rates {
  quantity wanted;

  /// The function that gives it.
  constexpr std::string_view result_name() const {
    const bool in_states = wanted == quantity::state_matrix || wanted == quantity::input_matrix;
    return in_states ? "explicit_form_at" : "implicit_form_at";
  }
};

template <at_given_rates wanted>
struct request<wanted> {
  static constexpr extent of(const survey& s) { return request<wanted.wanted>::of(s); }
  static constexpr void visit(reader&) {}
  static constexpr symbolic::matrix form(reader&, mechanics::equations& e) {
    return e.at_given_rates(wanted.wanted);
  }
};

/// How expressions of the model answer to changes of the state, or of the inputs.
template <bool to_inputs, auto... outputs>
struct sensitivity {
  constexpr std::string_view result_name() const { return "outputs"; }
};

template <bool to_inputs, auto... outputs, sensitivity<to_inputs, outputs...> wanted>
struct request<wanted> {
  static constexpr int rows = (0 + ... + request<outputs>::of({}).rows);
  static constexpr extent of(const survey& s) { return {rows, to_inputs ? s.inputs : s.states()}; }
  static constexpr void visit(reader& r) { (request<outputs>::visit(r), ...); }
  static constexpr symbolic::matrix form(reader& r, mechanics::equations& e) {
    sequence<expression> all;
    (collect(all, request<outputs>::with_rates(r, e)), ...);
    const mechanics::explicit_linearization l = e.linearized().outputs(all);
    return e.in_motion(to_inputs ? l.input : l.state);
  }

private:
  static constexpr void collect(sequence<expression>& all, const symbolic::matrix& more) {
    for (const expression& each : more.entries) all.push(each);
  }
};

} // namespace kanexpr::derivation
