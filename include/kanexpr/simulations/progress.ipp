#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/simulations/progress.hpp>

#include <chrono>

#include <unistd.h>

namespace kanexpr {

namespace simulations {

inline std::int64_t nanoseconds_now() {
  using std::chrono::nanoseconds;
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<nanoseconds>(now).count();
}

/// Returns the fraction of a span that has passed, from 0 to 1; time may run backward.
inline double part_of(double t, double from, double to) {
  if (base::equal(t, to)) return 1;
  const double part = (t - from) / (to - from);
  return part >= 1 ? 1 : part > 0 ? part : 0; // 0 for NaN
}

} // namespace simulations

KANEXPR_SIMULATIONS progress_bar::progress_bar(std::FILE* out)
    : out_(out), is_shown_(::isatty(::fileno(out)) == 1) {}

KANEXPR_SIMULATIONS void progress_bar::operator()(double t, double from, double to) {
  if (!is_shown_) return;
  constexpr std::int64_t interval = 100'000'000;
  const std::int64_t now = simulations::nanoseconds_now();
  if (!has_begun_) begin_ = now, drawn_ = now - interval;
  has_begun_ = true;
  const double part = simulations::part_of(t, from, to);
  if (part < 1 && now - drawn_ < interval) return;
  draw(part, 1e-9 * static_cast<double>(now - begin_));
  drawn_ = now;
}

KANEXPR_SIMULATIONS void progress_bar::clear() {
  if (is_drawn_) {
    std::fputs("\r\x1b[K", out_);
    std::fflush(out_);
  }
  is_drawn_ = has_begun_ = false;
}

KANEXPR_SIMULATIONS void progress_bar::draw(double part, double elapsed) {
  constexpr int width = 40;
  const int done = static_cast<int>(part * width);
  std::fprintf(out_, "\r[%.*s%.*s] %3d %%", done, "########################################", width - done,
               "........................................", static_cast<int>(part * 100));
  if (part >= 1)
    std::fprintf(out_, ", %.1f s\x1b[K\n", elapsed);
  else if (part > 0)
    std::fprintf(out_, ", %.0f s left\x1b[K", elapsed * (1 - part) / part);
  else
    std::fputs("\x1b[K", out_);
  std::fflush(out_);
  is_drawn_ = has_begun_ = part < 1;
}

} // namespace kanexpr
