#pragma once

#include <kanexpr/mpi/mpi_options.hpp>

#include <algorithm>
#include <chrono>

namespace kanexpr::mpi {

using clock = std::chrono::steady_clock;

inline double seconds_since(clock::time_point then) {
  return std::chrono::duration<double>(clock::now() - then).count();
}

/// How often a rank says that it lives.
inline double seconds_of_sign(const mpi_options& options) { return (std::min)(1.0, options.silence / 8); }

/// How long to sleep where nothing has happened: the longer, the longer nothing has.
class nap {
public:
  std::chrono::microseconds next() { return length_ = (std::min)(2 * length_, longest); }
  void reset() { length_ = shortest; }

private:
  static constexpr std::chrono::microseconds shortest{25}, longest{1000};
  std::chrono::microseconds length_ = shortest;
};

} // namespace kanexpr::mpi
