#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/column_steps.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>

#include <cstddef>
#include <type_traits>

namespace kanexpr::lower {

/// The size of the widest register of the target, in bytes, and the number of columns that the rows of a
/// solution have room for, a multiple of the lanes of all vectors.
#if defined(__AVX512F__)
inline constexpr int bytes_of_register = 64, columns_in_step = 8;
#elif defined(__AVX__)
inline constexpr int bytes_of_register = 32, columns_in_step = 8;
#elif defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int bytes_of_register = 16, columns_in_step = 4;
#else
inline constexpr int bytes_of_register = 0, columns_in_step = 1;
#endif

/// The number of columns that are solved as one vector.
template <class Number>
consteval int lanes_for_columns() {
  constexpr bool has_vectors = std::is_same_v<Number, float> ||
#if defined(__ARM_NEON) && !defined(__aarch64__)
                               false;
#else
                               std::is_same_v<Number, double>;
#endif
  if constexpr (!has_vectors || bytes_of_register == 0) return 1;
  constexpr int most = bytes_of_register / static_cast<int>(sizeof(Number));
  return most < columns_in_step ? most : columns_in_step;
}

/// The distance of rows with so many columns.
constexpr int stride_for(int columns) {
  return (columns + columns_in_step - 1) / columns_in_step * columns_in_step;
}

/// Several numbers as one value, in registers and at any place in memory; a single number is itself.
template <class Number, int count>
struct number_vector {
  typedef Number type __attribute__((vector_size(count * sizeof(Number))));
  typedef Number in_memory
      __attribute__((vector_size(count * sizeof(Number)), aligned(alignof(Number)), may_alias));
};
template <class Number>
struct number_vector<Number, 1> {
  using type = Number;
  using in_memory = Number;
};

/// The steps of a symmetric system, the linear step `index` of the tape of `Code`, as arrays that outlive
/// constant evaluation. Factors are slots.
template <class Code, int index>
class column_plan {
  static constexpr const auto& tape = Code::tape;
  static constexpr linear_step system = tape.linear_steps[index];
  static constexpr int factors = numeric::symmetric_factors{system.order}.size();

  struct arrays {
    numeric::column_step steps[static_cast<std::size_t>(system.order * system.order)]{};
    int count = 0;
    bool is_given[static_cast<std::size_t>(system.order)]{}; ///< whether a row of B differs from zero
    /// Whether a step is the first one that needs the row `to`, or `from`, of B, and whether it completes a
    /// row of X.
    bool loads_to[static_cast<std::size_t>(system.order * system.order)]{},
        loads_from[static_cast<std::size_t>(system.order * system.order)]{},
        completes[static_cast<std::size_t>(system.order * system.order)]{};

    constexpr arrays() {
      const numeric::column_steps all = column_steps_of(tape_view(tape), system);
      for (const numeric::column_step& s : all.all) {
        steps[count] = s;
        steps[count++].factor = tape.operands[system.operands + s.factor];
      }
      bool is_loaded[static_cast<std::size_t>(system.order)]{},
          is_complete[static_cast<std::size_t>(system.order)]{};
      for (int i = 0; i < count; ++i) {
        const numeric::column_step s = steps[i];
        loads_from[i] = !is_loaded[s.from];
        is_loaded[s.from] = true;
        loads_to[i] = !is_loaded[s.to] && !s.fills;
        is_loaded[s.to] = true;
      }
      for (int i = count - 1; i >= 0; --i) {
        completes[i] = !is_complete[steps[i].to];
        is_complete[steps[i].to] = true;
      }
      const int zero = slot_of_zero(tape_view(tape));
      for (int i = 0; i < system.order * system.factors; ++i)
        if (tape.operands[system.operands + factors + i] != zero) is_given[i / system.factors] = true;
    }
  };

public:
  static constexpr arrays value{};
  static constexpr int order = system.order, columns = system.factors, count = value.count,
                       right = system.operands + factors;
};

/// Solves a symmetric system for all columns, several columns at a time as one vector. Each column takes the
/// operations of `numeric::solve_column`.
///
/// B and X have the same place in memory, where the rows are `stride_for(columns)` numbers apart. `Places`
/// has the places of all slots, `of(slot)`, and that of B, `columns(index)`.
template <class Code, int index, class Number, class Places>
class vector_columns {
  using plan = column_plan<Code, index>;
  static constexpr int at_once = lanes_for_columns<Number>(), stride = stride_for(plan::columns),
                       columns_taken = (plan::columns + at_once - 1) / at_once * at_once,
                       first = Places::columns(index);
  using vector = typename number_vector<Number, at_once>::type;
  using vector_in_memory = typename number_vector<Number, at_once>::in_memory;

public:
  [[gnu::noinline]] static void run(Number* memory) noexcept {
    complete(memory, up_to<plan::order * columns_taken>);
    constexpr int pair = 2 * at_once, in_pairs = columns_taken / pair * pair;
    for (int column = 0; column < in_pairs; column += pair)
      solve<2>(memory, memory + first + column, up_to<plan::count>);
    if constexpr (in_pairs != columns_taken) solve<1>(memory, memory + first + in_pairs, up_to<plan::count>);
  }

private:
  /// Entries of B that are already in place.
  static constexpr int none = -1;
  static constexpr int zero = slot_of_zero(tape_view(Code::tape));
  /// The slot from which an entry of B must be copied; none if it is in place or in a row of zeros.
  static consteval int copied_from(int entry) {
    const int row = entry / columns_taken, column = entry % columns_taken;
    if (!plan::value.is_given[row]) return none;
    const int slot = column < plan::columns ? Code::tape.operands[plan::right + row * plan::columns + column]
                     : zero >= 0            ? zero
                                            : 0; // any number: the columns behind the last one are not used
    return slot >= Code::tape.sizes.numbers && Places::of(slot) == place(entry) ? none : slot;
  }
  static consteval int place(int entry) {
    return first + entry / columns_taken * stride + entry % columns_taken;
  }

  template <int... entry>
  [[gnu::always_inline]] static void complete([[maybe_unused]] Number* memory, indices<entry...>) noexcept {
    const int order[]{(copy<copied_from(entry)>(memory, memory + place(entry)), 0)...};
    static_cast<void>(order);
  }
  template <int slot>
  [[gnu::always_inline]] static void copy([[maybe_unused]] const Number* memory,
                                          [[maybe_unused]] Number* to) noexcept {
    if constexpr (slot != none) *to = value_of<slot>(memory);
  }
  template <int slot>
  [[gnu::always_inline]] static Number value_of([[maybe_unused]] const Number* memory) noexcept {
    if constexpr (slot < Code::tape.sizes.numbers)
      return number_as<Number>(Code::tape.numbers[slot]);
    else
      return memory[Places::of(slot)];
  }

  /// Solves for one vector of columns or, to hide the latency of operations, for two.
  template <int vectors, int... step>
  [[gnu::always_inline]] static void solve(const Number* memory, Number* x, indices<step...>) noexcept {
    vector rows[static_cast<std::size_t>(vectors * plan::order)];
    const int order[]{(take<vectors, step>(memory, x, rows), 0)...};
    static_cast<void>(order);
  }
  template <int vectors, int step>
  [[gnu::always_inline]] static void take(const Number* memory, Number* x, vector* rows) noexcept {
    const Number factor = value_of<plan::value.steps[step].factor>(memory);
    take_one<step>(factor, x, rows);
    if constexpr (vectors == 2) take_one<step>(factor, x + at_once, rows + plan::order);
  }
  /// Reads a row when it is first needed and stores it when it is complete, so that it occupies a register
  /// between only.
  template <int step>
  [[gnu::always_inline]] static void take_one(Number factor, Number* x, vector* rows) noexcept {
#if defined(__clang__) && !defined(KANEXPR_NO_FUSING)
#pragma clang fp contract(fast)
#endif
    constexpr numeric::column_step s = plan::value.steps[step];
    if constexpr (plan::value.loads_from[step]) rows[s.from] = *in_memory<s.from>(x);
    if constexpr (plan::value.loads_to[step]) rows[s.to] = *in_memory<s.to>(x);
    if constexpr (s.is_pivot())
      rows[s.to] = vector(rows[s.from] * factor);
    else if constexpr (s.fills)
      rows[s.to] = vector(-vector(factor * rows[s.from]));
    else
      rows[s.to] = vector(rows[s.to] - vector(factor * rows[s.from]));
    if constexpr (plan::value.completes[step]) *in_memory<s.to>(x) = rows[s.to];
  }
  template <int row>
  [[gnu::always_inline]] static vector_in_memory* in_memory(Number* x) noexcept {
    return reinterpret_cast<vector_in_memory*>(x + row * stride);
  }
};

} // namespace kanexpr::lower
