#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/step_plan.hpp>
#include <kanexpr/lower/unrolled_elimination.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <type_traits>

namespace kanexpr::lower {

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
    run(arguments, up_to<tape.sizes.numbers>, up_to<plan.early_count>, up_to<first_angle>, up_to<angles>,
        up_to<given_before>, up_to<2 * angles>, up_to<plan.entries>, up_to<tape.sizes.results>);
  }

  template <int index>
  [[gnu::always_inline]] const Number& result() const noexcept {
    return result_[index];
  }

  /// Evaluates a piece of a longer tape: the loads are places in `memory`, and steps whose values other
  /// pieces use store them at once, so that they need no register until the end.
  [[gnu::always_inline]] static void run_in(Number* memory) noexcept {
    run_in(memory, up_to<tape.sizes.numbers>, up_to<plan.early_count>, up_to<first_angle>, up_to<angles>,
           up_to<given_before>, up_to<2 * angles>, group_of_five<plan.entries, 0>,
           group_of_five<plan.entries, 1>, group_of_five<plan.entries, 2>, group_of_five<plan.entries, 3>,
           group_of_five<plan.entries, 4>);
  }

private:
  static constexpr step_plan<Code> plan{};
  static constexpr int first_angle = tape.sizes.first_angle, angles = tape.sizes.angles,
                       given_before = tape.sizes.numbers + plan.early_count + first_angle;

  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }

  // consteval, because clang++ would otherwise load an index from the tape
  static consteval int a(int entry) { return plan.a[entry / row_length][entry % row_length]; }
  static consteval int b(int entry) { return plan.b[entry / row_length][entry % row_length]; }
  static consteval int what(int entry) { return plan.what[entry / row_length][entry % row_length]; }
  static consteval int aside_of(int entry) { return plan.aside[entry / row_length][entry % row_length]; }
  static consteval int a_of_step(int step) { return plan.place_of(tape.a[step]); }
  static consteval int b_of_step(int step) { return plan.place_of(tape.b[step]); }
  static consteval int place_of(int result) { return plan.place_of(tape.results[result]); }
  static consteval load load_of(int index) {
    if constexpr (requires { tape.loads; })
      return tape.loads[index];
    else // of a piece
      return {{}, tape.place_of_load(index)};
  }
  static consteval load early(int index) { return load_of(plan.early[index]); }

  /// Numbers are passed by value, because a reference would require them to be in memory.
  using operand = std::conditional_t<std::is_arithmetic_v<Number>, Number, const Number&>;

  /// A single call computes the sines and cosines of all angles that are known at the start; a scalar type
  /// may replace the function that it calls.
  template <class Arguments, int... number, int... load, int... before, int... angle, int... known,
            int... turned, int... entry, int... result>
  [[gnu::always_inline]] void run([[maybe_unused]] const Arguments& arguments, indices<number...>,
                                  indices<load...>, indices<before...>, indices<angle...>, indices<known...>,
                                  indices<turned...>, indices<entry...>, indices<result...>) noexcept {
    [[maybe_unused]] const Number given[at_least_one(given_before)] {
      number_as<Number>(tape.numbers[number])...,
      arguments.template operator()<early(load).from, early(load).position>()...,
      apply<tape.op[before], Number>(given[a_of_step(before)], given[b_of_step(before)])...
    };
    [[maybe_unused]] Number sine[at_least_one(angles)], cosine[at_least_one(angles)];
    if constexpr (angles > 0) {
      const Number all[]{given[a_of_step(first_angle + 2 * angle)]...};
      scalar_math<Number>::template sincos<static_cast<std::size_t>(angles)>(all, sine, cosine);
    }
    [[maybe_unused]] Number aside[at_least_one(plan.aside_count)];
    [[maybe_unused]] const Number slot[at_least_one(tape.slot_count())]{
        given[known]..., (turned % 2 == 0 ? sine : cosine)[turned / 2]...,
        take<what(entry)>(slot[a(entry)], slot[b(entry)],
                          plan.uses_aside(what(entry)) ? aside + aside_of(entry) : nullptr,
                          what(entry) < 0 ? slot : nullptr, &arguments)...};
    const int order[]{0, (result_[result] = slot[place_of(result)], 0)...};
    static_cast<void>(order);
  }

  /// The entries come in five groups.
  template <int... number, int... load, int... before, int... angle, int... known, int... turned, int... e0,
            int... e1, int... e2, int... e3, int... e4>
  [[gnu::always_inline]] static void run_in(Number* memory, indices<number...>, indices<load...>,
                                            indices<before...>, indices<angle...>, indices<known...>,
                                            indices<turned...>, indices<e0...>, indices<e1...>,
                                            indices<e2...>, indices<e3...>, indices<e4...>) noexcept {
    const Number given[at_least_one(given_before)]{
        number_as<Number>(tape.numbers[number])..., memory[early(load).position]...,
        kept<is_kept_step(before)>(
            apply<tape.op[before], Number>(given[a_of_step(before)], given[b_of_step(before)]),
            memory + place(before))...};
    const arguments_in_memory arguments{memory};
    [[maybe_unused]] Number sine[at_least_one(angles)], cosine[at_least_one(angles)];
    if constexpr (angles > 0) {
      const Number all[]{given[a_of_step(first_angle + 2 * angle)]...};
      scalar_math<Number>::template sincos<static_cast<std::size_t>(angles)>(all, sine, cosine);
    }
    [[maybe_unused]] Number aside[at_least_one(plan.aside_count)];
    [[maybe_unused]] const Number slot[at_least_one(tape.slot_count())]{
        given[known]...,
        kept<is_kept_step(first_angle + turned)>((turned % 2 == 0 ? sine : cosine)[turned / 2],
                                                 memory + place(first_angle + turned))...,
        store<what(e0), is_kept(e0)>(slot[a(e0)], slot[b(e0)], aside + aside_of(e0), slot, arguments,
                                     memory + place_of_entry(e0))...,
        store<what(e1), is_kept(e1)>(slot[a(e1)], slot[b(e1)], aside + aside_of(e1), slot, arguments,
                                     memory + place_of_entry(e1))...,
        store<what(e2), is_kept(e2)>(slot[a(e2)], slot[b(e2)], aside + aside_of(e2), slot, arguments,
                                     memory + place_of_entry(e2))...,
        store<what(e3), is_kept(e3)>(slot[a(e3)], slot[b(e3)], aside + aside_of(e3), slot, arguments,
                                     memory + place_of_entry(e3))...,
        store<what(e4), is_kept(e4)>(slot[a(e4)], slot[b(e4)], aside + aside_of(e4), slot, arguments,
                                     memory + place_of_entry(e4))...};
  }

  /// The arguments of a piece.
  struct arguments_in_memory {
    const Number* memory;

    template <symbolic::symbol_kind, int position>
    [[gnu::always_inline]] const Number& operator()() const noexcept {
      return memory[position];
    }
  };

  static consteval bool is_kept_step(int step) { return tape.to[step] >= 0; }
  static consteval int place(int step) { return is_kept_step(step) ? tape.to[step] : 0; }
  static consteval int step_of(int entry) { return plan.step[entry / row_length][entry % row_length]; }
  static consteval bool is_kept(int entry) { return step_of(entry) >= 0 && is_kept_step(step_of(entry)); }
  static consteval int place_of_entry(int entry) { return is_kept(entry) ? place(step_of(entry)) : 0; }

  /// Returns the value of a step, and stores it if other pieces use it.
  template <bool is_stored>
  [[gnu::always_inline]] static Number kept(operand value, [[maybe_unused]] Number* place) noexcept {
    if constexpr (is_stored) *place = value;
    return value;
  }

  /// Returns the value of an entry. Only steps that need them receive the scratch memory and the slots.
  template <int what, class Arguments>
  [[gnu::always_inline]] static Number
  take(operand a, [[maybe_unused]] operand b, [[maybe_unused]] Number* aside,
       [[maybe_unused]] const Number* slot, [[maybe_unused]] const Arguments* arguments) noexcept {
    if constexpr (what <= plan.first_argument) {
      constexpr load from = load_of(plan.first_argument - what);
      return arguments->template operator()<from.from, from.position>();
    } else if constexpr (!plan.uses_aside(what)) {
      return apply<static_cast<operation>(what), Number>(a, b);
    } else {
      if constexpr (what == plan.sine_and_cosine)
        scalar_math<Number>::sincos(a, aside[0], aside[1]);
      else if constexpr (what < 0)
        eliminate<plan.first_linear_step - what>(aside, slot);
      return *aside;
    }
  }

  /// Returns the value of an entry of a piece, and stores it if other pieces use it.
  template <int what, bool is_stored>
  [[gnu::always_inline]] static Number store(operand a, operand b, Number* aside, const Number* slot,
                                             const arguments_in_memory& arguments, Number* place) noexcept {
    return kept<is_stored>(take<what>(a, b, aside, slot, &arguments), place);
  }

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

  Number result_[at_least_one(tape.sizes.results)];
};

} // namespace kanexpr::lower
