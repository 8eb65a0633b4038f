#pragma once

#include "pendulum.hpp"

/// ẋ of the pendulum.
struct program : embedded::pendulum::calls {
  using eom = kanexpr::equations_of_motion<system>;
  static constexpr std::size_t found = 2;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const embedded::arguments<system, T> at(given);
    embedded::put(found, eom::rhs(at.x, at.p, at.r));
  }
};
