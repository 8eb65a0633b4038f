#pragma once

#include <kanexpr/compiled/state.hpp>

namespace kanexpr::simulated {

/// The errors that a step may leave in the entries of a state.
template <class System>
struct tolerances {
  double relative = 0;
  state<System> absolute;

  state<System> at(const state<System>& x) const { return state<System>(relative * x.cwiseAbs() + absolute); }
};

} // namespace kanexpr::simulated
