#pragma once

#include <kanexpr/simulate/compiled_simulations.hpp>

#include <cstdint>
#include <cstdio>

namespace kanexpr {

/// Shows in a terminal how far a run is and how long it will still take, ten times a second at most; in a
/// file it leaves nothing. Called with the time and the span, as the option `progress` of a simulation is:
/// `.progress = progress_bar()`.
///
/// The line ends when the time reaches the end of the span; if the bar goes away before, the line does too.
class progress_bar {
public:
  explicit progress_bar(std::FILE* out = stderr);
  /// A bar for the same terminal, which has drawn nothing.
  progress_bar(const progress_bar& other) : out_(other.out_), is_shown_(other.is_shown_) {}
  progress_bar& operator=(const progress_bar&) = delete;
  ~progress_bar() { clear(); }

  void operator()(double t, double from, double to);
  template <class Span>
    requires requires(const Span& span) { span.from, span.to; }
  void operator()(double t, const Span& span) {
    (*this)(t, span.from, span.to);
  }

  /// Takes the line away.
  void clear();

private:
  void draw(double part, double elapsed);

  std::FILE* out_;
  bool is_shown_;
  bool has_begun_ = false, is_drawn_ = false; ///< in this run; since the line was last taken away
  std::int64_t begin_ = 0, drawn_ = 0;        ///< nanoseconds of a clock
};

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_SIMULATIONS
#include <kanexpr/simulate/engine/progress.hpp>
#endif
