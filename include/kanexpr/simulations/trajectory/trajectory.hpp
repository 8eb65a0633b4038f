#pragma once

#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/units_of.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/simulations/trajectory/samples.hpp>
#include <kanexpr/steps/assemble.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <concepts>
#include <optional>
#include <utility>
#include <vector>

namespace kanexpr {

/// The samples that a simulation kept, in chronological order. If each step is a sample and an event changed
/// the state, there are two samples at the same time, before and after the event.
template <class System>
class trajectory : public simulations::samples<System> {
  using base = simulations::samples<System>;
  using base::collect;

public:
  using base::base;
  using base::parameters;
  using typename base::parameters_type;
  using typename base::sample;
  using base::operator[];

  /// Returns a coordinate, speed or input over the samples: `path[q1]`.
  template <std::derived_from<scalar<1>> Symbol>
  std::vector<double> operator[](const Symbol& symbol) const {
    constexpr auto* record = Symbol().tokens[0].symbol;
    return collect([&](const sample& s) -> double {
      if constexpr (record != nullptr && record->kind == symbolic::symbol_kind::input)
        return s.r[symbol];
      else
        return s.x[symbol];
    });
  }

  /// Returns the results of a compiled function at each sample, with their status if they have one:
  /// `path.along(eom::kinetic_energy)`.
  template <auto... wanted>
  auto along(function<System, wanted...> f) const {
    return collect([&](const sample& s) { return f(s.t, s.x, parameters(), s.r); });
  }
  /// Returns the value of an expression of the model at each sample: `path.along<velocity_of<Dmc>>()`.
  template <auto expression>
  auto along() const {
    return along(function<System, expression>{});
  }

  kanexpr::energies energies() const {
    using mechanics::quantity;
    const auto both = collect([&](const sample& s) {
      return out_of_line<function<System, quantity::kinetic_energy, quantity::potential_energy>>{}(
          s.t, s.x, parameters(), s.r);
    });
    std::vector<double> kinetic_energy, potential_energy;
    for (const auto& [kinetic, potential] : both)
      kinetic_energy.push_back(kinetic), potential_energy.push_back(potential);
    return base::energies_of(std::move(kinetic_energy), std::move(potential_energy));
  }

  /// Returns the largest constraint residual at each sample.
  std::vector<double> constraint_residuals() const {
    using constraints = steps::constraints_at<System, parameters_type, input_values<System>>;
    return collect([&](const sample& s) {
      const constraints here(s.t, parameters(), s.r);
      double most = 0;
      for (const double each :
           {numeric::largest(here.configuration_residual(s.x)), numeric::largest(here.velocity_residual(s.x)),
            numeric::largest(here.redundant_residual(s.x)), numeric::largest(here.redundant_rate(s.x))})
        most = numeric::larger(most, each);
      return most;
    });
  }

  /// Returns the sample at a time between the samples: from the integrator's own polynomials if the
  /// simulation kept them (`dense`), otherwise from cubics through the states and their rates, which are
  /// inaccurate across an event; inputs are interpolated linearly. Returns nothing outside the trajectory's
  /// span. At the time of an event, it returns the sample after the event.
  std::optional<sample> at(double t) const {
    return base::interpolate(t, [&](const sample& s) {
      return out_of_line<function<System, mechanics::quantity::rhs>>{}(s.t, s.x, parameters(), s.r);
    });
  }

  /// Returns the time, the state and the inputs as named columns; the time is "t", or "time" if the model has
  /// a symbol t. The columns have the units of the symbols, if the model states any.
  kanexpr::table table() const {
    return base::table_of(compiled::survey_of<System>, compiled::stated_units_of<System>());
  }
};

} // namespace kanexpr
