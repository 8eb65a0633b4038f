#pragma once

#include <kanexpr/simulations/inputs/has_prescribed_rates.hpp>
#include <kanexpr/simulations/simulation.hpp>
#include <kanexpr/simulations/system_interface.hpp>

#include <algorithm>
#include <functional>
#include <utility>

namespace kanexpr::simulations {

/// A system with the parameters, options and trajectory of a simulation: the part that calls the user
/// functions with the vectors of the system.
template <class System>
class simulated_system : public system_interface {
public:
  void evaluate_inputs(double t, const double* x, double* r) const final {
    evaluate_source(inputs_, t, x, r);
  }
  std::function<void(double, const double*, double*)> copy_of_inputs() const final {
    if (!has_prescribed_rates(known)) return {};
    return [this, copy = inputs_](double t, const double* x, double* r) { evaluate_source(copy, t, x, r); };
  }
  double event(std::size_t which, double t, const double* x, const double* r) const final {
    const state at = state_of(x);
    const inputs given = inputs_of(r);
    const double value = options_.events[which].value(t, at, p_, given);
    validate(at, given, compiled::symbols_of::state);
    return value;
  }
  after_event handle(std::size_t which, double t, double* x, const double* r) const final {
    state at = state_of(x);
    const inputs given = inputs_of(r);
    moment<System> now{t, at, p_, given};
    const after_event what = options_.events[which].handler(now);
    validate(at, given, compiled::symbols_of::state);
    std::copy_n(at.data(), at.size(), x);
    return what;
  }
  void pass_sample(double t, const double* x, const double* r) const final {
    options_.each_sample(sample_of(t, x, r));
  }
  void store_sample(double t, const double* x, const double* r) final { kept_.add(sample_of(t, x, r)); }
  void store_polynomial(piece p) final { kept_.add(std::move(p)); }

protected:
  using state = kanexpr::state<System>;
  using inputs = input_values<System>;

  /// The last two arguments are vectors of the correct size.
  simulated_system(const system_description& of, const parameter_values<System>& p,
                   const input_source<System>& source, const simulation_options<System>& options,
                   trajectory<System>& kept, state any_state = {}, inputs no_inputs = {})
      : system_interface(of), p_(p), inputs_(source), options_(options), kept_(kept),
        any_state_(std::move(any_state)), no_inputs_(std::move(no_inputs)) {}

  /// Checks the names that a user function looked up in the vectors, and the size of the vector that it
  /// wrote.
  virtual void validate(const state&, const inputs&, compiled::symbols_of) const {}

  const parameter_values<System> p_;

private:
  void evaluate_source(const input_source<System>& source, double t, const double* x, double* r) const {
    const state at = state_of(x);
    inputs given = no_inputs_;
    source.give(t, at, given);
    validate(at, given, compiled::symbols_of::inputs);
    std::copy_n(given.data(), given.size(), r);
  }
  state state_of(const double* x) const {
    state at = any_state_;
    std::copy_n(x, at.size(), at.data());
    return at;
  }
  inputs inputs_of(const double* r) const {
    inputs given = no_inputs_;
    std::copy_n(r, given.size(), given.data());
    return given;
  }
  sample<System> sample_of(double t, const double* x, const double* r) const {
    return {t, state_of(x), inputs_of(r)};
  }

  const input_source<System>& inputs_;
  const simulation_options<System>& options_;
  trajectory<System>& kept_;
  const state any_state_;
  const inputs no_inputs_;
};

} // namespace kanexpr::simulations
