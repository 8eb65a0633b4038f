#pragma once

#include "call.hpp"

namespace embedded {

/// u̇ of a system, at some calls of it.
template <class Calls>
struct udot_of : Calls {
  using system = typename Calls::system;
  using eom = kanexpr::equations_of_motion<system>;
  static constexpr std::size_t found = eom::speeds;

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const arguments<system, T> at(given);
    put(found, eom::udot(at.x, at.p, at.r));
  }
};

} // namespace embedded
