// A study without a model, whose results are known.
#pragma once

#include <kanexpr/ensembles/ensemble_options.hpp>
#include <kanexpr/ensembles/ensemble_results.hpp>
#include <kanexpr/ensembles/run_on_threads.hpp>
#include <kanexpr/ensembles/study_interface.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace written {

/// Every seventh run fails; the others have two outputs and, if these are kept, samples and events.
class study final : public kanexpr::ensembles::study_interface {
public:
  explicit study(std::size_t runs, bool keeps_all = true) {
    layout_.study = "a known study";
    layout_.runs = runs;
    layout_.varied = 1;
    layout_.constants = {{{"m", "kg"}, 2.5}, {{"g\""}, -9.81}};
    layout_.columns = {{"run"},         {"end"},      {"t_end", "s"},
                       {"push", "N s"}, {"q", "rad"}, {"u/ω \"fast\"", "°/s"}};
    layout_.state = {{"q", "rad"}, {"run"}}; // a coordinate named "run"
    if (!keeps_all) return;
    layout_.samples = {{"t", "s"}, {"q", "rad"}, {"run"}};
    layout_.events = {"falls over", "touches/ground, \"hard\" ü"};
  }

  static bool fails(std::size_t run) { return run % 7 == 3; }
  static double pushed(std::size_t run) { return 0.25 * static_cast<double>(run); }
  static std::string cause(std::size_t run) {
    return run == 10 ? "is long: " + std::string(501, 'x') + "€€" : "run " + std::to_string(run) + " fell";
  }
  static std::size_t samples(std::size_t run) { return run % 5; }

  const kanexpr::study_layout& layout() const override { return layout_; }
  std::string identity() const override { return "known"; }
  std::size_t lanes() const override { return 1; }
  std::vector<kanexpr::finished_run> run(std::size_t first, std::size_t count) const override {
    std::vector<kanexpr::finished_run> all;
    for (std::size_t i = first; i < first + count; ++i) all.push_back(one(i));
    return all;
  }

  kanexpr::finished_run one(std::size_t i) const {
    const double missing = std::numeric_limits<double>::quiet_NaN(), push = pushed(i);
    kanexpr::finished_run done;
    done.run = i;
    done.time = 10 + push;
    done.values = {static_cast<double>(i), 0, done.time, push, std::sin(push), std::cos(push)};
    if (fails(i)) {
      done.end = kanexpr::run_end::failed;
      done.values[1] = 2, done.values[4] = done.values[5] = missing;
      done.failure = cause(i);
      if (i != 3) done.state = {push, -push};
    }
    for (std::size_t k = 0; k < samples(i) && !layout_.samples.empty(); ++k)
      done.samples.insert(done.samples.end(), {static_cast<double>(k), push, 0.5 * push});
    if (!layout_.events.empty() && i % 3 == 0)
      done.events = {{1, 0.5 + push}, {static_cast<std::uint32_t>(i % 2), 0.75 + push}};
    return done;
  }

private:
  kanexpr::study_layout layout_{};
};

inline kanexpr::ensemble_results run(const study& known, const kanexpr::ensemble_options& options) {
  return kanexpr::ensembles::run_on_threads(known, options);
}

} // namespace written
