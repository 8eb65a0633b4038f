#pragma once

namespace kanexpr {

/// A time span, in seconds.
struct time_span {
  double from = 0;
  double to = 0;
};

} // namespace kanexpr
