#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>
#include <kanexpr/simulations/integrator.hpp>
#include <kanexpr/simulations/simulated_system.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

namespace kanexpr::simulations {

/// A compile-time system with the parameters and options of a simulation. Only the functions that the method
/// needs are derived.
template <class System, integrator by>
class compiled_system final : public simulated_system<System> {
  using quantity = mechanics::quantity;
  static constexpr const derivation::survey& of = compiled::survey_of<System>;
  static constexpr int n = of.coordinates, o = of.speeds;
  static constexpr int m = of.constraints, l = of.configuration_constraints;
  static constexpr bool is_implicit = by == integrator::differential_algebraic;
  using simulated_system<System>::p_;
  template <class Number, int size>
  using vector = Eigen::Matrix<Number, size, 1>;

public:
  compiled_system(const parameter_values<System>& p, const simulation_options<System>& options,
                  trajectory<System>& kept)
      : simulated_system<System>({of, System::record, type_name<System>(), factory_of_manifold()}, p,
                                 options.inputs, options, kept) {}

  /// Returns a hash by which the system and its equations of motion are identified.
  static std::uint64_t digest() {
    constexpr quantity first = is_implicit ? quantity::qdot : quantity::rhs; // derived in any case
    return out_of_line<function<System, first>>::digest();
  }

  status evaluate(results wanted, double t, const double* x, const double* r, outputs into) const override {
    switch (wanted) {
    case results::rates: return evaluate<results::rates>(t, x, r, into);
    case results::configuration: return evaluate<results::configuration>(t, x, r, into);
    case results::redundant: return evaluate<results::redundant>(t, x, r, into);
    case results::velocities: return evaluate<results::velocities>(t, x, r, into);
    case results::dependent_speeds: return evaluate<results::dependent_speeds>(t, x, r, into);
    case results::unreduced: return evaluate<results::unreduced>(t, x, r, into);
    case results::jacobian: return evaluate<results::jacobian>(t, x, r, into);
    case results::multipliers: return evaluate<results::multipliers>(t, x, r, into);
    }
    return {};
  }
  status implicit(double t, const double* y, const double* ydot, const double* r,
                  double* left) const override {
    return residual(t, y, ydot, r, left);
  }
  status implicit(double t, const std::complex<double>* y, const std::complex<double>* ydot,
                  const std::complex<double>* r, std::complex<double>* left) const override {
    return residual(t, y, ydot, r, left);
  }

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

  template <results wanted>
  status evaluate(double t, const double* x, const double* r, outputs into) const {
    if constexpr (!is_needed(wanted, of, by))
      return {};
    else if constexpr (wanted == results::unreduced && !compiled::is_linked<System>)
      return interpret_unreduced(t, x, r, into);
    else
      return evaluate<wanted>(t, x, r, into, std::make_index_sequence<list_of(wanted).size>());
  }
  template <results wanted, std::size_t... i>
  status evaluate(double t, const double* x, const double* r, outputs into, std::index_sequence<i...>) const {
    if constexpr (wanted == results::jacobian)
      return store(call<finite_function<System, list_of(wanted).quantities[i]...>>(t, x, r), into);
    else if constexpr (wanted == results::redundant) // each without the others, as only checks need them
      return (store(call<function<System, list_of(wanted).quantities[i]>>(t, x, r), into.begin()[i]), ...);
    else
      return store(call<function<System, list_of(wanted).quantities[i]...>>(t, x, r), into);
  }
  template <class Function>
  auto call(double t, const double* x, const double* r) const {
    return out_of_line<Function>{}(t, vector_of<n + o>(x), p_, vector_of<of.inputs>(r));
  }
  template <class Found>
  static status store(const Found& found, double* into) {
    std::copy_n(found.data(), found.size(), into);
    return status_of(found);
  }
  template <class Found>
  static status store(const Found& found, outputs into) {
    return store(found, *into.begin());
  }
  template <class First, class... More>
  static status store(const std::tuple<First, More...>& found, outputs into) {
    double* const* next = into.begin();
    std::apply([&](const auto&... each) { (store(each, *next++), ...); }, found);
    return status_of(std::get<0>(found));
  }

  status interpret_unreduced(double t, const double* x, const double* r, outputs into) const {
    double all[static_cast<std::size_t>(n + o * o + o + m)];
    const status s = unreduced_.evaluate(t, x, p_.data(), r, all);
    const double* next = all;
    for (std::size_t i = 0; const int size : {n, o * o, o, m}) {
      std::copy_n(next, size, into.begin()[i++]);
      next += size;
    }
    return s;
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
          compiled::table_for<System, double, state<System>, parameter_values<System>, input_values<System>,
                              quantity::qdot, quantity::unreduced_mass_matrix, quantity::unreduced_forcing,
                              quantity::constraint_bias>(),
          of);
    else
      return 0;
  }

  mutable decltype(unreduced_equations()) unreduced_ = unreduced_equations();
};

} // namespace kanexpr::simulations
