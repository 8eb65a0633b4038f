#pragma once

#include <kanexpr/symbolic/algebra/bottom_up.hpp>
#include <kanexpr/symbolic/algebra/sum_of_terms.hpp>
#include <kanexpr/symbolic/polynomials/polynomial_fraction.hpp>

namespace kanexpr::symbolic::algebra {

/// Reads expressions as fractions of polynomials. A form provides `written(fraction)`, an expression;
/// `argument(fraction)`, a function argument with its sign split off; `function(op, fraction)`, which returns
/// a numerator and a denominator for functions that it can express; and `meets_opaque(node)`, which is called
/// for every function treated as a symbol.
template <class Coefficient, class Form>
class fraction_reader {
public:
  using fraction = algebra::fraction<Coefficient>;

  fraction_reader(graph& g, budget& left) : g_(g), left_(left), arithmetic_(left) {}

  /// Returns nothing if the budget is exceeded.
  std::vector<fraction> read(const sequence<int>& outputs) {
    const auto size_of = [](const fraction& f) { return f.above.size(); };
    return bottom_up<fraction>(
        g_, without_small_solves(g_, outputs), left_, size_of,
        [this](int id, const fraction& a, const fraction& b) { return value(id, a, b); });
  }

  fraction_arithmetic<Coefficient>& arithmetic() { return arithmetic_; }

protected:
  graph& owner() { return g_; }

private:
  fraction value(int id, const fraction& a, const fraction& b) {
    const operation op = g_[id].op;
    if (op == operation::negate) return arithmetic_.negative(a);
    if (op == operation::add) return arithmetic_.sum(a, b);
    if (op == operation::subtract) return arithmetic_.sum(a, arithmetic_.negative(b));
    if (op == operation::multiply) return arithmetic_.product(a, b);
    if (op == operation::divide) return divided(a, b);
    Form& form = static_cast<Form&>(*this);
    if (is_atomic(op)) {
      const polynomial<Coefficient> p = atom<Coefficient>({g_, id});
      if (op != operation::symbol && !p.is_constant()) form.meets_opaque(id);
      return {p, {}};
    }
    if (const auto known = form.function(op, a)) return divided({known->first, {}}, {known->second, {}});
    const unsigned_argument x = form.argument(a), y = form.argument(b);
    const polynomial<Coefficient> f = function_of<Coefficient>(op, x, y);
    if (f.is_constant()) return {f, {}};
    const int base = f.terms.front().factors.front().base;
    form.meets_opaque(base);
    if (op == operation::sqrt) arithmetic_.set_square(base, a);
    return {f, {}};
  }

  fraction divided(const fraction& a, const fraction& b) {
    if (b.above.is_zero()) {
      left_.fail("it divides by an expression that is zero everywhere");
      return {};
    }
    return arithmetic_.quotient(a, b);
  }

  graph& g_;
  budget& left_;
  fraction_arithmetic<Coefficient> arithmetic_;
};

} // namespace kanexpr::symbolic::algebra
