#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/lockstep_plan.hpp>
#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/vector_columns.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <cstddef>

namespace kanexpr::lower {

/// Evaluates the first piece of a tape in memory, with the operations of each step of `unrolled_tape`.
template <class Code, class Cuts, class Number>
class lockstep_tape {
  static constexpr const auto& tape = Code::tape;
  static constexpr const auto& plan = lockstep_plan<Code, Cuts, lanes_for_columns<Number>()>::value;
  static constexpr int lanes = plan.lanes;
  using vector = typename number_vector<Number, lanes>::type;

public:
  [[gnu::always_inline]] static void run_in(Number* memory) noexcept {
    run(memory, up_to<tape.sizes.numbers>, up_to<plan.early_count>, up_to<first_angle>, up_to<angles>,
        up_to<given_before>, up_to<2 * angles>, up_to<plan.entries>);
  }

private:
  static constexpr int first_angle = tape.sizes.first_angle, angles = tape.sizes.angles,
                       given_before = tape.sizes.numbers + plan.early_count + first_angle,
                       first_entry = given_before + 2 * angles;

  static constexpr std::size_t at_least_one(int n) { return n > 0 ? static_cast<std::size_t>(n) : 1; }

  /// A vector, or a number in its first lane; which of them is known for each entry.
  using item = vector;
  [[gnu::always_inline]] static vector as_item(Number one) noexcept {
    if constexpr (lanes == 2)
      return vector{one, 0};
    else
      return vector{one, 0, 0, 0};
  }
  [[gnu::always_inline]] static vector as_item(vector all) noexcept { return all; }

  static consteval int a(int entry) { return plan.a[entry]; }
  static consteval int b(int entry) { return plan.b[entry]; }
  static consteval int c(int entry) { return plan.c[entry]; }
  static consteval int d(int entry) { return plan.d[entry]; }
  static consteval int place(int entry) { return plan.place[entry]; }
  static consteval int place_of_step(int step) {
    return Cuts::value.place[tape.first_step() + step] >= 0 ? Cuts::value.place[tape.first_step() + step] : 0;
  }
  static consteval bool is_kept(int step) { return Cuts::value.place[tape.first_step() + step] >= 0; }
  static consteval int place_of_early(int index) {
    return Cuts::value.place[tape.sizes.numbers + plan.early[index]];
  }
  /// Operands of the steps before the angles are numbers, early arguments, and such steps.
  static consteval int entry_of(int slot) {
    if (slot < tape.sizes.numbers) return slot;
    if (slot >= tape.first_step()) return tape.sizes.numbers + plan.early_count + slot - tape.first_step();
    for (int i = 0; i < plan.early_count; ++i)
      if (plan.early[i] == slot - tape.sizes.numbers) return tape.sizes.numbers + i;
    return 0;
  }
  static consteval int a_of_step(int step) { return entry_of(tape.a[step]); }
  static consteval int b_of_step(int step) { return entry_of(tape.b[step]); }

  template <int... number, int... load, int... before, int... angle, int... known, int... turned,
            int... entry>
  [[gnu::always_inline]] static void run(Number* memory, indices<number...>, indices<load...>,
                                         indices<before...>, indices<angle...>, indices<known...>,
                                         indices<turned...>, indices<entry...>) noexcept {
    const Number given[at_least_one(given_before)]{
        number_as<Number>(tape.numbers[number])..., memory[place_of_early(load)]...,
        kept<is_kept(before)>(
            apply<tape.op[before], Number>(given[a_of_step(before)], given[b_of_step(before)]),
            memory + place_of_step(before))...};
    [[maybe_unused]] Number sine[at_least_one(angles)], cosine[at_least_one(angles)];
    if constexpr (angles > 0) {
      const Number all[]{given[a_of_step(first_angle + 2 * angle)]...};
      scalar_math<Number>::template sincos<static_cast<std::size_t>(angles)>(all, sine, cosine);
    }
    [[maybe_unused]] const item slot[at_least_one(first_entry + plan.entries)]{
        as_item(given[known])...,
        as_item(kept<is_kept(first_angle + turned)>((turned % 2 == 0 ? sine : cosine)[turned / 2],
                                                    memory + place_of_step(first_angle + turned)))...,
        as_item(take<plan.action[entry]>(slot[a(entry)], slot[b(entry)], slot[c(entry)], slot[d(entry)],
                                         memory + place(entry)))...};
  }

  template <bool is_stored>
  [[gnu::always_inline]] static Number kept(Number value, [[maybe_unused]] Number* to) noexcept {
    if constexpr (is_stored) *to = value;
    return value;
  }

  template <int code>
  [[gnu::always_inline]] static auto take([[maybe_unused]] const item& a, [[maybe_unused]] const item& b,
                                          [[maybe_unused]] const item& c, [[maybe_unused]] const item& d,
                                          Number* place) noexcept {
    constexpr lockstep_action action = lockstep_action::of(code);
    using kind = lockstep_action::kind;
    if constexpr (action.is == kind::argument) {
      return Number(*place);
    } else if constexpr (action.is == kind::value) {
      return kept<action.is_kept>(apply<action.op, Number>(value<action.a.lane, action.a.is_minus>(a),
                                                           value<action.b.lane, action.b.is_minus>(b)),
                                  place);
    } else if constexpr (action.is == kind::gather) {
      return gathered<action.minus_a>(a, b, c, d);
    } else {
      return combined<action.op>(with_signs<action.minus_a>(all_lanes<action.a.lane>(a)),
                                 with_signs<action.minus_b>(all_lanes<action.b.lane>(b)));
    }
  }

  template <int lane, bool is_minus>
  [[gnu::always_inline]] static Number value(const item& of) noexcept {
    Number read;
    if constexpr (lane == operand_form::scalar)
      read = of[0];
    else
      read = of[lane];
    if constexpr (is_minus) read = -read;
    return read;
  }

  template <int minus>
  [[gnu::always_inline]] static vector gathered(const item& a, const item& b, [[maybe_unused]] const item& c,
                                                [[maybe_unused]] const item& d) noexcept {
    if constexpr (lanes == 2)
      return vector{value < operand_form::scalar, (minus & 1) != 0 > (a), value < operand_form::scalar,
                    (minus & 2) != 0 > (b)};
    else
      return vector{value < operand_form::scalar, (minus & 1) != 0 > (a),       value < operand_form::scalar,
                    (minus & 2) != 0 > (b),       value < operand_form::scalar, (minus & 4) != 0 > (c),
                    value < operand_form::scalar, (minus & 8) != 0 > (d)};
  }

  template <int form>
  [[gnu::always_inline]] static vector all_lanes(const item& of) noexcept {
    if constexpr (form == operand_form::whole) {
      return of;
    } else {
      const Number one = value<form, false>(of);
      if constexpr (lanes == 2)
        return vector{one, one};
      else
        return vector{one, one, one, one};
    }
  }

  /// Products with 1 and −1, which compilers fuse with a sum.
  template <int minus>
  [[gnu::always_inline]] static vector with_signs(vector v) noexcept {
#if defined(__clang__) && !defined(KANEXPR_NO_FUSING)
#pragma clang fp contract(fast)
#endif
    if constexpr (minus == 0) {
      return v;
    } else if constexpr (minus == (1 << lanes) - 1) {
      return -v;
    } else {
      constexpr auto sign = [](int lane) { return static_cast<Number>((minus >> lane) % 2 == 0 ? 1 : -1); };
      if constexpr (lanes == 2)
        return v * vector{sign(0), sign(1)};
      else
        return v * vector{sign(0), sign(1), sign(2), sign(3)};
    }
  }

  template <operation op>
  [[gnu::always_inline]] static vector combined(vector a, vector b) noexcept {
#if defined(__clang__) && !defined(KANEXPR_NO_FUSING)
#pragma clang fp contract(fast)
#endif
    if constexpr (op == operation::add)
      return a + b;
    else if constexpr (op == operation::multiply)
      return a * b;
    else
      return a / b;
  }
};

} // namespace kanexpr::lower
