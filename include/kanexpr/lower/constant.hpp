#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/column_steps.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <array>

/// Evaluation inside constant expressions, which cannot use Eigen or the C library.
namespace kanexpr::lower {

/// Executes a call or a step of an elimination; the solution of a singular system is NaN.
constexpr void run_linear_step(const linear_step& e, const int* operands,
                               const symbolic::external_function* const* externals, const double* slot,
                               double* out) {
  using math = numeric::constant_elimination_math;
  sequence<double> inputs;
  for (int i = 0; i < e.inputs(); ++i) inputs.push(slot[operands[e.operands + i]]);
  if (e.op == operation::call) {
    *out = externals[e.factors]->value(inputs.begin());
    return;
  }
  const double* const factors = slot + e.factors;
  if (e.op == operation::singularity_measure) {
    const bool singular = base::equal(factors[numeric::factors{e.order}.least_pivot()], 0.0);
    *out = singular ? 0 : numeric::singularity_measure_of<math>(e.order, factors, inputs.begin());
    return;
  }
  for (int i = 0; i < e.inputs(); ++i) out[i] = inputs[i];
  if (e.op == operation::factorization)
    numeric::factorize<math>(e.order, out);
  else if (base::equal(factors[numeric::factors{e.order}.least_pivot()], 0.0))
    for (int i = 0; i < e.order; ++i) out[i] = numeric::elementary::detail::not_a_number;
  else if (e.op == operation::solve)
    numeric::solve_factorized<math>(e.order, factors, out);
  else
    numeric::solve_transposed_factorized<math>(e.order, factors, out);
}

constexpr void run_columns(const tape_view& code, const linear_step& e, const double* slot, double* out) {
  const numeric::column_steps steps = column_steps_of(code, e);
  const int count = numeric::symmetric_factors{e.order}.size();
  sequence<double> factors(count, 0.0);
  for (int i = 0; i < count; ++i) factors[i] = slot[code.operands[e.operands + i]];
  for (int i = 0; i < e.outputs(); ++i) out[i] = slot[code.operands[e.operands + count + i]];
  for (int j = 0; j < e.factors; ++j) numeric::solve_column(steps, factors.begin(), out + j, e.factors);
}

/// Whether a tape contains selections; the values of steps that are not selected may then be undefined. This
/// is a variable because clang++ re-evaluates a local constant each time control reaches it.
template <const auto& tape>
inline constexpr bool selects = [] {
  for (int i = 0; i < tape.sizes.steps; ++i)
    if (symbolic::is_selection(tape.op[i])) return true;
  return false;
}();

/// Returns the values of all slots of a tape in order; `value_of(load)` returns the argument for a load.
template <const auto& tape, class ValueOf>
constexpr auto constant_slots(ValueOf value_of) {
  constexpr auto calculated = selects<tape> ? symbolic::defined_value_of : symbolic::value_of;
  std::array<double, static_cast<std::size_t>(tape.slot_count() + 1)> slot{};
  std::size_t next = 0;
  for (int i = 0; i < tape.sizes.numbers; ++i) slot[next++] = tape.numbers[i].value();
  for (int i = 0; i < tape.sizes.loads; ++i) slot[next++] = value_of(tape.loads[i]);
  for (int i = 0, e = 0; i < tape.sizes.steps;) {
    if (e < tape.sizes.linear_steps && tape.linear_steps[e].step == i) {
      if (tape.linear_steps[e].op == operation::symmetric_solve)
        run_columns(tape_view(tape), tape.linear_steps[e], slot.data(), slot.data() + next);
      else
        run_linear_step(tape.linear_steps[e], tape.operands, tape.externals, slot.data(), slot.data() + next);
      i += tape.linear_steps[e].outputs();
      next += static_cast<std::size_t>(tape.linear_steps[e++].outputs());
    } else {
      slot[next++] = calculated(tape.op[i], slot[static_cast<std::size_t>(tape.a[i])],
                                slot[static_cast<std::size_t>(tape.b[i])]);
      ++i;
    }
  }
  return slot;
}

} // namespace kanexpr::lower
