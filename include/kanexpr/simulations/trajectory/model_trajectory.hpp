#pragma once

#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/runtime/values.hpp>
#include <kanexpr/simulations/trajectory/samples.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace kanexpr {

/// The trajectory of a run-time model. Everything that is evaluated along it is interpreted.
template <>
class trajectory<model> : public simulations::samples<model> {
public:
  using samples::operator[];

  trajectory() = default;
  trajectory(const model& of, const parameters_type& p) : samples(p), of_(of) {}

  /// Returns a coordinate, speed or input over the samples: `path["q1"]`; empty if the model has no symbol of
  /// that name.
  std::vector<double> operator[](std::string_view name) const {
    if (empty()) return {};
    const derivation::survey& known = *front().x.known();
    for (int i = 0; i < known.symbols(); ++i) {
      if (known.names[i].view() != name) continue;
      const int states = known.coordinates + known.speeds, input = i - states - known.parameters;
      if (i < states) return collect([&](const sample& s) { return s.x(i); });
      if (input >= 0) return collect([&](const sample& s) { return s.r(input); });
    }
    return {};
  }

  /// Returns the value of an expression of the model at each sample, for the motion given by the equations.
  std::vector<double> along(symbolic::expression e) const {
    if (!of_) return {};
    model m = *of_;
    if (!e.belongs_to(m.graph())) return {};
    symbolic::matrix one(m.graph(), 1, 1);
    one(0, 0) = m.in_motion(e);
    auto f = m.function(one);
    return collect([&](const sample& s) { return f(s.t, s.x, parameters(), s.r)(0, 0); });
  }
  /// Returns a result at each sample: `path.along(m.mass_matrix())`.
  std::vector<Eigen::MatrixXd> along(const symbolic::matrix& result) const {
    if (!of_) return {};
    model m = *of_;
    if (!m.owns(result)) return {};
    auto f = m.function(result);
    return collect([&](const sample& s) -> Eigen::MatrixXd { return f(s.t, s.x, parameters(), s.r); });
  }

  /// Returns the energies of the bodies; empty if the system is given by a Lagrangian.
  kanexpr::energies energies() const {
    if (!of_) return {};
    model m = *of_;
    const symbolic::matrix kinetic = m.get(mechanics::quantity::kinetic_energy);
    if (kinetic.entries.empty()) return {};
    return energies_of(along(kinetic.entries[0]),
                       along(m.get(mechanics::quantity::potential_energy).entries[0]));
  }

  /// Returns the largest constraint residual at each sample.
  std::vector<double> constraint_residuals() const {
    if (!of_) return {};
    model m = *of_;
    return collect([&](const sample& s) {
      const consistency found = check_consistency(m, s.x, parameters(), s.r, s.t);
      return (std::max)(found.configuration_residual, found.velocity_residual);
    });
  }

  /// Returns the sample at a time between the samples, as for a compiled system.
  std::optional<sample> at(double t) const {
    if (!of_) return std::nullopt;
    model m = *of_;
    auto rhs = m.function(m.rhs());
    return interpolate(t,
                       [&](const sample& s) -> Eigen::VectorXd { return rhs(s.t, s.x, parameters(), s.r); });
  }

  /// Returns the time, the state and the inputs as named columns; the time is "t", or "time" if the model has
  /// a symbol t. The columns have the units of the symbols, if the model states any.
  kanexpr::table table() const {
    if (empty()) return {};
    const derivation::survey& known = *front().x.known();
    if (!of_ || !known.states_units) return table_of(known, nullptr);
    const mechanics::unit_table units = of_->units();
    return table_of(known, &units);
  }

private:
  std::optional<model> of_{};
};

} // namespace kanexpr
