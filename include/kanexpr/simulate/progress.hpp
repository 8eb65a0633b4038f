#pragma once

#include <kanexpr/base/equal.hpp>

#include <chrono>
#include <cstdio>

#include <unistd.h>

namespace kanexpr {

/// Shows in a terminal how far a run is and how long it will still take, ten times a second at most; in a
/// file it leaves nothing. Called with the time and the span, as the option `progress` of a simulation is:
/// `.progress = progress_bar()`.
///
/// The line ends when the time reaches the end of the span; if the bar goes away before, the line does too.
class progress_bar {
public:
  explicit progress_bar(std::FILE* out = stderr) : out_(out), is_shown_(::isatty(::fileno(out)) == 1) {}
  /// A bar for the same terminal, which has drawn nothing.
  progress_bar(const progress_bar& other) : out_(other.out_), is_shown_(other.is_shown_) {}
  progress_bar& operator=(const progress_bar&) = delete;
  ~progress_bar() { clear(); }

  void operator()(double t, double from, double to) {
    if (!is_shown_) return;
    const clock::time_point now = clock::now();
    if (!has_begun_) begin_ = now, drawn_ = now - between;
    has_begun_ = true;
    const double part = part_of(t, from, to);
    if (part < 1 && now - drawn_ < between) return;
    draw(part, std::chrono::duration<double>(now - begin_).count());
    drawn_ = now;
  }
  template <class Span>
    requires requires(const Span& span) { span.from, span.to; }
  void operator()(double t, const Span& span) {
    (*this)(t, span.from, span.to);
  }

  /// Takes the line away.
  void clear() {
    if (is_drawn_) {
      std::fputs("\r\x1b[K", out_);
      std::fflush(out_);
    }
    is_drawn_ = has_begun_ = false;
  }

private:
  using clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds between{100};
  static constexpr int width = 40;

  /// From 0 to 1; time may run backwards.
  static double part_of(double t, double from, double to) {
    if (numeric::equal(t, to)) return 1;
    const double part = (t - from) / (to - from);
    return part >= 1 ? 1 : part > 0 ? part : 0; // of what is not a number, 0
  }

  void draw(double part, double elapsed) {
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

  std::FILE* out_;
  bool is_shown_;
  bool has_begun_ = false, is_drawn_ = false; ///< in this run; since the line was last taken away
  clock::time_point begin_{}, drawn_{};
};

} // namespace kanexpr
