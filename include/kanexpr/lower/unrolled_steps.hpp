#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/step_plan.hpp>
#include <kanexpr/lower/unrolled_elimination.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstddef>
#include <type_traits>

namespace kanexpr::lower {

/// What the straight-line evaluations of the tape of `Code` share: the plan of its steps, and what each step
/// does.
template <class Code, class Number>
class unrolled_steps {
public:
  static constexpr const auto& tape = Code::tape;
  static constexpr step_plan<Code> plan{};
  static constexpr int first_angle = tape.sizes.first_angle, angles = tape.sizes.angles,
                       given_before = tape.sizes.numbers + plan.early_count + first_angle;

  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }

  // consteval, because clang++ would otherwise load an index from the tape
  static consteval int what(int entry) { return plan.what[entry / row_length][entry % row_length]; }
  static consteval int aside_of(int entry) { return plan.aside[entry / row_length][entry % row_length]; }
  static consteval int a_of_step(int step) { return plan.place_of(tape.a[step]); }
  static consteval int b_of_step(int step) { return plan.place_of(tape.b[step]); }

  /// Numbers are passed by value, because a reference would require them to be in memory.
  using operand = std::conditional_t<std::is_arithmetic_v<Number>, Number, const Number&>;

  /// Returns the value of an entry that is no argument. Only entries that need them receive the scratch
  /// memory and the slots.
  template <int what>
  [[gnu::always_inline]] static Number step(operand a, [[maybe_unused]] operand b,
                                            [[maybe_unused]] Number* aside,
                                            [[maybe_unused]] const Number* slot) noexcept {
    if constexpr (!plan.uses_aside(what)) {
      return apply<static_cast<operation>(what), Number>(a, b);
    } else {
      if constexpr (what == plan.sine_and_cosine)
        scalar_math<Number>::sincos(a, aside[0], aside[1]);
      else if constexpr (what < 0)
        eliminate<plan.first_linear_step - what>(aside, slot);
      return *aside;
    }
  }

private:
  template <int index>
  [[gnu::always_inline]] static void eliminate(Number* out, const Number* slot) noexcept {
    constexpr linear_step e = tape.linear_steps[index];
    if constexpr (e.op == operation::call) {
      *out = call<index>(slot, up_to<e.order>);
    } else if constexpr (e.op == operation::singularity_measure) {
      Number squares[static_cast<std::size_t>(e.inputs())];
      gather<e.operands>(squares, slot, up_to<e.inputs()>);
      *out = unrolled_elimination<e.order, Number>::singularity_measure(slot + plan.place_of(e.factors),
                                                                        squares);
    } else {
      gather<e.operands>(out, slot, up_to<e.inputs()>);
      if constexpr (e.op == operation::factorization)
        unrolled_elimination<e.order, Number>::factorize(out);
      else if constexpr (e.op == operation::solve)
        unrolled_elimination<e.order, Number>::solve(slot + plan.place_of(e.factors), out);
      else
        unrolled_elimination<e.order, Number>::solve_transposed(slot + plan.place_of(e.factors), out);
    }
  }

  template <int step, int... index>
  [[gnu::always_inline]] static Number call(const Number* slot, indices<index...>) noexcept {
    constexpr linear_step e = tape.linear_steps[step];
    using function = decltype(callable_of(symbolic::external_key<tape.externals[e.factors]>{}));
    return scalar_math<Number>::template called<function>(slot[plan.operands[e.operands + index]]...);
  }

  template <int begin, int... index>
  [[gnu::always_inline]] static void gather(Number* out, const Number* slot, indices<index...>) noexcept {
    const int order[]{(out[index] = slot[plan.operands[begin + index]], 0)...};
    static_cast<void>(order);
  }
};

} // namespace kanexpr::lower
