#pragma once

#include <kanexpr/lower/eliminate.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <utility>

namespace kanexpr::lower {

/// How many steps one function template holds: fewer cost more instantiations, more cost longer ones.
inline constexpr int steps_in_a_block = 24;

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
    run<0, tape.sizes.first_angle>();
    turn(std::make_integer_sequence<int, tape.sizes.angles>{});
    run_rest(std::make_integer_sequence<int, tape.sizes.eliminations>{});
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
  [[gnu::always_inline]] void load_arguments(const Arguments& arguments,
                                             std::integer_sequence<int, i...>) noexcept {
    const int order[] {
      0,
      (slot_[tape.sizes.numbers + i] =
           arguments.template operator()<tape.loads[i].from, tape.loads[i].position>(),
       0)...
    };
    static_cast<void>(order);
  }

  /// The sines and cosines of all angles that are known first, in one call that a scalar type may replace.
  template <int... i>
  [[gnu::always_inline]] void turn(std::integer_sequence<int, i...>) noexcept {
    if constexpr (sizeof...(i) != 0) {
      const T angle[]{slot_[tape.a[tape.sizes.first_angle + 2 * i]]...};
      T sine[sizeof...(i)], cosine[sizeof...(i)];
      scalar_math<T>::template sincos<sizeof...(i)>(angle, sine, cosine);
      const int order[]{(slot_[first + tape.sizes.first_angle + 2 * i] = sine[i],
                         slot_[first + tape.sizes.first_angle + 2 * i + 1] = cosine[i], 0)...};
      static_cast<void>(order);
    }
  }

  /// The steps after the angles, with the eliminations between them.
  template <int... i>
  [[gnu::always_inline]] void run_rest(std::integer_sequence<int, i...>) noexcept {
    const int order[]{0, (run<end_of(i - 1), tape.eliminations[i].step>(), eliminate<i>(), 0)...};
    static_cast<void>(order);
    run<end_of(static_cast<int>(sizeof...(i)) - 1), tape.sizes.steps>();
  }
  static constexpr int end_of(int i) {
    if (i < 0) return tape.sizes.first_angle + 2 * tape.sizes.angles;
    return tape.eliminations[i].step + tape.eliminations[i].outputs();
  }

  template <int i>
  [[gnu::always_inline]] void eliminate() noexcept {
    constexpr elimination e = tape.eliminations[i];
    T* const out = slot_ + first + e.step;
    if constexpr (e.op == operation::regularity) {
      T squares[static_cast<std::size_t>(e.inputs())];
      gather<e.operands>(squares, std::make_integer_sequence<int, e.inputs()>{});
      *out = unrolled_elimination<e.order, T>::regularity(slot_ + e.factors, squares);
    } else {
      gather<e.operands>(out, std::make_integer_sequence<int, e.inputs()>{});
      if constexpr (e.op == operation::factorization)
        unrolled_elimination<e.order, T>::factorize(out);
      else if constexpr (e.op == operation::solve)
        unrolled_elimination<e.order, T>::solve(slot_ + e.factors, out);
      else
        unrolled_elimination<e.order, T>::solve_transposed(slot_ + e.factors, out);
    }
  }

  template <int begin, int... i>
  [[gnu::always_inline]] void gather(T* out, std::integer_sequence<int, i...>) noexcept {
    const int order[]{(out[i] = slot_[tape.operands[begin + i]], 0)...};
    static_cast<void>(order);
  }

  template <int begin, int end>
  [[gnu::always_inline]] void run() noexcept {
    run_blocks<begin, end>(
        std::make_integer_sequence<int, (end - begin + steps_in_a_block - 1) / steps_in_a_block>{});
  }

  template <int begin, int end, int... block>
  [[gnu::always_inline]] void run_blocks(std::integer_sequence<int, block...>) noexcept {
    const int order[]{0, (run_block<begin + block * steps_in_a_block, end>(), 0)...};
    static_cast<void>(order);
  }

  template <int begin, int end>
  [[gnu::always_inline]] void run_block() noexcept {
    constexpr int left = end - begin;
    run_steps<begin>(std::make_integer_sequence<int, (left < steps_in_a_block ? left : steps_in_a_block)>{});
  }

  template <int begin, int... i>
  [[gnu::always_inline]] void run_steps(std::integer_sequence<int, i...>) noexcept {
    const int order[]{(step<tape.op[begin + i], tape.paired[begin + i]>(
                           slot_ + first + begin + i, slot_[tape.a[begin + i]], slot_[tape.b[begin + i]]),
                       0)...};
    static_cast<void>(order);
  }

  template <operation op, bool paired>
  [[gnu::always_inline]] static void step(T* slot, const T& a, const T& b) noexcept {
    if constexpr (!paired)
      *slot = apply<op>(a, b);
    else if constexpr (op == operation::sin)
      scalar_math<T>::sincos(a, slot[0], slot[1]);
  }

  T slot_[tape.slot_count() > 0 ? tape.slot_count() : 1];
};

} // namespace kanexpr::lower
