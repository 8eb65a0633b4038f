#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace demo {

/// Median nanoseconds of one call of `f(x)`; the state moves a little, so that no call can be taken for the
/// one before.
template <class State, class Function>
double time_of(State x, Function f) {
  constexpr int rounds = 41, calls = 2000;
  volatile double keep = 0;
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) {
      x.array() += 1e-9;
      keep = f(x).sum();
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    times.push_back(taken.count() / calls);
  }
  static_cast<void>(keep);
  std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
  return times[rounds / 2];
}

} // namespace demo
