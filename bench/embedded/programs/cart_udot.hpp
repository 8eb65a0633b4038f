#pragma once

#include "cart.hpp"

/// u̇ of the pendulum on a cart.
struct program : embedded::cart::calls {
  using system = embedded::cart::system;
  using eom = kanexpr::equations_of_motion<system>;
  static constexpr std::size_t found = eom::speeds;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const embedded::arguments<system, T> at(given);
    embedded::put(found, eom::udot(at.x, at.p, at.r));
  }
};
