// builds: clang++ sanitize
#include <kanexpr/lower/long_lists.hpp>
#include <kanexpr/lower/stored_results.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace {

using kanexpr::lower::group_length;
using kanexpr::lower::group_of_five;

constexpr int rows = 30, columns = 35, before = 7; // results before those of the matrix

/// Some entries are numbers, in the slots 0 and 1; the rest are computed.
constexpr int slot_of(int entry) { return entry % 3 == 0 ? 0 : entry % 4 == 0 ? 1 : 2 + entry; }

struct tape_of_matrix {
  struct {
    int numbers = 2;
  } sizes{};
  int results[before + rows * columns]{};

  constexpr tape_of_matrix() {
    for (int entry = 0; entry < rows * columns; ++entry) results[before + entry] = slot_of(entry);
  }
};

struct matrix_code {
  static constexpr tape_of_matrix tape{};
};

/// Stores the results in descending order.
struct evaluated {
  static constexpr int place_of_result(int result) { return before + rows * columns - 1 - result; }
};

template <bool is_row_major>
using entries = kanexpr::lower::stored_results<matrix_code, evaluated, before, rows, columns, is_row_major>;

template <bool is_row_major>
void expect_each_entry_in_its_place() {
  std::vector<double> memory(rows * columns), matrix(rows * columns, -1);
  for (int entry = 0; entry < rows * columns; ++entry)
    memory[static_cast<std::size_t>(evaluated::place_of_result(before + entry))] = 10 + entry;
  entries<is_row_major>::copy(memory.data(), matrix.data());

  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int entry = i * columns + j, position = is_row_major ? entry : j * rows + i;
      const bool is_computed = slot_of(entry) > 1;
      EXPECT_EQ(matrix[static_cast<std::size_t>(position)], is_computed ? 10 + entry : -1) << entry;
    }
  }
}

TEST(stored_results, a_matrix_without_columns_has_nothing_to_copy) {
  double memory = 1, matrix = -1;
  kanexpr::lower::stored_results<matrix_code, evaluated, before, rows, 0, false>::copy(&memory, &matrix);
  EXPECT_EQ(matrix, -1);
}

TEST(stored_results, thousands_of_entries_reach_their_places) {
  static_assert(rows * columns / 2 > group_length, "so that several functions copy them");
  expect_each_entry_in_its_place<false>();
  expect_each_entry_in_its_place<true>();
}

template <int... a, int... b, int... c, int... d, int... e>
std::vector<int> joined(kanexpr::lower::indices<a...>, kanexpr::lower::indices<b...>,
                        kanexpr::lower::indices<c...>, kanexpr::lower::indices<d...>,
                        kanexpr::lower::indices<e...>) {
  return {a..., b..., c..., d..., e...};
}

template <int count>
void expect_all_numbers() {
  const std::vector<int> all =
      joined(group_of_five<count, 0>, group_of_five<count, 1>, group_of_five<count, 2>,
             group_of_five<count, 3>, group_of_five<count, 4>);
  ASSERT_EQ(all.size(), count);
  for (int i = 0; i < count; ++i) EXPECT_EQ(all[static_cast<std::size_t>(i)], i);
}

TEST(long_lists, five_groups_contain_all_numbers_in_order) {
  expect_all_numbers<0>();
  expect_all_numbers<1>();
  expect_all_numbers<group_length>();
  expect_all_numbers<group_length + 1>();
  expect_all_numbers<3 * group_length - 1>();
  expect_all_numbers<7 * group_length>();
}

} // namespace
