#pragma once

#include <cstddef>
#include <utility>

/// Long lists while code is unrolled. For each array, and for each list of template arguments, that takes
/// more than a page of memory, g++ searches the list of its free pages, of which there are several hundred
/// thousand after a large model has been derived.
namespace kanexpr::lower {

/// The length of the rows into which arrays are divided.
inline constexpr int row_length = 128;

/// The number of rows for so many elements, at least one.
constexpr std::size_t rows_for(int elements) {
  return elements > row_length ? static_cast<std::size_t>((elements + row_length - 1) / row_length) : 1;
}

/// Numbers as template arguments. Only a null pointer is passed, because compilers would otherwise form a
/// class of that many arguments.
template <int... index>
using indices = const std::integer_sequence<int, index...>*;

/// The numbers from 0 to count − 1.
template <int count>
inline constexpr const std::make_integer_sequence<int, count>* up_to = nullptr;

namespace detail {
template <int begin, class Numbers>
struct shifted;
template <int begin, int... index>
struct shifted<begin, std::integer_sequence<int, index...>> {
  using type = indices<(begin + index)...>;
};
} // namespace detail

/// A list of template arguments takes at most a page if it is divided into groups of this length.
inline constexpr int group_length = 480;

/// Group `group` of the numbers from 0 to count − 1; of five groups, the last one contains the rest.
template <int count, int group>
inline constexpr auto group_of_five = [] {
  constexpr int begin = count < group * group_length ? count : group * group_length,
                end = count < begin + group_length || group == 4 ? count : begin + group_length;
  return typename detail::shifted<begin, std::make_integer_sequence<int, end - begin>>::type{nullptr};
}();

} // namespace kanexpr::lower
