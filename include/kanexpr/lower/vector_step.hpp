#pragma once

#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <type_traits>
#include <utility>

namespace kanexpr::lower {

/// Whether one vector register of the target holds the numbers of a step on vectors.
template <class Number>
inline constexpr bool has_vectors =
#if defined(__AVX__)
    std::is_same_v<Number, double> || std::is_same_v<Number, float>;
#elif defined(__SSE2__) || defined(__ARM_NEON)
    std::is_same_v<Number, float>;
#else
    false;
#endif

namespace detail {

template <class Number, bool = has_vectors<Number>>
struct vector_of {
  typedef Number type __attribute__((vector_size(lanes * sizeof(Number))));
};
template <class Number>
struct vector_of<Number, false> {
  using type = Number;
};

} // namespace detail

template <class Number>
using vector_of = typename detail::vector_of<Number>::type;

/// The source of an operand of a step on vectors.
struct vector_operand {
  enum class source : unsigned char { gathered, repeated, vector };
  source from = source::gathered;
  int index = 0; ///< the first slot, or the step on vectors
};

/// The operands of all steps on vectors of a tape.
template <class Code>
struct vector_operands {
  static constexpr const auto& tape = Code::tape;
  static constexpr std::size_t count = tape.sizes.vector_steps > 0
                                           ? static_cast<std::size_t>(tape.sizes.vector_steps)
                                           : 1;
  static constexpr std::size_t steps = tape.sizes.steps > 0 ? static_cast<std::size_t>(tape.sizes.steps) : 1;
  vector_operand a[count]{}, b[count]{};
  bool is_read_alone[steps]{}; ///< whether a step's value is needed outside of a vector

  constexpr vector_operands() {
    sequence<int> step_at(tape.slot_count(), -1);
    for (int i = 0; i < tape.sizes.vector_steps; ++i) {
      const int step = tape.vector_steps[i];
      a[i] = operand(tape.a + step, step_at);
      b[i] = operand(tape.b + step, step_at);
      step_at[tape.first_step() + step] = i;
    }
    int next = 0;
    for (int i = 0; i < tape.sizes.steps;) {
      if (next < tape.sizes.vector_steps && tape.vector_steps[next] == i) {
        if (a[next].from != vector_operand::source::vector) read(tape.a + i, lanes);
        if (b[next].from != vector_operand::source::vector) read(tape.b + i, lanes);
        i += lanes, ++next;
      } else {
        read(tape.a + i, 1), read(tape.b + i, 1);
        ++i;
      }
    }
    read(tape.results, tape.sizes.results);
  }

private:
  constexpr void read(const int* slot, int many) {
    for (int i = 0; i < many; ++i)
      if (slot[i] >= tape.first_step()) is_read_alone[slot[i] - tape.first_step()] = true;
  }
  static constexpr vector_operand operand(const int* slot, const sequence<int>& step_at) {
    bool same = true, consecutive = step_at[slot[0]] >= 0;
    for (int i = 1; i < lanes; ++i) {
      same = same && slot[i] == slot[0];
      consecutive = consecutive && slot[i] == slot[0] + i;
    }
    if (same) return {vector_operand::source::repeated, slot[0]};
    if (consecutive) return {vector_operand::source::vector, step_at[slot[0]]};
    return {vector_operand::source::gathered, slot[0]};
  }
};

template <class Code>
inline constexpr vector_operands<Code> vector_plan{};

/// Evaluates steps of several columns as one operation on vectors, with the same bits.
template <class Code, class Number>
class vector_step {
  static constexpr const auto& tape = Code::tape;
  static constexpr const vector_operands<Code>& operands = vector_plan<Code>;
  using vector = vector_of<Number>;

public:
  /// Evaluates step number `index` and copies its numbers to `out`.
  template <int index>
  [[gnu::always_inline]] static void evaluate(const Number* slot, vector* vectors, Number* out) noexcept {
    constexpr int step = tape.vector_steps[index];
    const vector a = load<operands.a[index].from, operands.a[index].index, step, false>(slot, vectors);
    if constexpr (tape.op[step] == operation::negate) {
      vectors[index] = -a;
    } else {
      const vector b = load<operands.b[index].from, operands.b[index].index, step, true>(slot, vectors);
      if constexpr (!is_uniform(step))
        vectors[index] = a + vector{sign(step), sign(step + 1), sign(step + 2), sign(step + 3)} * b;
      else if constexpr (tape.op[step] == operation::add)
        vectors[index] = a + b;
      else if constexpr (tape.op[step] == operation::subtract)
        vectors[index] = a - b;
      else if constexpr (tape.op[step] == operation::multiply)
        vectors[index] = a * b;
      else
        vectors[index] = a / b;
    }
    copy<step>(vectors[index], out, std::make_integer_sequence<int, lanes>{});
  }

private:
  template <int step, int... lane>
  [[gnu::always_inline]] static void copy(const vector& from, Number* out,
                                          std::integer_sequence<int, lane...>) noexcept {
    int next = 0;
    static_cast<void>(next);
    ((lane == 0 || operands.is_read_alone[step + lane] ? void(out[next++] = from[lane]) : void()), ...);
  }

  static consteval int slot_of(int step, bool second) { return second ? tape.b[step] : tape.a[step]; }

  /// Whether all lanes add, or all subtract, and so on.
  static consteval bool is_uniform(int step) {
    for (int i = 1; i < lanes; ++i)
      if (tape.op[step + i] != tape.op[step]) return false;
    return true;
  }
  /// The sign of the second operand; the product with it is exact.
  static consteval Number sign(int step) { return tape.op[step] == operation::add ? Number(1) : Number(-1); }

  template <vector_operand::source from, int index, int step, bool second>
  [[gnu::always_inline]] static vector load(const Number* slot, const vector* vectors) noexcept {
    if constexpr (from == vector_operand::source::repeated)
      return slot[index] - vector{}; // minus zero, so that zeros keep their sign
    else if constexpr (from == vector_operand::source::vector)
      return vectors[index];
    else
      return vector{slot[slot_of(step, second)], slot[slot_of(step + 1, second)],
                    slot[slot_of(step + 2, second)], slot[slot_of(step + 3, second)]};
  }
};

} // namespace kanexpr::lower
