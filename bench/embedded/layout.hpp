#pragma once

#include <cstdint>

/// What the board calculates with: what the compiler is told.
using scalar = BOARD_SCALAR;

extern "C" {

/// A program on a board, as a function of plain arrays.
void measured(const scalar* given, scalar* found);

/// How it is called: `given_count` numbers at each of the points, which stand one behind the other.
struct measured_calls {
  const scalar* points;
  std::uint32_t point_count, given_count, found_count;
};
extern const measured_calls calls;
}
