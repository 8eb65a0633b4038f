#pragma once

#include <kanexpr/derive/linearization_request.hpp>
#include <kanexpr/derive/stages.hpp>
#include <kanexpr/mechanics/model/print_vector.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/runtime/linearization.hpp>
#include <kanexpr/runtime/point_reader.hpp>
#include <kanexpr/symbolic/print/latex.hpp>
#include <kanexpr/symbolic/print/print.hpp>

#include <memory>
#include <string>

namespace kanexpr {

/// A system derived while the program runs, by the functions that derive it in the compiler: its results are
/// expressions, to print, to look into and to evaluate. It stays where it was made.
///
/// `also` are expressions with points and frames that the system itself does not use.
template <class System, auto... also>
class model {
public:
  model() : system_(std::make_shared<derivation::derived_system>(System::record)) {
    (derivation::visit(derivation::requested<also>::value, system_->reader()), ...);
    go_on(*system_, derivation::stage::constrained);
  }
  model(const model&) = delete;
  model& operator=(const model&) = delete;

  /// The first mistake of the system as a sentence; empty: there is none.
  std::string mistake() const { return std::string(system_->mistake().view()); }

  /// What the constraints are solved for, by the choice of the model or of the library: "q4", "u1, u4 and
  /// u6".
  std::string names_of_dependent_coordinates() {
    return enumerated(mechanism().coordinates, &mechanics::equations::coordinates);
  }
  std::string names_of_dependent_speeds() {
    return enumerated(mechanism().speeds, &mechanics::equations::speeds);
  }

  /// A result as a matrix of expressions; without entries where the system has a mistake.
  symbolic::matrix get(mechanics::quantity wanted) {
    if (system_->mistake()) return {};
    return system_->equations().get(wanted);
  }
  // the steps of Kane's method, in its words
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
  symbolic::matrix auxiliary_forces() { return get(mechanics::quantity::auxiliary_forces); }

  /// The system linearized about an operating point, in up to three sets of values that are merged:
  /// `model.linearize(upright, {{u3, 2}})`. Without one all symbols stay.
  runtime::linearization linearize(const linearization_point& at = {}, const linearization_point& second = {},
                                   const linearization_point& third = {}) {
    runtime::point_reader reader(*system_);
    const std::vector<symbolic::replacement> values = reader.read(at.with(second).with(third));
    return {system_, values, reader.problems()};
  }

  /// An expression of the model with the symbols of all rates, for `linearization::outputs`.
  template <auto... measured>
  symbolic::matrix measured_by() {
    symbolic::matrix all(graph(), 0, 1);
    const auto add = [&](const symbolic::matrix& m) {
      for (const symbolic::expression& e : m.entries) all.entries.push(e);
    };
    (add(form_with_rates(derivation::requested<measured>::value, system_->reader(), system_->equations())),
     ...);
    all.rows = all.entries.size();
    return all;
  }

  /// A vector or scalar with the dependent speeds as the constraints give them.
  symbolic::expression imposed(symbolic::expression e) { return equations().imposed(e); }
  mechanics::vector imposed(const mechanics::vector& v) {
    mechanics::vector out;
    for (const mechanics::vector::part& p : v.parts)
      out.add(p.frame, {imposed(p.value.x), imposed(p.value.y), imposed(p.value.z)});
    return out;
  }

  /// An expression of the model: `model.get<magnitude(velocity_of<P>)>()`; of a vector, its components.
  template <auto wanted>
  symbolic::matrix get() {
    if (system_->mistake()) return {};
    return form(derivation::requested<wanted>::value, system_->reader(), system_->equations());
  }

  /// A vector of the model as a sum over its frames.
  template <auto wanted>
  mechanics::vector vector() {
    return system_->reader().evaluate(describe::phrase_of<wanted>, "an expression").vector;
  }

  std::string print(const mechanics::vector& v,
                    mechanics::basis_style style = mechanics::basis_style::xyz) const {
    return mechanics::print(mechanism(), v, style);
  }
  std::string latex(const mechanics::vector& v,
                    mechanics::basis_style style = mechanics::basis_style::xyz) const {
    return mechanics::latex(mechanism(), v, style);
  }

  /// Interpreted evaluation of a result: the steps of the compiled function, so it agrees with that to the
  /// last bit.
  template <class Scalar = double>
  runtime::interpreted<Scalar> function(const symbolic::matrix& result) {
    symbolic::sequence<int> outputs;
    for (const symbolic::expression& e : result.entries) outputs.push(e.node());
    symbolic::sequence<mechanics::guard> guards;
    if (system_->is_derived()) guards = system_->equations().guards_of(outputs);
    return {graph(), result, mechanism().coordinates.size(), guards};
  }

  symbolic::graph& graph() { return system_->graph(); }
  const mechanics::mechanism& mechanism() const { return system_->model(); }
  mechanics::equations& equations() { return system_->equations(); }

private:
  std::string enumerated(const symbolic::sequence<symbolic::expression>& symbols,
                         const mechanics::partition& (mechanics::equations::*which)() const) {
    if (system_->mistake()) return {};
    return std::string(mechanics::enumerated(mechanism(), symbols, (equations().*which)().dependent).view());
  }

  std::shared_ptr<derivation::derived_system> system_; ///< shared with its linearizations
};

/// Derives a system while the program runs.
template <class System, auto... also>
model<System, also...> derive() {
  return model<System, also...>();
}

} // namespace kanexpr
