#pragma once

#include <kanexpr/simulate/samples.hpp>
#include <kanexpr/steps/assemble.hpp>

#include <concepts>

namespace kanexpr {

/// What a simulation kept of a motion: samples in the order of time. Where each step is a sample and an event
/// changed the state there are two of one time, before and after.
template <class System>
class trajectory : public simulated::samples<System> {
  using base = simulated::samples<System>;
  using base::collect;

public:
  using base::base;
  using base::parameters;
  using typename base::parameters_type;
  using typename base::sample;
  using base::operator[];

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
    return collect([&](const sample& s) { return f(s.t, s.x, parameters(), s.r); });
  }
  /// An expression of the model at each sample: `path.along<velocity_of<Dmc>>()`.
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
      const constraints here(s.t, parameters(), s.r);
      double most = 0;
      for (const double each :
           {numeric::largest(here.configuration_residual(s.x)), numeric::largest(here.velocity_residual(s.x)),
            numeric::largest(here.redundant_residual(s.x)), numeric::largest(here.redundant_rate(s.x))})
        most = numeric::larger(most, each);
      return most;
    });
  }

  /// Between the samples: by the integrator's own polynomials where the simulation kept them (`dense`), else
  /// by cubics through the states and their rates, which an event between two samples bends; the inputs on
  /// straight lines. Nothing outside the trajectory's span. After an event at that very time.
  std::optional<sample> at(double t) const {
    return base::between(t, [&](const sample& s) {
      return out_of_line<function<System, mechanics::quantity::rhs>>{}(s.t, s.x, parameters(), s.r);
    });
  }

  /// The time, the state and the inputs as named columns: "t", or "time" where the model calls something t.
  kanexpr::table table() const { return base::table_of(compiled::survey_of<System>); }
};

} // namespace kanexpr
