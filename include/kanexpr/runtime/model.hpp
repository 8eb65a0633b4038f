#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/check_words.hpp>
#include <kanexpr/derivation/entity_digests.hpp>
#include <kanexpr/derivation/request_kinds.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/print_vector.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/derived.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/runtime/linearization.hpp>
#include <kanexpr/runtime/linearization_point.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

namespace derivation {
struct survey;
}
namespace runtime {
class staged_derivation;
}

/// A system derived at run time by the same functions as at compile time. Its results are expressions to
/// print, inspect and evaluate. Copies share one derivation, which exists as long as any of the copies or
/// their linearizations; only one thread at a time may use it.
class model {
public:
  /// `extra_requests` are expressions that contain points and frames not used by the system itself.
  /// `expected_digests` are the digests of the entities in the file that refers to the system.
  explicit model(const derivation::checked_words& from,
                 std::span<const derivation::request> extra_requests = {},
                 std::span<const std::uint64_t> expected_digests = {});
  explicit model(std::shared_ptr<runtime::derived> system) : system_(std::move(system)) {}

  /// The first mistake in the system as a sentence, or the mistake in the last requested result; empty if
  /// there is none.
  std::string mistake() const;

  /// The coordinates or speeds for which the constraints are solved, chosen by the model or by the library:
  /// "q4", "u1, u4 and u6".
  std::string names_of_dependent_coordinates();
  std::string names_of_dependent_speeds();

  /// The inertial parameters to which the columns of the regressor belong, body by body: "m of Link", "m*x of
  /// Link", … "izx of Link".
  std::vector<std::string> names_of_inertial_parameters() const;

  /// A result as a matrix of expressions; empty if the system has a mistake.
  symbolic::matrix get(mechanics::quantity wanted);
  // the steps of Kane's method
  symbolic::matrix qdot() { return get(mechanics::quantity::qdot); }
  symbolic::matrix configuration_residual() { return get(mechanics::quantity::configuration_residual); }
  symbolic::matrix velocity_residual() { return get(mechanics::quantity::velocity_residual); }
  symbolic::matrix constraint_jacobian() { return get(mechanics::quantity::constraint_jacobian); }
  symbolic::matrix dependent_speeds() { return get(mechanics::quantity::dependent_speeds); }
  symbolic::matrix dependency() { return get(mechanics::quantity::dependency); }
  symbolic::matrix acceleration_bias() { return get(mechanics::quantity::acceleration_bias); }
  symbolic::matrix active_forces() { return get(mechanics::quantity::active_forces); }
  symbolic::matrix inertia_forces() { return get(mechanics::quantity::inertia_forces); }
  symbolic::matrix mass_matrix() { return get(mechanics::quantity::mass_matrix); }
  symbolic::matrix forcing() { return get(mechanics::quantity::forcing); }
  symbolic::matrix udot() { return get(mechanics::quantity::udot); }
  symbolic::matrix rhs() { return get(mechanics::quantity::rhs); }
  symbolic::matrix multipliers() { return get(mechanics::quantity::multipliers); }
  symbolic::matrix noncontributing_forces() { return get(mechanics::quantity::noncontributing_forces); }
  /// Another name for `noncontributing_forces`.
  symbolic::matrix auxiliary_forces() { return noncontributing_forces(); }

  /// The derivatives of [q̇; u̇] with respect to parameters, one column per parameter: `model.sensitivity<m,
  /// l>()`.
  template <auto... parameters>
  symbolic::matrix sensitivity() {
    return get(derivation::requested<derivation::sensitivity_to<parameters...>{}>::value);
  }

  /// Linearizes the system about an operating point, merged from up to three sets of values:
  /// `model.linearize(upright, {{u3, 2}})`. Symbols without a value are kept.
  runtime::linearization linearize(const linearization_point& at = {}, const linearization_point& second = {},
                                   const linearization_point& third = {});

  /// An expression of the model in which rates remain symbols, for `linearization::outputs`.
  template <auto... measured, class Where = describe::file_of<measured...>>
  symbolic::matrix measured_by() {
    const derivation::request all[]{derivation::requested<measured>::value...};
    return measured_by(all);
  }
  symbolic::matrix measured_by(std::span<const derivation::request> measured);

  /// Replaces the rates q̇ and u̇ in an expression by those of the equations of motion; leaves it unchanged
  /// if the system has a mistake.
  symbolic::expression in_motion(symbolic::expression e);

  /// Replaces the dependent speeds in a vector or scalar by their values from the constraints; leaves it
  /// unchanged if the system has a mistake.
  symbolic::expression imposed(symbolic::expression e);
  mechanics::vector imposed(const mechanics::vector& v);

  /// An expression of the model: `model.get<magnitude(velocity_of<P>)>()`; for a vector, its components.
  template <auto wanted, class Where = describe::file_of<wanted>>
  symbolic::matrix get() {
    return get(derivation::requested<wanted>::value);
  }
  symbolic::matrix get(const derivation::request& wanted);
  /// The same as compiled functions evaluate it: a linear system with many columns is one node, which cannot
  /// be differentiated or printed.
  symbolic::matrix get_for_code(const derivation::request& wanted);

  /// A vector of the model as a sum over its frames.
  template <auto wanted, class Where = describe::file_of<wanted>>
  mechanics::vector vector() {
    return vector(describe::phrase_of<wanted>);
  }
  mechanics::vector vector(const describe::phrase& words);

  std::string print(const mechanics::vector& v, mechanics::basis_style style = mechanics::basis_style::xyz,
                    std::size_t longest = symbolic::longest_text) const;
  std::string latex(const mechanics::vector& v, mechanics::basis_style style = mechanics::basis_style::xyz,
                    std::size_t longest = symbolic::longest_text) const;

  /// Returns a function that interprets a result with the same steps as the compiled function. The first
  /// requested result agrees with the compiled one to the last bit, except that a zero may have another sign
  /// where `get` writes out a linear system with many columns. Later results share expressions with earlier
  /// ones, which may change the order of operations and thus the last bits. If the model has a mistake, or
  /// the result was rejected or belongs to a different model, the function has no values, and its status
  /// reports the cause.
  template <class Scalar = double>
  runtime::interpreted<Scalar> function(const symbolic::matrix& result) {
    if (const base::sentence wrong = mistake_of(result))
      return {graph(), owns(result) ? result : symbolic::matrix(), coordinates(), {}, wrong};
    return {
        graph(), result, coordinates(), singularity_checks_of(result), {}, system_->is_linearization(result)};
  }
  /// Whether all entries are expressions of this model.
  bool owns(const symbolic::matrix& result) const;

  /// The unit of an expression of a builder, or of an expression of the types of a model (for a vector, of
  /// its components): `model.unit_of<velocity_of<P>>()`.
  mechanics::possible_unit unit_of(const symbolic::expression& e) const;
  mechanics::possible_unit unit_of(const describe::phrase& p) const;
  template <auto wanted, class Where = describe::file_of<wanted>>
  mechanics::possible_unit unit_of() const {
    return unit_of(describe::phrase_of<wanted>);
  }

  /// The symbols of the model in order, and which of them are dependent.
  std::shared_ptr<const derivation::survey> known() const;

  /// The units of the symbols and constraints of the system: `model.units().of("c")`. They are inferred by
  /// each call.
  mechanics::unit_table units() const { return system_->units(); }
  /// The unit of an entry of a result; nothing if it is not determined.
  mechanics::possible_unit unit_of(mechanics::quantity wanted, int row = 0, int column = 0) const;

  symbolic::graph& graph() { return system_->graph(); }
  const mechanics::mechanism& mechanism() const { return system_->system().mechanism; }
  const mechanics::multibody_system& system() const { return system_->system(); }
  /// Requires a model without mistakes.
  mechanics::equations& equations() { return *system_->equations(); }

private:
  friend runtime::staged_derivation;

  int coordinates() const;
  /// The reason why a result has no values; empty if it has values.
  base::sentence mistake_of(const symbolic::matrix& result) const;
  /// The checks that detect singularities in the computation of a result.
  base::sequence<mechanics::singularity_check> singularity_checks_of(const symbolic::matrix& result);

  std::shared_ptr<runtime::derived> system_; ///< shared with its linearizations
};

/// Derives a system at run time.
template <class System, auto... extra_requests,
          std::uint64_t described = derivation::compile_time_digests<System>[0]>
model derive() {
  const std::span<const std::uint64_t> expected_digests(derivation::linked_digests<System, described>);
  if constexpr (sizeof...(extra_requests) == 0) {
    return model(derivation::words_of<System>, {}, expected_digests.subspan(1));
  } else {
    const derivation::request all[]{derivation::requested<extra_requests>::value...};
    return model(derivation::words_of<System>, all, expected_digests.subspan(1));
  }
}

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/model.ipp>
#endif
