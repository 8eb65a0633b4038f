#pragma once

#include <kanexpr/lower/column_steps.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/unrolled_elimination.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Evaluates the steps of a tape on values of any type: numbers, or lines of generated code. A value type
/// must provide arithmetic and a `scalar_math`. `Code` is a tape or a view of one.
namespace kanexpr::lower {

/// Returns the scratch size that `evaluate_steps` requires in addition to the slots.
template <class Code>
constexpr int aside_of(const Code& code) {
  int most = 0;
  for (const linear_step& e : code.linear_steps) most = e.inputs() > most ? e.inputs() : most;
  return most;
}

template <class Code, class Number>
void evaluate_columns(const Code& code, const linear_step& e, Number* values, Number* aside) {
  const numeric::column_steps steps = column_steps_of(code, e);
  Number* const right = aside + numeric::symmetric_factors{e.order}.size();
  for (int i = 0; i < e.inputs(); ++i) aside[i] = values[code.operands[e.operands + i]];
  bool is_solved = false;
  if constexpr (requires { scalar_math<Number>::solve_columns(steps, e.order, e.factors, aside, right); })
    is_solved = scalar_math<Number>::solve_columns(steps, e.order, e.factors, aside, right);
  for (int j = 0; j < e.factors && !is_solved; ++j) numeric::solve_column(steps, aside, right + j, e.factors);
  for (int i = 0; i < e.outputs(); ++i) values[code.first_step() + e.step + i] = right[i];
}

template <class Code, class Number>
void evaluate_linear_step(const Code& code, const linear_step& e, Number* values, Number* aside) {
  using math = elimination_math<Number>;
  Number* const out = values + code.first_step() + e.step;
  Number* const into = e.op == operation::singularity_measure || e.op == operation::call ? aside : out;
  if (e.op == operation::symmetric_solve) return evaluate_columns(code, e, values, aside);
  const Number* const factors = values + e.factors;
  for (int i = 0; i < e.inputs(); ++i) into[i] = values[code.operands[e.operands + i]];
  if (e.op == operation::factorization)
    numeric::factorize<math>(e.order, out);
  else if (e.op == operation::singularity_measure)
    *out = numeric::singularity_measure_of<math>(e.order, factors, into);
  else if (e.op == operation::call)
    *out = scalar_math<Number>::called(*code.externals[e.factors], into);
  else if (e.op == operation::solve)
    numeric::solve_factorized<math>(e.order, factors, out);
  else
    numeric::solve_transposed_factorized<math>(e.order, factors, out);
}

template <class Number>
void evaluate_step(const instruction& step, const Number* values, Number* out) {
  const Number& a = values[step.a];
  const Number& b = values[step.b];
  if (step.paired) {
    if (step.op == operation::sin) scalar_math<Number>::sincos(a, out[0], out[1]);
    return;
  }
  using symbolic::form;
  switch (symbolic::form_of(step.op)) {
  case form::negate: *out = apply<operation::negate>(a, b); return;
  case form::add: *out = apply<operation::add>(a, b); return;
  case form::subtract: *out = apply<operation::subtract>(a, b); return;
  case form::multiply: *out = apply<operation::multiply>(a, b); return;
  case form::divide: *out = apply<operation::divide>(a, b); return;
  case form::power: *out = apply<operation::power>(a, b); return;
  case form::selection:
    *out = step.op == operation::if_positive ? apply<operation::if_positive>(a, b)
                                             : apply<operation::if_not_positive>(a, b);
    return;
  case form::function:
    symbolic::with_function(step.op, [&]<operation function>() { *out = apply<function>(a, b); });
    return;
  case form::binary_function:
    symbolic::with_binary_function(step.op, [&]<operation function>() { *out = apply<function>(a, b); });
    return;
  case form::leaf:                   // loaded beforehand
  case form::list_operation: return; // executed as linear steps
  }
}

template <class Code, class Number>
void evaluate_steps(const Code& code, int begin, int end, Number* values) {
  Number* out = values + code.first_step() + begin;
  for (int i = begin; i < end; ++i) evaluate_step(code.steps[i], values, out++);
}

/// Computes the slots of all steps in order; the slots of the constants and of the arguments must already be
/// filled.
template <class Code, class Number>
void evaluate_steps(const Code& code, Number* values, Number* aside) {
  int next = 0;
  for (const linear_step& e : code.linear_steps) {
    evaluate_steps(code, next, e.step, values);
    evaluate_linear_step(code, e, values, aside);
    next = e.step + e.outputs();
  }
  evaluate_steps(code, next, code.steps.size(), values);
}

} // namespace kanexpr::lower
