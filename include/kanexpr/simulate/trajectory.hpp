#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/name_of_time.hpp>
#include <kanexpr/simulate/dense_output.hpp>
#include <kanexpr/simulate/table.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
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

/// What a simulation kept of a motion: samples in the order of time. Where each step is a sample and an event
/// changed the state there are two of one time, before and after.
template <class System>
class trajectory {
public:
  using sample = kanexpr::sample<System>;
  using parameters_type = parameter_values<System>;

  trajectory() = default;
  explicit trajectory(const parameters_type& p) : p_(p) {}

  void add(const sample& s) { samples_.push_back(s); }
  /// The solution's polynomial over a step, for `at`.
  void add(simulated::piece piece) { pieces_.add(std::move(piece)); }

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

  /// A coordinate, speed or input over the samples: `path[q1]`.
  template <std::derived_from<scalar<1>> Symbol>
  std::vector<double> operator[](const Symbol& symbol) const {
    constexpr auto* told = Symbol().tokens[0].symbol;
    return collect([&](const sample& s) -> double {
      if constexpr (told != nullptr && told->kind == symbolic::symbol_kind::input)
        return s.r[symbol];
      else
        return s.x[symbol];
    });
  }

  /// Results of a compiled function at each sample, with their status where they have one:
  /// `path.along(eom::kinetic_energy)`.
  template <auto... wanted>
  auto along(function<System, wanted...> f) const {
    return collect([&](const sample& s) { return f(s.t, s.x, p_, s.r); });
  }
  /// An expression of the model at each sample: `path.along<velocity_of<Dmc>>()`.
  template <auto expression>
  auto along() const {
    return along(function<System, expression>{});
  }

  kanexpr::energies energies() const {
    using mechanics::quantity;
    const auto both = collect([&](const sample& s) {
      return out_of_line<function<System, quantity::kinetic_energy, quantity::potential_energy>>{}(s.t, s.x,
                                                                                                   p_, s.r);
    });
    kanexpr::energies all;
    for (const auto& [kinetic, potential] : both) {
      all.kinetic.push_back(kinetic);
      all.potential.push_back(potential);
      all.total.push_back(kinetic + potential);
    }
    return all;
  }

  /// The largest magnitude that the constraints leave at each sample.
  std::vector<double> constraint_residuals() const {
    using constraints = compiled::constraints_at<System, parameters_type, input_values<System>>;
    return collect([&](const sample& s) {
      const constraints here(s.t, p_, s.r);
      return (std::max)(numeric::largest(here.configuration_residual(s.x)),
                        numeric::largest(here.velocity_residual(s.x)));
    });
  }

  /// Between the samples: by the integrator's own polynomials where the simulation kept them (`dense`), else
  /// by cubics through the states and their rates, which an event between two samples bends; the inputs on
  /// straight lines. Nothing outside the trajectory's span. After an event at that very time.
  std::optional<sample> at(double t) const {
    if (empty() || !(t >= front().t && t <= back().t)) return std::nullopt;
    const auto after = std::upper_bound(samples_.begin(), samples_.end(), t,
                                        [](double time, const sample& s) { return time < s.t; });
    const sample& a = *std::prev(after);
    if (numeric::equal(a.t, t) || after == samples_.end()) return a;
    const sample& b = *after;
    const double part = (t - a.t) / (b.t - a.t);
    sample found{t, a.x, a.r};
    for (Eigen::Index i = 0; i < found.r.size(); ++i) found.r(i) += part * (b.r(i) - a.r(i));
    if (!pieces_.evaluate(t, found.x.data(), static_cast<std::size_t>(found.x.size())))
      simulated::cubic(part, b.t - a.t, std::span(a.x.data(), static_cast<std::size_t>(a.x.size())),
                       rates(a).data(), b.x.data(), rates(b).data(), found.x.data());
    return found;
  }

  /// The time, the state and the inputs as named columns: "t", or "time" where the model calls something t.
  kanexpr::table table() const {
    kanexpr::table all;
    const auto put = [&](std::string_view name, std::vector<double> values) {
      static_cast<void>(all.add(std::string(name), std::move(values))); // no two symbols have one name
    };
    const auto add = [&](symbolic::symbol_kind kind, int count, auto entry) {
      for (int i = 0; i < count; ++i)
        put(known.names[known.first_of(kind) + i].view(),
            collect([&](const sample& s) -> double { return entry(s, i); }));
    };
    const auto is_taken = [](const std::string& name) {
      return std::ranges::any_of(known.names, [&](const auto& other) { return other.view() == name; });
    };
    put(simulated::name_of_time(is_taken), times());
    add(symbolic::symbol_kind::coordinate, known.coordinates, [](const sample& s, int i) { return s.x(i); });
    add(symbolic::symbol_kind::speed, known.speeds,
        [](const sample& s, int i) { return s.x(known.coordinates + i); });
    add(symbolic::symbol_kind::input, known.inputs, [](const sample& s, int i) { return s.r(i); });
    return all;
  }

private:
  static constexpr const derivation::survey& known = compiled::survey_of<System>;

  auto rates(const sample& s) const {
    return out_of_line<function<System, mechanics::quantity::rhs>>{}(s.t, s.x, p_, s.r);
  }

  template <class Function>
  auto collect(const Function& of) const {
    std::vector<std::invoke_result_t<const Function&, const sample&>> all;
    all.reserve(size());
    for (const sample& s : samples_) all.push_back(of(s));
    return all;
  }

  std::vector<sample> samples_{};
  simulated::dense_output pieces_{};
  parameters_type p_{};
};

} // namespace kanexpr
