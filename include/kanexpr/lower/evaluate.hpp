#pragma once

#include <kanexpr/lower/eliminate.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <utility>

namespace kanexpr::lower {

/// What the steps of a tape do, as one number each, so that one function template is made for all steps that
/// do the same: an operation, or what fills several slots at once.
template <class Code>
struct step_plan {
  static constexpr const auto& tape = Code::tape;
  static constexpr int sine_and_cosine = -1, all_angles = -2, first_elimination = -3; ///< the next ones below

  static constexpr std::size_t steps = tape.sizes.steps > 0 ? static_cast<std::size_t>(tape.sizes.steps) : 1;
  int what[steps]{};
  int aside[steps]{}; ///< the place of what is filled at once, before each slot takes its own from there
  int aside_count = 0;

  constexpr step_plan() {
    for (int i = 0; i < tape.sizes.steps; ++i) {
      what[i] = static_cast<int>(tape.paired[i] ? operation::component : tape.op[i]);
      if (tape.paired[i] && tape.op[i] == operation::sin) what[i] = sine_and_cosine;
    }
    for (int i = 0; i < tape.sizes.angles; ++i)
      what[tape.sizes.first_angle + 2 * i] = i == 0 ? all_angles : static_cast<int>(operation::component);
    for (int i = 0; i < tape.sizes.eliminations; ++i) what[tape.eliminations[i].step] = first_elimination - i;
    for (int i = 0; i < tape.sizes.steps; ++i)
      if (what[i] < 0 || what[i] == static_cast<int>(operation::component)) aside[i] = aside_count++;
  }
};

/// Straight-line evaluation of a tape that is a constant of the type `Code` (`Code::tape`).
///
/// Every index is a constant and all steps stand in one function, so the compiler keeps the slots in
/// registers from the start and the array disappears.
template <class Code, class T>
class evaluation {
public:
  static constexpr const auto& tape = Code::tape;

  /// `Arguments` gives the value of each load: `arguments(load)`.
  template <class Arguments>
  [[gnu::always_inline]] explicit evaluation(const Arguments& arguments) noexcept {
    run(arguments, std::make_integer_sequence<int, tape.sizes.numbers>{},
        std::make_integer_sequence<int, tape.sizes.loads>{},
        std::make_integer_sequence<int, tape.sizes.steps>{},
        std::make_integer_sequence<int, tape.sizes.results>{});
  }

  template <int i>
  [[gnu::always_inline]] const T& result() const noexcept {
    return result_[i];
  }

private:
  static constexpr int first = tape.first_step();
  static constexpr step_plan<Code> plan{};

  /// Numbers by value: behind a reference they had to be in memory.
  using operand = std::conditional_t<std::is_arithmetic_v<T>, T, const T&>;

  template <class Arguments, int... number, int... load, int... step, int... result>
  [[gnu::always_inline]] void
  run([[maybe_unused]] const Arguments& arguments, std::integer_sequence<int, number...>,
      std::integer_sequence<int, load...>, std::integer_sequence<int, step...>,
      std::integer_sequence<int, result...>) noexcept {
    [[maybe_unused]] T aside[plan.aside_count > 0 ? plan.aside_count : 1];
    const T slot[tape.slot_count() > 0 ? tape.slot_count() : 1]{
        number_as<T>(tape.numbers[number])...,
        arguments.template operator()<tape.loads[load].from, tape.loads[load].position>()...,
        take<plan.what[step]>(slot[tape.a[step]], slot[tape.b[step]],
                              is_aside(plan.what[step]) ? aside + plan.aside[step] : nullptr,
                              plan.what[step] < 0 ? slot : nullptr)...};
    const int order[]{0, (result_[result] = slot[tape.results[result]], 0)...};
    static_cast<void>(order);
  }

  static constexpr bool is_aside(int what) {
    return what < 0 || what == static_cast<int>(operation::component);
  }

  /// The value of a slot.
  template <int what>
  [[gnu::always_inline]] static T take(operand a, [[maybe_unused]] operand b, [[maybe_unused]] T* aside,
                                       [[maybe_unused]] const T* slot) noexcept {
    using plans = step_plan<Code>;
    if constexpr (what >= 0 && what != static_cast<int>(operation::component)) {
      return apply<static_cast<operation>(what), T>(a, b);
    } else {
      if constexpr (what == plans::sine_and_cosine)
        scalar_math<T>::sincos(a, aside[0], aside[1]);
      else if constexpr (what == plans::all_angles)
        turn(aside, slot, std::make_integer_sequence<int, tape.sizes.angles>{});
      else if constexpr (what <= plans::first_elimination)
        eliminate<plans::first_elimination - what>(aside, slot);
      return *aside;
    }
  }

  /// The sines and cosines of all angles that are known first, in one call that a scalar type may replace.
  template <int... i>
  [[gnu::always_inline]] static void turn(T* aside, const T* slot, std::integer_sequence<int, i...>) noexcept {
    const T angle[]{slot[tape.a[tape.sizes.first_angle + 2 * i]]...};
    T sine[sizeof...(i)], cosine[sizeof...(i)];
    scalar_math<T>::template sincos<sizeof...(i)>(angle, sine, cosine);
    const int order[]{(aside[2 * i] = sine[i], aside[2 * i + 1] = cosine[i], 0)...};
    static_cast<void>(order);
  }

  template <int i>
  [[gnu::always_inline]] static void eliminate(T* out, const T* slot) noexcept {
    constexpr elimination e = tape.eliminations[i];
    if constexpr (e.op == operation::regularity) {
      T squares[static_cast<std::size_t>(e.inputs())];
      gather<e.operands>(squares, slot, std::make_integer_sequence<int, e.inputs()>{});
      *out = unrolled_elimination<e.order, T>::regularity(slot + e.factors, squares);
    } else {
      gather<e.operands>(out, slot, std::make_integer_sequence<int, e.inputs()>{});
      if constexpr (e.op == operation::factorization)
        unrolled_elimination<e.order, T>::factorize(out);
      else if constexpr (e.op == operation::solve)
        unrolled_elimination<e.order, T>::solve(slot + e.factors, out);
      else
        unrolled_elimination<e.order, T>::solve_transposed(slot + e.factors, out);
    }
  }

  template <int begin, int... i>
  [[gnu::always_inline]] static void gather(T* out, const T* slot, std::integer_sequence<int, i...>) noexcept {
    const int order[]{(out[i] = slot[tape.operands[begin + i]], 0)...};
    static_cast<void>(order);
  }

  T result_[tape.sizes.results > 0 ? tape.sizes.results : 1];
};

} // namespace kanexpr::lower
