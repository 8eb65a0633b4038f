#pragma once

#include "call.hpp"

namespace embedded {

/// A and B of a system, in its independent states, at some calls of it.
template <class Calls>
struct linearization_of : Calls {
  using system = typename Calls::system;
  using lin = kanexpr::linearization<system>;
  static constexpr std::size_t found = lin::states * (lin::states + lin::known.inputs);

  template <class T>
  [[gnu::always_inline]] static void run(const T* given, T* found) {
    const arguments<system, T> at(given);
    const auto [A, B] = lin::explicit_form(at.x, at.p, at.r);
    put(put(found, A), B);
  }
};

} // namespace embedded
