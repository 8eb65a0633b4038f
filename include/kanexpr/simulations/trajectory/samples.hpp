#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/name_of_time.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/derivation/unit_labels.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/tables/table.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace kanexpr {

/// The state and the inputs at a time.
template <class System>
struct sample {
  double t;
  state<System> x;
  input_values<System> r;
};

/// Energies along a trajectory.
struct energies {
  std::vector<double> kinetic, potential, total;
};

namespace simulations {

/// A polynomial in time for each entry of a state, over one step: Σ coefficients(k) (t − end)^k.
struct piece {
  double begin, end;
  std::vector<double> coefficients; ///< grouped by power

  void evaluate(double t, double* out, std::size_t entries) const {
    const std::size_t powers = coefficients.size() / entries;
    for (std::size_t i = 0; i < entries; ++i) {
      double sum = 0;
      for (std::size_t k = powers; k-- > 0;) sum = sum * (t - end) + coefficients[k * entries + i];
      out[i] = sum;
    }
  }
};

/// Evaluates the polynomial of the step that contains a time, or of the later step where two meet; returns
/// whether there is one.
inline bool evaluate(const std::vector<piece>& pieces, double t, double* out, std::size_t entries) {
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), t,
                                      [](double time, const piece& p) { return time < p.begin; });
  if (after == pieces.begin() || t > std::prev(after)->end) return false;
  std::prev(after)->evaluate(t, out, entries);
  return true;
}

/// Evaluates the cubic Hermite interpolant of two states and their rates at a fraction of the interval
/// between them.
inline void cubic(double part, double length, const double* a, const double* rates_a, const double* b,
                  const double* rates_b, double* out, std::size_t entries) {
  const double s = part, left = 1 - s;
  for (std::size_t i = 0; i < entries; ++i)
    out[i] = left * left * (1 + 2 * s) * a[i] + s * s * (3 - 2 * s) * b[i] +
             length * s * left * (left * rates_a[i] - s * rates_b[i]);
}

/// The samples of a motion in chronological order, and the polynomials between them: the part of a trajectory
/// that does not depend on the kind of system.
template <class System>
class samples {
public:
  using sample = kanexpr::sample<System>;
  using parameters_type = parameter_values<System>;

  samples() = default;
  explicit samples(const parameters_type& p) : p_(p) {}

  void add(const sample& s) { samples_.push_back(s); }
  /// Adds the solution's polynomial over a step, for `at`.
  void add(piece p) { pieces_.push_back(std::move(p)); }

  std::size_t size() const { return samples_.size(); }
  bool empty() const { return samples_.empty(); }
  auto begin() const { return samples_.begin(); }
  auto end() const { return samples_.end(); }
  const sample& operator[](std::size_t i) const { return samples_[i]; }
  const sample& front() const { return samples_.front(); }
  const sample& back() const { return samples_.back(); }
  const parameters_type& parameters() const { return p_; }

  std::vector<double> times() const {
    return collect([](const sample& s) { return s.t; });
  }

protected:
  template <class Function>
  auto collect(const Function& of) const {
    std::vector<std::invoke_result_t<const Function&, const sample&>> all;
    all.reserve(size());
    for (const sample& s : samples_) all.push_back(of(s));
    return all;
  }

  /// Returns the sample at a time between the samples; `rates` returns ẋ at a sample.
  template <class Rates>
  std::optional<sample> interpolate(double t, const Rates& rates) const {
    if (empty() || !(numeric::is_finite(t) && t >= front().t && t <= back().t)) return std::nullopt;
    const auto after = std::upper_bound(samples_.begin(), samples_.end(), t,
                                        [](double time, const sample& s) { return time < s.t; });
    const sample& a = *std::prev(after);
    if (base::equal(a.t, t) || after == samples_.end()) return a;
    const sample& b = *after;
    const double part = (t - a.t) / (b.t - a.t);
    sample found{t, a.x, a.r};
    for (Eigen::Index i = 0; i < found.r.size(); ++i) found.r(i) += part * (b.r(i) - a.r(i));
    const auto entries = static_cast<std::size_t>(found.x.size());
    if (!evaluate(pieces_, t, found.x.data(), entries))
      cubic(part, b.t - a.t, a.x.data(), rates(a).data(), b.x.data(), rates(b).data(), found.x.data(),
            entries);
    return found;
  }

  static kanexpr::energies energies_of(std::vector<double> kinetic, std::vector<double> potential) {
    std::vector<double> total = kinetic;
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += potential[i];
    return {std::move(kinetic), std::move(potential), std::move(total)};
  }

  /// `units` is null if the model states none.
  kanexpr::table table_of(const derivation::survey& known, const mechanics::unit_table* units) const {
    kanexpr::table all;
    const auto add = [&](std::string name, std::vector<double> values, std::string unit) {
      static_cast<void>(all.add(std::move(name), std::move(values), std::move(unit))); // names are unique
    };
    const auto add_columns = [&](symbolic::symbol_kind kind, int count, auto entry) {
      for (int i = 0, place = known.first_of(kind); i < count; ++i, ++place)
        add(std::string(known.names[place].view()),
            collect([&](const sample& s) -> double { return entry(s, i); }),
            derivation::unit_label(units, known, place));
    };
    const auto is_taken = [&](const std::string& name) {
      return std::ranges::any_of(known.names, [&](const auto& other) { return other.view() == name; });
    };
    add(base::name_of_time(is_taken), times(), units == nullptr ? "" : "s");
    add_columns(symbolic::symbol_kind::coordinate, known.coordinates,
                [](const sample& s, int i) { return s.x(i); });
    add_columns(symbolic::symbol_kind::speed, known.speeds,
                [&](const sample& s, int i) { return s.x(known.coordinates + i); });
    add_columns(symbolic::symbol_kind::input, known.inputs, [](const sample& s, int i) { return s.r(i); });
    return all;
  }

private:
  std::vector<sample> samples_{};
  std::vector<piece> pieces_{}; ///< in chronological order
  parameters_type p_{};
};

} // namespace simulations

} // namespace kanexpr
