#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <utility>

namespace kanexpr::lower {

/// How many steps one function holds. Long tapes are cut here, since compilers are slow with very large functions.
inline constexpr int steps_in_a_block = 24;
inline constexpr int blocks_inlined = 4096 / steps_in_a_block;

/// Straight-line evaluation of a tape that is a constant of the type `Code` (`Code::tape`).
///
/// Every index is a constant, so the compiler keeps the slots in registers and the array disappears.
template <class Code, class T>
class evaluation {
public:
  static constexpr const auto& tape = Code::tape;

  /// `Arguments` gives the value of each load: `arguments(load)`.
  template <class Arguments>
  [[gnu::always_inline]] explicit evaluation(const Arguments& arguments) noexcept {
    load_numbers(std::make_integer_sequence<int, tape.sizes.numbers>{});
    load_arguments(arguments, std::make_integer_sequence<int, tape.sizes.loads>{});
    run(std::make_integer_sequence<int, (tape.sizes.steps + steps_in_a_block - 1) / steps_in_a_block>{});
  }

  template <int i>
  [[gnu::always_inline]] const T& result() const noexcept {
    return slot_[tape.results[i]];
  }

private:
  static constexpr int first = tape.first_step();

  template <int... i>
  [[gnu::always_inline]] void load_numbers(std::integer_sequence<int, i...>) noexcept {
    const int order[]{0, (slot_[i] = number_as<T>(tape.numbers[i]), 0)...};
    static_cast<void>(order);
  }

  template <class Arguments, int... i>
  [[gnu::always_inline]] void load_arguments(const Arguments& arguments, std::integer_sequence<int, i...>) noexcept {
    const int order[]{0, (slot_[tape.sizes.numbers + i] =
                              arguments.template operator()<tape.loads[i].from, tape.loads[i].position>(), 0)...};
    static_cast<void>(order);
  }

  template <int... block>
  [[gnu::always_inline]] void run(std::integer_sequence<int, block...>) noexcept {
    const int order[]{0, (run_block<block>(), 0)...};
    static_cast<void>(order);
  }

  template <int block>
  [[gnu::always_inline]] void run_block() noexcept {
    constexpr int begin = block * steps_in_a_block;
    constexpr int left = tape.sizes.steps - begin;
    run_steps<begin>(std::make_integer_sequence<int, (left < steps_in_a_block ? left : steps_in_a_block)>{});
  }

  template <int begin, int... i>
  [[gnu::always_inline]] void run_steps(std::integer_sequence<int, i...>) noexcept {
    const int order[]{(step<tape.op[begin + i], tape.paired[begin + i]>(
                           slot_ + first + begin + i, slot_[tape.a[begin + i]], slot_[tape.b[begin + i]]), 0)...};
    static_cast<void>(order);
  }

  template <operation op, bool paired>
  [[gnu::always_inline]] static void step(T* slot, const T& a, const T& b) noexcept {
    if constexpr (!paired)
      *slot = apply<op>(a, b);
    else if constexpr (op == operation::sin)
      scalar_math<T>::sincos(a, slot[0], slot[1]);
  }

  T slot_[tape.slots()];
};

} // namespace kanexpr::lower
