#pragma once

#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/lower/interpret.hpp>
#include <kanexpr/lower/regular.hpp>
#include <kanexpr/simulate/trim.hpp>
#include <kanexpr/simulate/unit_norms.hpp>

#include <vector>

namespace kanexpr::trim {

/// [norms of quaternions; constraints; ẋ] of a system at the time t and [x; p; r].
class evaluation {
public:
  using number = std::complex<double>;

  explicit evaluation(const subject& system) : of_(system), norms_(system.known) {
    if (of_.table == nullptr) return;
    slots_.resize(static_cast<std::size_t>(of_.table->tape.slot_count()));
    squares_.resize(static_cast<std::size_t>(interpretation::squares_of(of_.table->tape)));
    steps().place_numbers();
  }

  /// What could not be solved there, as a sentence.
  std::string_view operator()(double t, const number* at, number* all) {
    for (int k = 0; k < norms_.count(); ++k) *all++ = norms_.residual(k, at);
    return of_.table == nullptr ? of_.compiled(t, at, all) : interpret(t, at, all);
  }

private:
  using interpretation = lower::interpretation<lower::tape_view, number>;
  interpretation steps() { return {of_.table->tape, slots_.data(), squares_.data()}; }

  std::string_view interpret(double t, const number* at, number* all) {
    const lower::tape_view& tape = of_.table->tape;
    number* load = slots_.data() + tape.numbers.size();
    for (const lower::load& each : tape.loads) *load++ = value_of(each, t, at);
    steps().run();
    const int guards = of_.table->causes, results = tape.results.size() - 2 * guards;
    for (int i = 0; i < results; ++i) all[i] = slot_of(i);
    for (int i = 0; i < guards; ++i)
      if (!passes(slot_of(results + 2 * i), slot_of(results + 2 * i + 1),
                  of_.table->tells_finiteness && i == guards - 1))
        return of_.table->cause(i);
    return {};
  }

  const number& slot_of(int result) const {
    return slots_[static_cast<std::size_t>(of_.table->tape.results[result])];
  }

  number value_of(const lower::load& l, double t, const number* at) const {
    if (l.from == symbolic::symbol_kind::time) return t;
    return at[of_.known.first_of(l.from) + l.position];
  }

  static bool passes(const number& measure, const number& scale, bool of_finiteness) {
    constexpr double least = mechanics::least_regularity<number>();
    return of_finiteness ? lower::passes<true>(measure, scale, least)
                         : lower::passes<false>(measure, scale, least);
  }

  const subject& of_;
  simulated::unit_norms norms_;
  std::vector<number> slots_{}, squares_{};
};

} // namespace kanexpr::trim
