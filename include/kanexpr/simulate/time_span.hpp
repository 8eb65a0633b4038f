#pragma once

namespace kanexpr {

/// From a time to a later one, in seconds.
struct time_span {
  double from = 0;
  double to = 0;
};

} // namespace kanexpr
