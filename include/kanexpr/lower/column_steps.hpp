#pragma once

#include <kanexpr/lower/instruction.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>

namespace kanexpr::lower {

/// The slot of the number zero; -1 if a tape has none.
template <class Code>
constexpr int slot_of_zero(const Code& code) {
  for (int i = 0; i < code.numbers.size(); ++i)
    if (code.numbers[i].is_zero()) return i;
  return -1;
}

/// The steps of a symmetric system for each column.
template <class Code>
constexpr numeric::column_steps column_steps_of(const Code& code, const linear_step& e) {
  const int zero = slot_of_zero(code), columns = e.factors,
            right = e.operands + numeric::symmetric_factors{e.order}.size();
  return {e.order, [&](int factor) { return code.operands[e.operands + factor] == zero; },
          [&](int row) {
            for (int j = 0; j < columns; ++j)
              if (code.operands[right + row * columns + j] != zero) return false;
            return true;
          }};
}

} // namespace kanexpr::lower
