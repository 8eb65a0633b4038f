#pragma once

#include "bicycle.hpp"

/// u̇ of the bicycle.
struct program : embedded::bicycle::calls {
  using system = embedded::bicycle::BoundSystem;
  using eom = kanexpr::equations_of_motion<system>;
  static constexpr std::size_t found = eom::speeds;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const embedded::arguments<system, T> at(given);
    embedded::put(found, eom::udot(at.x, at.p, at.r));
  }
};
