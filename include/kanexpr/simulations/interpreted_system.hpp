#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/values.hpp>
#include <kanexpr/simulations/integrator.hpp>
#include <kanexpr/simulations/motions/unknown_name_error.hpp>
#include <kanexpr/simulations/simulated_system.hpp>
#include <kanexpr/simulations/trajectory/model_trajectory.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::simulations {

/// Returns why a model cannot be simulated, as a sentence; empty if it can be.
inline std::string check_model(model& m) {
  m.rhs(); // may fail, and clears earlier mistakes
  if (!m.mistake().empty()) return m.mistake();
  const mechanics::mechanism& of = m.mechanism();
  const int symbols = of.coordinates.size() + of.speeds.size() + of.parameters.size() + of.inputs.size();
  if (symbols <= derivation::survey::room) return {};
  return "the model has " + std::to_string(symbols) + " symbols; a simulation supports at most " +
         std::to_string(derivation::survey::room);
}

/// Several results of a model, interpreted together in the same way as their compiled function evaluates
/// them.
template <class Number>
class interpreted_results {
public:
  interpreted_results(model& m, const result_list& wanted)
      : function_(m.function<Number>(entries(m, wanted, parts_))) {}

  template <class... Arguments>
  status evaluate(const Arguments&... arguments) {
    found_ = function_(arguments...).data();
    return function_.status();
  }
  /// Writes one of the results in column-major order.
  void write(std::size_t which, Number* out) const {
    const part& p = parts_[which];
    for (int j = 0; j < p.columns; ++j)
      for (int i = 0; i < p.rows; ++i) *out++ = found_[p.first + i * p.columns + j];
  }

private:
  struct part {
    int first, rows, columns;
  };

  static symbolic::matrix entries(model& m, const result_list& wanted, std::vector<part>& parts) {
    symbolic::matrix all(m.graph(), 0, 1);
    for (std::size_t i = 0; i < wanted.size; ++i) {
      const symbolic::matrix result = m.get(wanted.quantities[i]);
      parts.push_back({all.entries.size(), result.rows, result.columns});
      for (const symbolic::expression& e : result.entries) all.entries.push(e);
    }
    all.rows = all.entries.size();
    return all;
  }

  std::vector<part> parts_{};
  runtime::interpreted<Number> function_;
  const Number* found_ = nullptr;
};

/// A run-time model with the parameters and options of a simulation. Only the results that the method needs
/// are derived.
class interpreted_system final : public simulated_system<model> {
  using quantity = mechanics::quantity;
  template <class Number>
  using vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
  template <class Number>
  using argument = Eigen::Map<const vector<Number>>;

public:
  interpreted_system(model& m, const derivation::survey& of, integrator by, const parameter_values<model>& p,
                     const input_source<model>& source, const simulation_options<model>& options,
                     trajectory<model>& kept)
      : simulated_system({of, nothing_bound(), runtime::name_of_models, factory_of_manifold(of)}, p, source,
                         options, kept, state(m), inputs(m)) {
    for (std::size_t i = 0; i < results_.size(); ++i)
      if (is_needed(static_cast<results>(i), of, by)) results_[i].emplace(m, lists_of_results[i]);
    if (by == integrator::differential_algebraic) {
      real_.emplace(m, of, p);
      complex_.emplace(m, of, p);
    }
  }

  status evaluate(results wanted, double t, const double* x, const double* r, outputs into) const override {
    std::optional<interpreted_results<double>>& found = results_[static_cast<std::size_t>(wanted)];
    if (!found) return {};
    const status s = found->evaluate(t, argument<double>(x, states()), p_, argument<double>(r, known.inputs));
    for (std::size_t i = 0; double* each : into) found->write(i++, each);
    return s;
  }
  status implicit(double t, const double* y, const double* ydot, const double* r,
                  double* left) const override {
    return real_ ? real_->residual(known, t, y, ydot, r, left) : status();
  }
  status implicit(double t, const std::complex<double>* y, const std::complex<double>* ydot,
                  const std::complex<double>* r, std::complex<double>* left) const override {
    return complex_ ? complex_->residual(known, t, y, ydot, r, left) : status();
  }

private:
  static manifold_factory factory_of_manifold(const derivation::survey& of) {
    const bool has_one = of.constraints + of.configuration_constraints + of.quaternions != 0;
    return has_one ? manifold_of<system_interface> : nullptr;
  }
  static const describe::system_record& nothing_bound() {
    static constexpr describe::system_record none{};
    return none;
  }
  /// F of the method with multipliers, for real or complex numbers.
  template <class Number>
  class multiplier_equations {
  public:
    multiplier_equations(model& m, const derivation::survey& of, const parameter_values<model>& p)
        : p_(p.template cast<Number>()), qdot_(m, {1, {quantity::qdot}}),
          forces_(m, {1, {quantity::unreduced_forces}}) {
      if (of.constraints != 0) velocities_.emplace(m, list_of(results::velocities));
      if (of.configuration_constraints != 0) configuration_.emplace(m, list_of(results::configuration));
    }

    status residual(const derivation::survey& of, double time, const Number* y, const Number* ydot,
                    const Number* inputs_at, Number* out) {
      const int n = of.coordinates, o = of.speeds, m = of.constraints, l = of.configuration_constraints;
      const Number t = lower::scalar_math<Number>::from(time);
      const argument<Number> x(y, n + o), udot(ydot + n, o), r(inputs_at, of.inputs);
      const status s = qdot_.evaluate(t, x, p_, r);
      qdot_.write(0, out);
      Eigen::Map<vector<Number>> left(out, n + o + m + l);
      left.head(n) = argument<Number>(ydot, n) - left.head(n);
      forces_.evaluate(t, x, p_, r, udot);
      forces_.write(0, out + n);
      if (m != 0) {
        Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> by_speeds(m, o);
        velocities_->evaluate(t, x, p_, r);
        velocities_->write(0, out + n + o), velocities_->write(1, by_speeds.data());
        left.segment(n, o) += by_speeds.transpose().lazyProduct(argument<Number>(y + n + o, m));
      }
      if (l != 0) {
        Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> by_coordinates(l, n);
        configuration_->evaluate(t, x, p_, r);
        configuration_->write(0, out + n + o + m), configuration_->write(1, by_coordinates.data());
        left.head(n) -= by_coordinates.transpose().lazyProduct(argument<Number>(y + n + o + m, l));
      }
      return s;
    }

  private:
    vector<Number> p_;
    interpreted_results<Number> qdot_, forces_;
    std::optional<interpreted_results<Number>> velocities_{}, configuration_{};
  };

  void validate(const state& at, const inputs& given, compiled::symbols_of which) const override {
    const bool is_state = which == compiled::symbols_of::state;
    const runtime::value_vector* const left =
        is_state ? static_cast<const runtime::value_vector*>(&at) : &given;
    const runtime::value_vector* const all[]{left, &at, &p_, &given};
    for (const runtime::value_vector* each : all)
      if (const base::sentence found = each->mistake()) throw unknown_name_error(found);
    const compiled::symbol_range range = compiled::range_of(which, known);
    if (const base::sentence found =
            compiled::check_size(range.vector, "the model", static_cast<int>(left->size()), range.size))
      throw unknown_name_error(found);
  }

  mutable std::array<std::optional<interpreted_results<double>>, std::size(lists_of_results)> results_{};
  mutable std::optional<multiplier_equations<double>> real_{};
  mutable std::optional<multiplier_equations<std::complex<double>>> complex_{};
};

} // namespace kanexpr::simulations
