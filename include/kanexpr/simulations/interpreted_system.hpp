#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/values.hpp>
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

/// Several results of a model, interpreted together just as a compiled function would evaluate them.
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
    for (std::size_t i = 0; i < real_.size(); ++i)
      if (is_needed(static_cast<results>(i), of, by)) real_[i].emplace(m, lists_of_results[i]);
    for (std::size_t i = 0; i < complex_.size(); ++i)
      if (is_needed_in_complex(static_cast<results>(i), of, by)) complex_[i].emplace(m, lists_of_results[i]);
  }

  status evaluate(results wanted, const instant<double>& at, outputs<double> into) const override {
    return evaluate(real_, p_, wanted, at, into);
  }
  status evaluate(results wanted, const instant<std::complex<double>>& at,
                  outputs<std::complex<double>> into) const override {
    return evaluate(complex_, complex_p_, wanted, at, into);
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

  template <class Number>
  using all_results = std::array<std::optional<interpreted_results<Number>>, std::size(lists_of_results)>;

  template <class Number, class Parameters>
  status evaluate(all_results<Number>& all, const Parameters& p, results wanted, const instant<Number>& at,
                  outputs<Number> into) const {
    std::optional<interpreted_results<Number>>& found = all[static_cast<std::size_t>(wanted)];
    if (!found) return {};
    const Number t = lower::scalar_math<Number>::from(at.t);
    const argument<Number> x(at.x, states()), r(at.r, known.inputs), udot(at.udot, known.speeds);
    const status s =
        wanted == results::forces ? found->evaluate(t, x, p, r, udot) : found->evaluate(t, x, p, r);
    for (std::size_t i = 0; Number * each : into) found->write(i++, each);
    return s;
  }

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

  const vector<std::complex<double>> complex_p_ = p_.template cast<std::complex<double>>();
  mutable all_results<double> real_{};
  mutable all_results<std::complex<double>> complex_{};
};

} // namespace kanexpr::simulations
