#pragma once

#include <kanexpr/lower/long_lists.hpp>

#include <cstddef>

namespace kanexpr::lower {

/// Copies a result of a long tape: the `rows` × `columns` entries from number `first` of the results of the
/// tape of `Code`, row by row. `Evaluated` is the evaluation of the tape, which has the place of each entry.
///
/// Several functions copy them, because compilers take long for thousands of assignments in one function. A
/// loop would take a seventh more of the time of a call.
template <class Code, class Evaluated, int first, int rows, int columns, bool is_row_major>
class stored_results {
  static constexpr const auto& tape = Code::tape;
  static constexpr std::size_t room = static_cast<std::size_t>(rows * columns) + 1;

  struct computed_entries {
    int count = 0;
    int to[room]{}, from[room]{}; ///< positions in the matrix and in memory

    constexpr computed_entries() {
      for (int i = 0, entry = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j, ++entry) {
          if (tape.results[first + entry] < tape.sizes.numbers) continue;
          to[count] = is_row_major ? entry : j * rows + i;
          from[count++] = Evaluated::place_of_result(first + entry);
        }
      }
    }
  };
  static constexpr computed_entries computed{};

  static constexpr int least(int a, int b) { return a < b ? a : b; }
  static consteval int to(int index) { return computed.to[index]; }
  static consteval int from(int index) { return computed.from[index]; }

  template <int begin, class Number, int... index>
  [[gnu::noinline]] static void copy_from(const Number* memory, Number* matrix, indices<index...>) noexcept {
    const int order[]{(matrix[to(begin + index)] = memory[from(begin + index)], 0)...};
    static_cast<void>(order);
  }
  template <class Number, int... part>
  [[gnu::always_inline]] static void copy_parts([[maybe_unused]] const Number* memory,
                                                [[maybe_unused]] Number* matrix, indices<part...>) noexcept {
    (copy_from<part * group_length>(memory, matrix,
                                    up_to<least(group_length, computed.count - part * group_length)>),
     ...);
  }

public:
  /// Copies the entries that are computed; the others are numbers, which are not in memory.
  template <class Number>
  [[gnu::always_inline]] static void copy(const Number* memory, Number* matrix) noexcept {
    copy_parts(memory, matrix, up_to<(computed.count + group_length - 1) / group_length>);
  }
};

} // namespace kanexpr::lower
