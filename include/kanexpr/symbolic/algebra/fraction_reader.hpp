#pragma once

#include <kanexpr/symbolic/algebra/expression_reader.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/polynomials/polynomial_fraction.hpp>

namespace kanexpr::symbolic::algebra {

/// Reads expressions as fractions of polynomials. In addition to `has_minus` and `written`, a form provides
/// `known_function(op, fraction)`, which returns a numerator and a denominator for functions that it can
/// express, and `on_opaque_function(node)`, which is called for every function treated as a symbol.
template <class Coefficient, class Form>
class fraction_reader : public expression_reader<polynomials::fraction<Coefficient>, Form> {
public:
  using fraction = polynomials::fraction<Coefficient>;

  fraction_reader(graph& g, budget& left) : expression_reader<fraction, Form>(g, left), arithmetic_(left) {}

  static std::size_t size(const fraction& a) { return a.numerator.size(); }
  fraction negative(const fraction& a) { return arithmetic_.negative(a); }
  fraction sum(const fraction& a, const fraction& b) { return arithmetic_.sum(a, b); }
  fraction product(const fraction& a, const fraction& b) { return arithmetic_.product(a, b); }
  fraction quotient(const fraction& a, const fraction& b) {
    if (!b.numerator.is_zero()) return arithmetic_.quotient(a, b);
    this->left().fail("it divides by an expression that is zero everywhere");
    return {};
  }
  fraction atomic(int id) {
    const polynomial<Coefficient> p = atom<Coefficient>({this->owner(), id});
    if (this->owner()[id].op != operation::symbol && !p.is_constant()) form().on_opaque_function(id);
    return {p, {}};
  }
  fraction function(operation op, const fraction& a, const fraction& b) {
    if (const auto known = form().known_function(op, a))
      return quotient({known->first, {}}, {known->second, {}});
    const unsigned_argument x = this->argument(a), y = this->argument(b);
    const polynomial<Coefficient> f = function_of<Coefficient>(op, x, y);
    if (f.is_constant()) return {f, {}};
    const int base = f.terms.front().factors.front().base;
    form().on_opaque_function(base);
    if (op == operation::sqrt) arithmetic_.set_square(base, a);
    return {f, {}};
  }

protected:
  const polynomial<Coefficient>& divisor(std::size_t place) const { return arithmetic_.divisor(place); }

private:
  Form& form() { return static_cast<Form&>(*this); }

  polynomials::fraction_arithmetic<Coefficient> arithmetic_;
};

} // namespace kanexpr::symbolic::algebra
