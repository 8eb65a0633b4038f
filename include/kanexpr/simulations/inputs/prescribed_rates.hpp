#pragma once

#include <kanexpr/base/digits.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/inputs/has_prescribed_rates.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Checks that the rates of prescribed quantities are consistent with the quantities.
namespace kanexpr::simulations {

/// Evaluates the inputs at a time; returns whether that succeeded.
using inputs_at_times = std::function<bool(double t, double* r)>;

/// The indices of a prescribed quantity and of its rate among the inputs.
struct rate_pair {
  int value, rate;
  std::string name; ///< name of the value: "theta", or "dot(theta)"
};

inline std::vector<rate_pair> prescribed_rates(const derivation::survey& known) {
  std::vector<rate_pair> all;
  const auto* const names = known.names + known.first_of(symbolic::symbol_kind::input);
  for (int i = 0; i < known.inputs; ++i) {
    base::name of_rate = names[i];
    of_rate.append("'");
    const auto* const found = std::find(names, names + known.inputs, of_rate);
    if (found == names + known.inputs) continue;
    std::string name(names[i].view());
    while (name.ends_with('\'')) {
      name.pop_back();
      name.insert(0, "dot(").append(")");
    }
    all.push_back({i, static_cast<int>(found - names), std::move(name)});
  }
  return all;
}

/// Returns a message about a nonzero rate among constant inputs.
inline std::string contradiction_in_constants(const derivation::survey& known, const double* r) {
  if (!has_prescribed_rates(known)) return {};
  for (const rate_pair& each : prescribed_rates(known))
    if (std::abs(r[each.rate]) > 0)
      return "prescribed quantity " + each.name + " is constant, but its rate is given as " +
             base::digits(r[each.rate]);
  return {};
}

/// Compares the rates that a function returns with difference quotients of the quantities near the start,
/// within the span and near its end. Values that jump, are piecewise constant or are noisy are skipped; at a
/// corner, the rate may be that of either side.
class rate_checker {
public:
  rate_checker(const derivation::survey& known, const time_span& span, inputs_at_times give)
      : known_(known), span_(span), give_(std::move(give)), length_(span.to - span.from) {}

  /// Returns a contradiction, as a sentence; `depends` returns whether a quantity or its rate changes with
  /// the state.
  template <class Depends>
  std::string find(const Depends& depends) const {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const double latest = (std::max)(std::abs(span_.from), std::abs(span_.to));
    // not a round fraction of the span, which may be a period
    const double h = (std::max)(1.37e-8 * length_, 1e5 * eps * latest);
    if (!(length_ > 0) || h > 1e-4 * length_) return {};
    std::vector<window> windows;
    for (const double part : {0.001, 0.4, 0.999})
      if (window one{span_.from + part * length_, h, {}}; evaluate(one)) windows.push_back(std::move(one));
    for (const rate_pair& each : prescribed_rates(known_)) {
      double scale = 0;
      for (const window& one : windows)
        scale =
            (std::max)({scale, std::abs(one.at(2, each.rate)), std::abs(one.difference(1, 3, each.value))});
      for (const window& one : windows)
        if (contradicts(one, each, scale, windows) && !agrees_on_the_whole(one.t, each, scale) &&
            !depends(one.t, each))
          return "prescribed quantity " + each.name + " changes at the rate " +
                 base::digits(one.difference(1, 3, each.value)) + " at t = " + base::digits(one.t) +
                 ", but its rate is given as " + base::digits(one.at(2, each.rate));
    }
    return {};
  }

private:
  /// The inputs at five times, h apart.
  struct window {
    double t, h;
    std::vector<double> r[5];

    double at(int k, int input) const { return r[k][static_cast<std::size_t>(input)]; }
    double time(int k) const { return t + (k - 2) * h; }
    double difference(int from, int to, int input) const {
      return (at(to, input) - at(from, input)) / (time(to) - time(from));
    }
  };

  bool evaluate(window& one) const {
    for (int k = 0; k < 5; ++k)
      if (!evaluate(one.time(k), one.r[k])) return false;
    return true;
  }
  bool evaluate(double t, std::vector<double>& r) const {
    r.resize(static_cast<std::size_t>(known_.inputs));
    return give_(t, r.data()) && std::ranges::all_of(r, [](double each) { return numeric::is_finite(each); });
  }

  static bool contradicts(const window& one, const rate_pair& of, double scale,
                          const std::vector<window>& windows) {
    const auto differs = [&](double value) { return std::abs(value - one.at(2, of.value)) > 0; };
    double largest = 0;
    bool is_constant = true;
    for (int k = 0; k < 5; ++k) {
      largest = (std::max)(largest, std::abs(one.at(k, of.value)));
      is_constant = is_constant && !differs(one.at(k, of.value));
    }
    if (is_constant && // piecewise
        std::ranges::any_of(windows, [&](const window& other) { return differs(other.at(2, of.value)); }))
      return false;
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * largest / one.h,
                 tolerance = 1e-4 * scale + rounding, given = one.at(2, of.rate);
    const double narrow = one.difference(1, 3, of.value), wider = one.difference(0, 4, of.value);
    if (!(std::abs(narrow - wider) < tolerance / 4)) return false;
    for (const double each : {narrow, one.difference(1, 2, of.value), one.difference(2, 3, of.value)})
      if (std::abs(given - each) <= tolerance) return false;
    return true;
  }

  /// Whether values and rates agree over a longer interval: in a table, each is interpolated separately, and
  /// they agree only over several rows.
  bool agrees_on_the_whole(double t, const rate_pair& of, double scale) const {
    constexpr int parts = 64;
    constexpr double tolerance = 0.05;
    const double from = (std::max)(span_.from, t - 0.05 * length_),
                 to = (std::min)(span_.to, t + 0.05 * length_);
    double integral = 0, first = 0, last = 0;
    std::vector<double> r;
    for (int i = 0; i <= parts; ++i) { // by the trapezoidal rule
      if (!evaluate(i < parts ? from + (to - from) * i / parts : to, r)) return true;
      last = r[static_cast<std::size_t>(of.value)];
      if (i == 0) first = last;
      integral +=
          r[static_cast<std::size_t>(of.rate)] * (i == 0 || i == parts ? 0.5 : 1) * (to - from) / parts;
    }
    return std::abs(last - first - integral) <= tolerance * scale * (to - from);
  }

  const derivation::survey& known_;
  const time_span span_;
  const inputs_at_times give_;
  const double length_;
};

/// Returns the first contradiction in a function of time and state, where `give(t, x, r)` may throw.
template <class Give>
std::string contradiction_in_function(const derivation::survey& known, const time_span& span, const double* x,
                                      const Give& give) {
  const std::vector<double> first(x, x + known.coordinates + known.speeds);
  const auto given = [&](double t, const std::vector<double>& at, double* r) {
    try {
      give(t, at.data(), r);
      return true;
    } catch (...) { // the simulation reports this when it reaches this time
      return false;
    }
  };
  const auto depends = [&](double t, const rate_pair& of) {
    std::vector<double> other = first, r(static_cast<std::size_t>(known.inputs)), changed = r;
    for (double& each : other) each += 1e-3 * (1 + std::abs(each));
    if (!given(t, first, r.data()) || !given(t, other, changed.data())) return true;
    const auto value = static_cast<std::size_t>(of.value), rate = static_cast<std::size_t>(of.rate);
    return std::abs(r[value] - changed[value]) > 0 || std::abs(r[rate] - changed[rate]) > 0;
  };
  return rate_checker(known, span, [&](double t, double* r) { return given(t, first, r); }).find(depends);
}

} // namespace kanexpr::simulations
