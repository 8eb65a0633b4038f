#pragma once

#include <kanexpr/lower/long_lists.hpp>

#include <cstddef>
#include <utility>

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

  static constexpr bool is_computed(int entry) { return tape.results[first + entry] >= tape.sizes.numbers; }

  struct computed_entries {
    int count = 0;
    int to[room]{}, from[room]{}; ///< positions in the matrix and in memory

    constexpr computed_entries() {
      for (int entry = 0; entry < rows * columns; ++entry) {
        if (!is_computed(entry)) continue;
        to[count] = is_row_major ? entry : entry % columns * rows + entry / columns;
        from[count++] = Evaluated::place_of_result(first + entry);
      }
    }
  };
  static constexpr computed_entries computed{};

  struct number_entries {
    int count = 0;
    int entry[room]{};

    constexpr number_entries() {
      for (int each = 0; each < rows * columns; ++each)
        if (!is_computed(each) && !tape.numbers[tape.results[first + each]].is_zero()) entry[count++] = each;
    }
  };
  static constexpr number_entries given{};

  template <class>
  struct list;
  template <int... index>
  struct list<std::integer_sequence<int, index...>> {
    using type = std::integer_sequence<int, given.entry[index]...>;
  };

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
  /// The entries that are numbers other than zero, which are not in memory.
  using numbers = typename list<std::make_integer_sequence<int, given.count>>::type;

  /// Copies the entries that are computed.
  template <class Number>
  [[gnu::always_inline]] static void copy(const Number* memory, Number* matrix) noexcept {
    copy_parts(memory, matrix, up_to<(computed.count + group_length - 1) / group_length>);
  }
};

} // namespace kanexpr::lower
