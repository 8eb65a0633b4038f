#pragma once

#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>
#include <kanexpr/simulate/inputs/prescribed_rates.hpp>
#include <kanexpr/simulate/integrator.hpp>
#include <kanexpr/simulate/simulation_options.hpp>
#include <kanexpr/simulate/system_interface.hpp>

#include <algorithm>
#include <cstdint>

namespace kanexpr::simulated {

/// A compile-time system with the parameters and options of a simulation. Only the functions that the method
/// needs are derived.
template <class System, integrator by>
class compiled_system final : public system_interface {
  using quantity = mechanics::quantity;
  static constexpr const deriving::survey& of = compiled::survey_of<System>;
  static constexpr int n = of.coordinates, o = of.speeds;
  static constexpr int m = of.constraints, l = of.configuration_constraints;
  static constexpr bool has_newton = by == integrator::bdf || by == integrator::implicit_runge_kutta;
  static constexpr bool is_implicit = by == integrator::differential_algebraic;
  using state = kanexpr::state<System>;
  using inputs = input_values<System>;
  template <class Number, int size>
  using vector = Eigen::Matrix<Number, size, 1>;

public:
  compiled_system(const parameter_values<System>& p, const simulation_options<System>& options,
                  trajectory<System>& kept)
      : system_interface(of, System::record, type_name<System>(), factory_of_manifold()), p_(p),
        options_(options), kept_(kept) {}

  /// Returns a hash by which the system and its equations of motion are identified.
  static std::uint64_t digest() {
    constexpr quantity first = is_implicit ? quantity::qdot : quantity::rhs; // derived in any case
    return out_of_line<function<System, first>>::digest();
  }

  status rates(double t, const double* x, const double* r, double* xdot) const override {
    return store(call<quantity::rhs>(t, x, r), xdot);
  }
  status jacobian(double t, const double* x, const double* r, double* by_state,
                  double* by_inputs) const override {
    if constexpr (has_newton) {
      const auto [state_columns, input_columns] =
          out_of_line<finite_function<System, quantity::state_jacobian, quantity::input_jacobian>>{}(
              t, vector_of<n + o>(x), p_, vector_of<of.inputs>(r));
      std::copy_n(input_columns.data(), input_columns.size(), by_inputs);
      return store(state_columns, by_state);
    }
    return {};
  }
  void configuration(double t, const double* x, const double* r, double* left,
                     double* by_coordinates) const override {
    if constexpr (l != 0)
      store_pair(call<quantity::configuration_residual, quantity::configuration_jacobian_by_all>(t, x, r),
                 left, by_coordinates);
  }
  void velocities(double t, const double* x, const double* r, double* left,
                  double* by_speeds) const override {
    if constexpr (m != 0)
      store_pair(call<quantity::velocity_residual, quantity::constraint_jacobian>(t, x, r), left, by_speeds);
  }
  void redundant(double t, const double* x, const double* r, double* left, double* terms, double* rate,
                 double* rate_terms) const override {
    if constexpr (of.redundant_constraints != 0) {
      store(call<quantity::redundant_residual>(t, x, r), left);
      store(call<quantity::redundant_terms>(t, x, r), terms);
      store(call<quantity::redundant_rate>(t, x, r), rate);
      store(call<quantity::redundant_rate_terms>(t, x, r), rate_terms);
    }
  }
  status dependent_speeds(double t, const double* x, const double* r, double* u) const override {
    if constexpr (m != 0) return store(call<quantity::dependent_speeds>(t, x, r), u);
    return {};
  }

  status unreduced(double t, const double* x, const double* r, double* qdot, double* mass, double* force,
                   double* bias) const override {
    if constexpr (m == 0) {
      return {};
    } else if constexpr (compiled::is_linked<System>) {
      const auto [rates, masses, forces, biases] =
          call<quantity::qdot, quantity::unreduced_mass_matrix, quantity::unreduced_forcing,
               quantity::constraint_bias>(t, x, r);
      store(rates, qdot), store(masses, mass), store(forces, force);
      return store(biases, bias);
    } else {
      double all[static_cast<std::size_t>(n + o * o + o + m)];
      const status s = unreduced_.evaluate(t, x, p_.data(), r, all);
      const double* next = all;
      const auto put = [&next](int count, double* out) { std::copy_n(next, count, out), next += count; };
      put(n, qdot), put(o * o, mass), put(o, force), put(m, bias);
      return s;
    }
  }

  void multipliers(double t, const double* x, const double* r, double* lambda) const override {
    if constexpr (is_implicit && m != 0) store(call<quantity::multipliers>(t, x, r), lambda);
  }
  status implicit(double t, const double* y, const double* ydot, const double* r,
                  double* left) const override {
    return residual(t, y, ydot, r, left);
  }
  status implicit(double t, const std::complex<double>* y, const std::complex<double>* ydot,
                  const std::complex<double>* r, std::complex<double>* left) const override {
    return residual(t, y, ydot, r, left);
  }

  void evaluate_inputs(double t, const double* x, double* r) const override {
    inputs given;
    options_.inputs.give(t, state(x), given);
    std::copy_n(given.data(), given.size(), r);
  }
  std::function<void(double, const double*, double*)> copy_of_inputs() const override {
    if constexpr (has_prescribed_rates(of))
      return [source = options_.inputs](double t, const double* x, double* r) {
        inputs given;
        source.give(t, state(x), given);
        std::copy_n(given.data(), given.size(), r);
      };
    return {};
  }
  double event(std::size_t which, double t, const double* x, const double* r) const override {
    return options_.events[which].value(t, state(x), p_, inputs(r));
  }
  after_event handle(std::size_t which, double t, double* x, const double* r) const override {
    state at(x);
    const inputs given(r);
    moment<System> now{t, at, p_, given};
    const after_event what = options_.events[which].handler(now);
    std::copy_n(at.data(), at.size(), x);
    return what;
  }
  void pass_sample(double t, const double* x, const double* r) const override {
    options_.each_sample(sample<System>{t, state(x), inputs(r)});
  }
  void store_sample(double t, const double* x, const double* r) override {
    kept_.add(sample<System>{t, state(x), inputs(r)});
  }
  void store_polynomial(piece p) override { kept_.add(std::move(p)); }

private:
  static constexpr manifold_factory factory_of_manifold() {
    if constexpr (m + l + of.quaternions != 0) return manifold_of<system_interface>;
    return nullptr;
  }

  template <int size, class Number = double>
  static vector<Number, size> vector_of(const Number* entries) {
    vector<Number, size> v;
    std::copy_n(entries, size, v.data());
    return v;
  }

  template <quantity... wanted>
  auto call(double t, const double* x, const double* r) const {
    return out_of_line<function<System, wanted...>>{}(t, vector_of<n + o>(x), p_, vector_of<of.inputs>(r));
  }
  template <class Found>
  static status store(const Found& found, double* out) {
    std::copy_n(found.data(), found.size(), out);
    return status_of(found);
  }
  template <class Found>
  static void store_pair(const Found& found, double* first, double* second) {
    store(std::get<0>(found), first);
    store(std::get<1>(found), second);
  }

  template <class Number>
  status residual(double t, const Number* y, const Number* ydot, const Number* inputs_at, Number* out) const {
    status s;
    if constexpr (is_implicit) {
      const auto x = vector_of<n + o>(y);
      const auto udot = vector_of<o>(ydot + n);
      const vector<Number, of.parameters> p = p_.template cast<Number>();
      const auto r = vector_of<of.inputs>(inputs_at);
      Eigen::Map<vector<Number, n + o + m + l>> left(out);
      const auto qdot = out_of_line<function<System, quantity::qdot>>{}(t, x, p, r);
      s = status_of(qdot);
      left.template head<n>() = vector<Number, n>(ydot) - qdot;
      left.template segment<o>(n) =
          out_of_line<function<System, quantity::unreduced_forces>>{}(t, x, p, r, udot);
      if constexpr (m != 0) {
        const auto [kept, jacobian] =
            out_of_line<function<System, quantity::velocity_residual, quantity::constraint_jacobian>>{}(t, x,
                                                                                                        p, r);
        left.template segment<o>(n) += jacobian.transpose() * vector<Number, m>(y + n + o);
        left.template segment<m>(n + o) = kept;
      }
      if constexpr (l != 0) {
        const auto [kept, jacobian] = out_of_line<
            function<System, quantity::configuration_residual, quantity::configuration_jacobian_by_all>>{}(
            t, x, p, r);
        left.template head<n>() -= jacobian.transpose() * vector<Number, l>(y + n + o + m);
        left.template tail<l>() = kept;
      }
    }
    return s;
  }

  /// Interpreted, since these equations are needed only near singular positions.
  static auto unreduced_equations() {
    if constexpr (m != 0 && !compiled::is_linked<System>)
      return runtime::table_interpreter<double>(
          compiled::table_for<System, double, state, parameter_values<System>, inputs, quantity::qdot,
                              quantity::unreduced_mass_matrix, quantity::unreduced_forcing,
                              quantity::constraint_bias>(),
          of);
    else
      return 0;
  }

  const parameter_values<System> p_;
  const simulation_options<System>& options_;
  trajectory<System>& kept_;
  mutable decltype(unreduced_equations()) unreduced_ = unreduced_equations();
};

} // namespace kanexpr::simulated
