#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/unrolled_elimination.hpp>
#include <kanexpr/lower/vector_step.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <type_traits>
#include <utility>

namespace kanexpr::lower {

/// The action of each step that follows the angles of a tape, encoded as one number, so that all steps with
/// the same action share one function. A step that fills several slots stores its values in scratch memory,
/// from which each slot takes its value.
template <class Code>
struct step_plan {
  static constexpr const auto& tape = Code::tape;
  /// The actions other than operations and components: a sine with its cosine, and the linear steps from
  /// `first_linear_step` downward.
  static constexpr int sine_and_cosine = -1, first_linear_step = -2;
  static constexpr int component = static_cast<int>(operation::component);

  static constexpr std::size_t steps = tape.sizes.steps > 0 ? static_cast<std::size_t>(tape.sizes.steps) : 1;
  int what[steps]{};
  int aside[steps]{};
  int aside_count = 0;

  constexpr step_plan() {
    for (int i = 0; i < tape.sizes.steps; ++i)
      what[i] = !tape.paired[i]                ? static_cast<int>(tape.op[i])
                : tape.op[i] == operation::sin ? sine_and_cosine
                                               : component;
    for (int i = 0; i < tape.sizes.linear_steps; ++i) what[tape.linear_steps[i].step] = first_linear_step - i;
    for (int i = tape.sizes.first_angle + 2 * tape.sizes.angles; i < tape.sizes.steps; ++i)
      if (uses_aside(what[i])) aside[i] = aside_count++;
  }

  static constexpr bool uses_aside(int what) { return what < 0 || what == component; }
};

/// Straight-line evaluation of a tape that is a constant of the type `Code` (`Code::tape`).
///
/// Every index is a constant, and all steps are in one function, each at the position of its slot in one
/// initializer, so compilers replace the array by registers before any other optimization. If there were a
/// pointer to the slots, they would analyze the memory accesses of every step again after each level of
/// inlining.
template <class Code, class Number>
class unrolled_tape {
public:
  static constexpr const auto& tape = Code::tape;

  /// `arguments(load)` returns the value of each load.
  template <class Arguments>
  [[gnu::always_inline]] explicit unrolled_tape(const Arguments& arguments) noexcept {
    run(arguments, up_to<tape.sizes.numbers>{}, up_to<tape.sizes.loads>{}, up_to<first_angle>{},
        up_to<angles>{}, up_to<first + first_angle>{}, up_to<2 * angles>{},
        up_to<tape.sizes.steps - behind>{}, up_to<tape.sizes.results>{});
  }

  template <int index>
  [[gnu::always_inline]] const Number& result() const noexcept {
    if constexpr (with_vectors)
      return result_[steps_on_vectors<Code, Number>::place_of(index)];
    else
      return result_[index];
  }

  /// Evaluates a piece of a longer tape: the loads are places in `memory`, and steps whose values other
  /// pieces use store them at once, so that they need no register until the end.
  [[gnu::always_inline]] static void run_in(Number* memory) noexcept {
    run_in(memory, up_to<tape.sizes.numbers>{}, up_to<tape.sizes.loads>{}, up_to<first_angle>{},
           up_to<angles>{}, up_to<first + first_angle>{}, up_to<2 * angles>{},
           up_to<tape.sizes.steps - behind>{});
  }

private:
  static constexpr step_plan<Code> plan{};
  static constexpr bool with_vectors = uses_vectors<Code, Number>();
  static constexpr int first = tape.first_step(), first_angle = tape.sizes.first_angle,
                       angles = tape.sizes.angles, behind = first_angle + 2 * angles;

  template <int count>
  using up_to = std::make_integer_sequence<int, count>;
  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }

  // consteval, because clang++ would otherwise load an index from the tape
  static consteval int a(int step) { return tape.a[step]; }
  static consteval int b(int step) { return tape.b[step]; }
  static consteval int slot_of(int result) { return tape.results[result]; }

  /// Numbers are passed by value, because a reference would require them to be in memory.
  using operand = std::conditional_t<std::is_arithmetic_v<Number>, Number, const Number&>;

  /// A single call computes the sines and cosines of all angles that are known at the start; a scalar type
  /// may replace the function that it calls.
  template <class Arguments, int... number, int... load, int... before, int... angle, int... known,
            int... turned, int... after, int... result>
  [[gnu::always_inline]] void run([[maybe_unused]] const Arguments& arguments,
                                  std::integer_sequence<int, number...>, std::integer_sequence<int, load...>,
                                  std::integer_sequence<int, before...>, std::integer_sequence<int, angle...>,
                                  std::integer_sequence<int, known...>, std::integer_sequence<int, turned...>,
                                  std::integer_sequence<int, after...>,
                                  std::integer_sequence<int, result...>) noexcept {
    [[maybe_unused]] const Number given[at_least_one(first + first_angle)] {
      number_as<Number>(tape.numbers[number])...,
      arguments.template operator()<tape.loads[load].from, tape.loads[load].position>()...,
      take<plan.what[before]>(given[a(before)], given[b(before)], nullptr, nullptr)...
    };
    [[maybe_unused]] Number sine[at_least_one(angles)], cosine[at_least_one(angles)];
    if constexpr (angles > 0) {
      const Number all[]{given[a(first_angle + 2 * angle)]...};
      scalar_math<Number>::template sincos<static_cast<std::size_t>(angles)>(all, sine, cosine);
    }
    if constexpr (with_vectors) {
      const Number before_steps[]{given[known]..., (turned % 2 == 0 ? sine : cosine)[turned / 2]...};
      steps_on_vectors<Code, Number>::run(before_steps, result_);
    } else {
      [[maybe_unused]] Number aside[at_least_one(plan.aside_count)];
      [[maybe_unused]] const Number slot[at_least_one(tape.slot_count())]{
          given[known]..., (turned % 2 == 0 ? sine : cosine)[turned / 2]...,
          take<plan.what[behind + after]>(
              slot[a(behind + after)], slot[b(behind + after)],
              plan.uses_aside(plan.what[behind + after]) ? aside + plan.aside[behind + after] : nullptr,
              plan.what[behind + after] < 0 ? slot : nullptr)...};
      const int order[]{0, (result_[result] = slot[slot_of(result)], 0)...};
      static_cast<void>(order);
    }
  }

  template <int... number, int... load, int... before, int... angle, int... known, int... turned,
            int... after>
  [[gnu::always_inline]] static void
  run_in(Number* memory, std::integer_sequence<int, number...>, std::integer_sequence<int, load...>,
         std::integer_sequence<int, before...>, std::integer_sequence<int, angle...>,
         std::integer_sequence<int, known...>, std::integer_sequence<int, turned...>,
         std::integer_sequence<int, after...>) noexcept {
    const Number given[at_least_one(first + first_angle)]{
        number_as<Number>(tape.numbers[number])..., memory[position(load)]...,
        kept<Code::to.is_kept[before]>(
            take<plan.what[before]>(given[a(before)], given[b(before)], nullptr, nullptr),
            memory + place(before))...};
    [[maybe_unused]] Number sine[at_least_one(angles)], cosine[at_least_one(angles)];
    if constexpr (angles > 0) {
      const Number all[]{given[a(first_angle + 2 * angle)]...};
      scalar_math<Number>::template sincos<static_cast<std::size_t>(angles)>(all, sine, cosine);
    }
    [[maybe_unused]] Number aside[at_least_one(plan.aside_count)];
    [[maybe_unused]] const Number slot[at_least_one(tape.slot_count())]{
        given[known]...,
        kept<Code::to.is_kept[first_angle + turned]>((turned % 2 == 0 ? sine : cosine)[turned / 2],
                                                     memory + place(first_angle + turned))...,
        kept<Code::to.is_kept[behind + after]>(
            take<plan.what[behind + after]>(
                slot[a(behind + after)], slot[b(behind + after)],
                plan.uses_aside(plan.what[behind + after]) ? aside + plan.aside[behind + after] : nullptr,
                plan.what[behind + after] < 0 ? slot : nullptr),
            memory + place(behind + after))...};
  }

  static consteval int position(int load) { return tape.loads[load].position; }
  static consteval int place(int step) { return Code::to.place[step]; }

  /// Returns the value of a step, and stores it if other pieces use it.
  template <bool is_stored>
  [[gnu::always_inline]] static Number kept(operand value, [[maybe_unused]] Number* place) noexcept {
    if constexpr (is_stored) *place = value;
    return value;
  }

  /// Returns the value of a slot. Only steps that need them receive the scratch memory and the slots.
  template <int what>
  [[gnu::always_inline]] static Number take(operand a, [[maybe_unused]] operand b,
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

  template <int index>
  [[gnu::always_inline]] static void eliminate(Number* out, const Number* slot) noexcept {
    constexpr linear_step e = tape.linear_steps[index];
    if constexpr (e.op == operation::call) {
      *out = call<index>(slot, up_to<e.order>{});
    } else if constexpr (e.op == operation::singularity_measure) {
      Number squares[static_cast<std::size_t>(e.inputs())];
      gather<e.operands>(squares, slot, up_to<e.inputs()>{});
      *out = unrolled_elimination<e.order, Number>::singularity_measure(slot + e.factors, squares);
    } else {
      gather<e.operands>(out, slot, up_to<e.inputs()>{});
      if constexpr (e.op == operation::factorization)
        unrolled_elimination<e.order, Number>::factorize(out);
      else if constexpr (e.op == operation::solve)
        unrolled_elimination<e.order, Number>::solve(slot + e.factors, out);
      else
        unrolled_elimination<e.order, Number>::solve_transposed(slot + e.factors, out);
    }
  }

  template <int step, int... index>
  [[gnu::always_inline]] static Number call(const Number* slot,
                                            std::integer_sequence<int, index...>) noexcept {
    constexpr linear_step e = tape.linear_steps[step];
    using function = decltype(callable_of(symbolic::external_key<tape.externals[e.factors]>{}));
    return scalar_math<Number>::template called<function>(slot[tape.operands[e.operands + index]]...);
  }

  template <int begin, int... index>
  [[gnu::always_inline]] static void gather(Number* out, const Number* slot,
                                            std::integer_sequence<int, index...>) noexcept {
    const int order[]{(out[index] = slot[tape.operands[begin + index]], 0)...};
    static_cast<void>(order);
  }

  static consteval std::size_t places() {
    if constexpr (with_vectors)
      return at_least_one(steps_on_vectors<Code, Number>::places);
    else
      return at_least_one(tape.sizes.results);
  }

  Number result_[places()];
};

} // namespace kanexpr::lower
