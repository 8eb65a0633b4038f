#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/lower/regular.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/checks/check_derivatives.hpp>
#include <kanexpr/mechanics/dynamics/singularity_check.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>

#include <limits>

namespace kanexpr::runtime {

/// The code of a result, with checks that all systems of equations on which it depends can be solved at a
/// state. The evaluation does not allocate memory.
template <class Scalar>
class checked_code {
public:
  /// `checks` detect singularities in the computation of the result.
  checked_code(symbolic::graph& g, const symbolic::matrix& wanted,
               const base::sequence<mechanics::singularity_check>& checks);

  /// Returns the entries of the result, row by row.
  template <class Arguments>
  const Scalar* evaluate(const Arguments& value_of) {
    code_.evaluate(value_of, found_.begin());
    return found_.begin();
  }

  const lower::tape& code() const { return code_.code(); }
  symbolic::cost cost() const;
  /// Reports whether all systems of equations could be solved in the last evaluation.
  kanexpr::status status() const;

private:
  static base::sequence<int> nodes(symbolic::graph& g, const symbolic::matrix& wanted,
                                   const base::sequence<mechanics::singularity_check>& checks);

  interpreter<Scalar> code_;
  base::sequence<Scalar> found_; ///< the result, then the measure and the scale of each check
  base::sentence lacking_{};     ///< reports a missing derivative, without which there are no values
  base::sequence<base::sentence> causes_{};
  base::sequence<bool> is_of_finiteness_{}; ///< whether each check tests for finite values
};

template <class Scalar>
checked_code<Scalar>::checked_code(symbolic::graph& g, const symbolic::matrix& wanted,
                                   const base::sequence<mechanics::singularity_check>& checks)
    : code_(lower::tape_of(g, nodes(g, wanted, checks))),
      found_(code_.size(), lower::scalar_math<Scalar>::from(0)),
      lacking_(mechanics::check_derivatives(wanted)) {
  for (const mechanics::singularity_check& each : checks) {
    causes_.push(each.cause);
    is_of_finiteness_.push(each.of_finiteness);
  }
}

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
symbolic::cost checked_code<Scalar>::cost() const {
  return lower::cost_of(code_.code());
}

template <class Scalar>
kanexpr::status checked_code<Scalar>::status() const {
  if (lacking_) return kanexpr::status(lacking_.view());
  const int results = code_.size() - 2 * causes_.size();
  for (int i = 0; i < causes_.size(); ++i) {
    const Scalar &measure = found_[results + 2 * i], &scale = found_[results + 2 * i + 1];
    constexpr double least = base::least_singularity_measure<Scalar>();
    if (is_of_finiteness_[i] ? !lower::passes<true>(measure, scale, least)
                             : !lower::passes<false>(measure, scale, least))
      return kanexpr::status(causes_[i].view());
  }
  return {};
}

#if defined KANEXPR_COMPILED_ENGINE
extern template class checked_code<double>;
extern template class checked_code<float>;
#endif

} // namespace kanexpr::runtime
