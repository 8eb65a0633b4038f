#pragma once

#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/column_steps.hpp>
#include <kanexpr/lower/instruction.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::lower {

namespace detail {

/// One member of all steps.
template <auto member>
struct step_member {
  const instruction* steps;
  constexpr auto operator[](int i) const { return steps[i].*member; }
};

/// Counts operations, and the sums that can be evaluated together with a product that nothing else uses. The
/// code calls no functions, because compilers interpret and remember every call.
template <class Operations, class Operands, class Pairs, class Uses, class Tape>
constexpr void count_steps(const Operations& op, const Operands& a, const auto& b, const Pairs& paired,
                           Uses& uses, const Tape& t, symbolic::cost& total) {
  constexpr operation add = operation::add, subtract = operation::subtract, multiply = operation::multiply;
  const int count = t.steps.size(), first = t.first_step();
  int times[static_cast<int>(operation::singularity_measure) + 1]{}; // the number of steps of each operation
  for (int i = 0; i < t.slot_count(); ++i) uses[i] = 0;
  int repeated = 0;
  for (int i = 0; i < count; ++i) {
    ++times[static_cast<int>(op[i])];
    if (op[i] >= operation::component) continue; // its operands are listed
    ++uses[a[i]];
    ++uses[b[i]]; // the slot of a number or an argument for operations with one operand
    if (op[i] == operation::cos && paired[i]) ++repeated;
  }
  for (int slot : t.operands) ++uses[slot];
  for (int slot : t.results) ++uses[slot];
  int fused = 0;
  for (int i = 0; i < count; ++i) {
    if (op[i] != add && op[i] != subtract) continue;
    const int one = a[i], other = b[i];
    if ((one >= first && uses[one] == 1 && op[one - first] == multiply) ||
        (other >= first && uses[other] == 1 && op[other - first] == multiply))
      ++fused;
  }
  for (int each = 0; each < static_cast<int>(operation::component); ++each)
    total.count(static_cast<operation>(each), times[each]);
  total.trigonometric -= repeated;
  total.fused += fused;
}

} // namespace detail

/// Returns the cost of one evaluation of a tape.
template <class Steps>
constexpr symbolic::cost cost_of(const basic_tape<Steps>& t) {
  symbolic::cost total;
  for (const linear_step& e : t.linear_steps) {
    if (e.op == operation::factorization)
      total.count_factorization(e.order);
    else if (e.op == operation::singularity_measure)
      total.count_singularity_measure(e.order);
    else if (e.op == operation::call)
      total.count(operation::call);
    else if (e.op == operation::symmetric_solve)
      total.count_columns(column_steps_of(t, e), e.factors);
    else
      total.count_substitution(e.order);
  }
  base::zeros<int> uses(t.slot_count());
  if constexpr (requires { t.steps.count; }) {
    detail::count_steps(t.steps.op.template elements<true>(), t.steps.a.template elements<true>(),
                        t.steps.b.template elements<true>(), t.steps.paired.template elements<true>(),
                        uses.elements<true>(), t, total);
  } else {
    using detail::step_member;
    const instruction* const all = t.steps.begin();
    const step_member<&instruction::op> op{all};
    const step_member<&instruction::a> a{all};
    const step_member<&instruction::b> b{all};
    const step_member<&instruction::paired> paired{all};
    int* const use = uses.begin();
    detail::count_steps(op, a, b, paired, use, t, total);
  }
  return total;
}

} // namespace kanexpr::lower
