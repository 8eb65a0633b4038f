#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/lower/evaluate_steps.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/mechanics/checks/check_derivatives.hpp>
#include <kanexpr/mechanics/dynamics/singularity_check.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

#include <limits>

namespace kanexpr::runtime {

/// Evaluates code that is known only at run time, a tape or a view of one. It performs the same steps as
/// compiled code, in the same order and arithmetic, so the results agree to the last bit. The constructor
/// allocates all memory.
template <class Number = double, class Code = lower::tape>
class interpreter {
public:
  explicit interpreter(const Code& code);

  const Code& code() const { return code_; }
  int size() const { return code_.results.size(); }

  /// Writes `results[i]` for each result; `value_of(load)` returns the value of a symbol, given its kind and
  /// position.
  template <class Arguments, class Results>
  void evaluate(const Arguments& value_of, Results&& results) {
    const int first_load = code_.numbers.size();
    for (int i = 0; i < code_.loads.size(); ++i) slots_[first_load + i] = value_of(code_.loads[i]);
    run();
    for (int i = 0; i < size(); ++i) results[i] = slots_[code_.results[i]];
  }

private:
  void run();

  Code code_;
  base::sequence<Number> slots_;
  base::sequence<Number> scratch_; ///< working memory of a step
};

// These members are defined outside the class; inside it they would be inline, and every file would compile
// them.

template <class Number, class Code>
interpreter<Number, Code>::interpreter(const Code& code)
    : code_(code), slots_(code.slot_count(), lower::scalar_math<Number>::from(0)),
      scratch_(lower::aside_of(code), lower::scalar_math<Number>::from(0)) {
  for (int i = 0; i < code_.numbers.size(); ++i) slots_[i] = lower::number_as<Number>(code_.numbers[i]);
}

template <class Number, class Code>
void interpreter<Number, Code>::run() {
  lower::evaluate_steps(code_, slots_.begin(), scratch_.begin());
}

/// Whether a check passes: the measure must be finite or, compared with the scale, not singular.
template <class Scalar>
bool passes(bool of_finiteness, const Scalar& measure, const Scalar& scale) {
  constexpr double least = base::least_singularity_measure<Scalar>();
  return of_finiteness ? lower::passes<true>(measure, scale, least)
                       : lower::passes<false>(measure, scale, least);
}

/// The code of a result, with checks that all systems of equations on which it depends can be solved at a
/// state. The evaluation does not allocate memory.
template <class Scalar>
class checked_code {
public:
  /// `checks` detect singularities in the computation of the result. If the result must be finite, the status
  /// reports every entry that is not.
  checked_code(symbolic::graph& g, const symbolic::matrix& wanted,
               const base::sequence<mechanics::singularity_check>& checks, bool must_be_finite);

  /// Returns the entries of the result, row by row.
  template <class Arguments>
  const Scalar* evaluate(const Arguments& value_of) {
    code_.evaluate(value_of, found_.begin());
    return found_.begin();
  }

  const lower::tape& code() const { return code_.code(); }
  symbolic::cost cost() const { return lower::cost_of(code_.code()); }
  /// Reports whether all systems of equations could be solved in the last evaluation.
  kanexpr::status status() const;

private:
  static base::sequence<int> nodes(symbolic::graph& g, const symbolic::matrix& wanted,
                                   const base::sequence<mechanics::singularity_check>& checks);

  interpreter<Scalar> code_;
  base::sequence<Scalar> found_;        ///< the result, then the measure and the scale of each check
  base::sentence missing_derivative_{}; ///< reports an unknown derivative; if set, there are no values
  base::sequence<mechanics::singularity_check> checks_;
  bool must_be_finite_;
};

template <class Scalar>
checked_code<Scalar>::checked_code(symbolic::graph& g, const symbolic::matrix& wanted,
                                   const base::sequence<mechanics::singularity_check>& checks,
                                   bool must_be_finite)
    : code_(lower::tape_of(g, nodes(g, wanted, checks))),
      found_(code_.size(), lower::scalar_math<Scalar>::from(0)),
      missing_derivative_(mechanics::check_derivatives(wanted)), checks_(checks),
      must_be_finite_(must_be_finite) {}

template <class Scalar>
base::sequence<int> checked_code<Scalar>::nodes(symbolic::graph& g, const symbolic::matrix& wanted,
                                                const base::sequence<mechanics::singularity_check>& checks) {
  base::sequence<int> ids = symbolic::nodes_of(wanted.entries);
  for (const mechanics::singularity_check& each : checks) {
    ids.push(each.measure.node());
    ids.push(each.scale.node());
  }
  if (mechanics::check_derivatives(wanted))
    for (int& id : ids) id = g.constant(symbolic::real(std::numeric_limits<double>::quiet_NaN()));
  return ids;
}

template <class Scalar>
kanexpr::status checked_code<Scalar>::status() const {
  if (missing_derivative_) return kanexpr::status(missing_derivative_.view());
  const int results = code_.size() - 2 * checks_.size();
  for (int i = 0; i < checks_.size(); ++i)
    if (!passes(checks_[i].of_finiteness, found_[results + 2 * i], found_[results + 2 * i + 1]))
      return kanexpr::status(checks_[i].cause.view());
  for (int i = 0; must_be_finite_ && i < results; ++i)
    if (!lower::scalar_math<Scalar>::is_finite(found_[i]))
      return kanexpr::status(mechanics::results_not_finite);
  return {};
}

#if defined KANEXPR_COMPILED_ENGINE
extern template class interpreter<double>;
extern template class interpreter<float>;
extern template class interpreter<double, lower::tape_view>;
extern template class checked_code<double>;
extern template class checked_code<float>;
#endif

} // namespace kanexpr::runtime
