#pragma once

#include <kanexpr/compiled/function.hpp>

#include <utility>

namespace kanexpr::steps {

/// Returns the cost of operations outside the tape.
constexpr symbolic::cost arithmetic(int multiplications, int additions, int divisions = 0) {
  symbolic::cost c;
  c.multiplications = multiplications;
  c.additions = additions;
  c.divisions = divisions;
  c.nodes = multiplications + additions + divisions;
  return c;
}

/// A matrix among the results of compiled code. It is known at compile time which of its entries are always 0
/// or 1. Its entries are the results from index `first` on.
template <class Code, int first, int rows, int inner>
struct known_entries {
  /// Multiplies without the operations that the known entries make unnecessary.
  template <class Matrix, class Right>
  static Right product(const Matrix& left, const Right& right) {
    Right sum;
    fill(sum, left, right, std::make_integer_sequence<int, rows>{});
    return sum;
  }

  /// Returns the number of operations of a product with the given number of columns.
  static constexpr symbolic::cost cost(int columns) {
    int multiplied = 0, added = 0;
    for (int i = 0; i < rows; ++i)
      for (int k = 0; k < inner; ++k) {
        if (is(i, k, 0)) continue;
        ++added;
        if (!is(i, k, 1)) ++multiplied;
      }
    return arithmetic(columns * multiplied, columns * added);
  }

private:
  static constexpr bool is(int i, int k, int number) {
    const int slot = Code::tape.results[first + i * inner + k];
    return slot < Code::tape.sizes.numbers && Code::tape.numbers[slot] == symbolic::exactly(number);
  }

  template <class Matrix, class Right, int... index>
  static void fill(Right& sum, const Matrix& left, const Right& right, std::integer_sequence<int, index...>) {
    (fill_row<index>(sum, left, right, std::make_integer_sequence<int, inner>{}), ...);
  }
  template <int index, class Matrix, class Right, int... place>
  static void fill_row(Right& sum, const Matrix& left, const Right& right,
                       std::integer_sequence<int, place...>) {
    sum.row(index).setZero();
    (add<index, place>(sum, left, right), ...);
  }
  template <int index, int place, class Matrix, class Right>
  static void add(Right& sum, const Matrix& left, const Right& right) {
    if constexpr (is(index, place, 1))
      sum.row(index) += right.row(place);
    else if constexpr (!is(index, place, 0))
      sum.row(index) += left(index, place) * right.row(place);
  }
};

} // namespace kanexpr::steps
