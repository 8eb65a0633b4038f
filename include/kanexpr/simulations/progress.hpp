#pragma once

#include <kanexpr/simulations/compiled_simulations.hpp>

#include <cstdint>
#include <cstdio>

namespace kanexpr {

/// Shows the progress and the remaining time of a run in a terminal, at most ten times a second; writes
/// nothing if the stream is not a terminal. Called with the time and the span, like the option `progress` of
/// a simulation: `.progress = progress_bar()`.
///
/// The line is completed when the time reaches the end of the span; if the bar is destroyed earlier, the line
/// is erased.
class progress_bar {
public:
  explicit progress_bar(std::FILE* out = stderr);
  /// Creates a bar for the same terminal that has not drawn anything yet.
  progress_bar(const progress_bar& other) : out_(other.out_), is_shown_(other.is_shown_) {}
  progress_bar& operator=(const progress_bar&) = delete;
  ~progress_bar() { clear(); }

  void operator()(double t, double from, double to);
  template <class Span>
    requires requires(const Span& span) { span.from, span.to; }
  void operator()(double t, const Span& span) {
    (*this)(t, span.from, span.to);
  }

  /// Erases the line.
  void clear();

private:
  void draw(double part, double elapsed);

  std::FILE* out_;
  bool is_shown_;
  bool has_begun_ = false, is_drawn_ = false; ///< the run has begun; the line is on the screen
  std::int64_t begin_ = 0, drawn_ = 0;        ///< clock readings in nanoseconds
};

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulations/progress.ipp>
#endif
