#pragma once

#include "iiwa.hpp"

/// A and B of the iiwa, in its independent states.
struct program : embedded::iiwa::calls {
  using system = embedded::iiwa::System;
  using lin = kanexpr::linearization<system>;
  static constexpr std::size_t found = lin::states * (lin::states + lin::known.inputs);

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const embedded::arguments<system, T> at(given);
    const auto [A, B] = lin::explicit_form(at.x, at.p, at.r);
    embedded::put(embedded::put(found, A), B);
  }
};
