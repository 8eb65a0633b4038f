#pragma once

#include "iiwa.hpp"

#include <iiwa.h>

/// u̇ of the iiwa by a call of the C that is written for it, which a compiler of C compiles.
struct program : embedded::iiwa::calls {
  static constexpr std::size_t found = iiwa_udot_rows;

  template <class T>
  static void run(const T* given, T* found) {
    constexpr std::size_t end_of_x = iiwa_states, end_of_r = end_of_x + iiwa_inputs;
    iiwa_udot(0, given, given + end_of_r, given + end_of_x, found);
  }
};
