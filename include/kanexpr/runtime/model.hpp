#pragma once

#include <kanexpr/derivation/derivation.hpp>
#include <kanexpr/mechanics/print_vector.hpp>
#include <kanexpr/runtime/interpreted.hpp>
#include <kanexpr/symbolic/latex.hpp>
#include <kanexpr/symbolic/print.hpp>

#include <string>

namespace kanexpr {

/// A system derived while the program runs, by the functions that derive it in the compiler: its results are
/// expressions, to print, to look into and to evaluate. It stays where it was made.
///
/// `also` are expressions with points and frames that the system itself does not use.
template <class System, auto... also>
class model {
public:
  model() : mechanism_(graph_), reader_(System::record, mechanism_), derived_(read()) {
    reader_.know(derived_);
  }
  model(const model&) = delete;
  model& operator=(const model&) = delete;

  /// The first mistake of the system as a sentence; empty: there is none.
  std::string mistake() const {
    const mechanics::problem& found = reader_.mistake() ? reader_.mistake() : derived_.mistake();
    return std::string(found.view());
  }

  /// A result as a matrix of expressions.
  symbolic::matrix get(mechanics::quantity wanted) { return derived_.get(wanted); }
  symbolic::matrix mass_matrix() { return get(mechanics::quantity::mass_matrix); }
  symbolic::matrix forcing() { return get(mechanics::quantity::forcing); }
  symbolic::matrix qdot() { return get(mechanics::quantity::qdot); }
  symbolic::matrix udot() { return get(mechanics::quantity::udot); }
  symbolic::matrix rhs() { return get(mechanics::quantity::rhs); }

  /// An expression of the model: `model.get<magnitude(velocity_of<P>)>()`; of a vector, its components.
  template <auto wanted>
  symbolic::matrix get() {
    return derivation::request<wanted>::form(reader_, derived_);
  }

  /// A vector of the model as a sum over its frames.
  template <auto wanted>
  mechanics::vector vector() {
    return reader_.evaluate(describe::phrase_of<wanted>, "an expression").vector;
  }

  std::string print(const mechanics::vector& v,
                    mechanics::basis_style style = mechanics::basis_style::xyz) const {
    return mechanics::print(mechanism_, v, style);
  }
  std::string latex(const mechanics::vector& v,
                    mechanics::basis_style style = mechanics::basis_style::xyz) const {
    return mechanics::latex(mechanism_, v, style);
  }

  /// Interpreted evaluation of a result: the steps of the compiled function, so it agrees with that to the
  /// last bit.
  template <class Scalar = double>
  runtime::interpreted<Scalar> function(const symbolic::matrix& result) const {
    return {graph_, result, mechanism_.coordinates.size()};
  }

  symbolic::graph& graph() { return graph_; }
  const mechanics::mechanism& mechanism() const { return mechanism_; }
  mechanics::equations& equations() { return derived_; }

private:
  const mechanics::mechanism& read() {
    reader_.read();
    (derivation::request<also>::visit(reader_), ...);
    return mechanism_;
  }

  symbolic::graph graph_;
  mechanics::mechanism mechanism_;
  derivation::reader reader_;
  mechanics::equations derived_;
};

/// Derives a system while the program runs.
template <class System, auto... also>
model<System, also...> derive() {
  return model<System, also...>();
}

} // namespace kanexpr
