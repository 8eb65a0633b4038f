#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>
#include <kanexpr/simulations/simulated_system.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kanexpr::simulations {

/// A compile-time system with the parameters and options of a simulation. Only the functions that the method
/// needs are derived.
template <class System, integrator by>
class compiled_system final : public simulated_system<System> {
  using quantity = mechanics::quantity;
  static constexpr const derivation::survey& of = compiled::survey_of<System>;
  static constexpr int n = of.coordinates, o = of.speeds, m = of.constraints;
  static constexpr bool is_implicit = by == integrator::differential_algebraic;
  using simulated_system<System>::p_;
  template <class Number, int size>
  using vector = Eigen::Matrix<Number, size, 1>;

public:
  compiled_system(const parameter_values<System>& p, const simulation_options<System>& options,
                  trajectory<System>& kept)
      : simulated_system<System>({of, System::record, type_name<System>(), factory_of_manifold()}, p,
                                 options.inputs, options, kept) {}

  /// Returns a hash that identifies the system and its equations of motion.
  static std::uint64_t digest() {
    constexpr quantity first = is_implicit ? quantity::qdot : quantity::rhs; // always derived
    return out_of_line<function<System, first>>::digest();
  }

  status evaluate(results wanted, const instant<double>& at, outputs<double> into) const override {
    return evaluate_any(wanted, at, into, all_results);
  }
  status evaluate(results wanted, const instant<std::complex<double>>& at,
                  outputs<std::complex<double>> into) const override {
    if constexpr (is_implicit) return evaluate_any(wanted, at, into, all_results);
    return {};
  }

private:
  static constexpr auto all_results = std::make_index_sequence<std::size(lists_of_results)>();

  static constexpr manifold_factory factory_of_manifold() {
    if constexpr (m + of.configuration_constraints + of.quaternions != 0)
      return manifold_of<system_interface>;
    return nullptr;
  }

  template <class Number, std::size_t... each>
  status evaluate_any(results wanted, const instant<Number>& at, outputs<Number> into,
                      std::index_sequence<each...>) const {
    status s;
    static_cast<void>(((wanted == static_cast<results>(each) &&
                        (s = evaluate<static_cast<results>(each)>(at, into), true)) ||
                       ...));
    return s;
  }
  template <results wanted, class Number>
  status evaluate(const instant<Number>& at, outputs<Number> into) const {
    constexpr bool is_real = std::is_same_v<Number, double>;
    if constexpr (!(is_real ? is_needed(wanted, of, by) : is_needed_in_complex(wanted, of, by)))
      return {};
    else if constexpr (wanted == results::unreduced && !compiled::is_linked<System>)
      return interpret_unreduced(at, into);
    else
      return evaluate<wanted>(at, into, std::make_index_sequence<list_of(wanted).size>());
  }
  template <results wanted, class Number, std::size_t... i>
  status evaluate(const instant<Number>& at, outputs<Number> into, std::index_sequence<i...>) const {
    if constexpr (wanted == results::jacobian)
      return store(call<finite_function<System, list_of(wanted).quantities[i]...>>(at), into);
    else if constexpr (wanted == results::redundant) // evaluated one by one, since only checks need them
      return (store(call<function<System, list_of(wanted).quantities[i]>>(at), into.begin()[i]), ...);
    else if constexpr (wanted == results::forces)
      return store(call<function<System, list_of(wanted).quantities[i]...>>(at, vector_of<o>(at.udot)), into);
    else
      return store(call<function<System, list_of(wanted).quantities[i]...>>(at), into);
  }

  template <class Function, class Number, class... Rates>
  auto call(const instant<Number>& at, const Rates&... udot) const {
    const auto x = vector_of<n + o>(at.x);
    const auto r = vector_of<of.inputs>(at.r);
    if constexpr (std::is_same_v<Number, double>)
      return out_of_line<Function>{}(at.t, x, p_, r, udot...);
    else
      return out_of_line<Function>{}(at.t, x, vector<Number, of.parameters>(p_.template cast<Number>()), r,
                                     udot...);
  }
  template <int size, class Number>
  static vector<Number, size> vector_of(const Number* entries) {
    vector<Number, size> v;
    std::copy_n(entries, size, v.data());
    return v;
  }
  template <class Found, class Number>
  static status store(const Found& found, Number* into) {
    std::copy_n(found.data(), found.size(), into);
    return status_of(found);
  }
  template <class Found, class Number>
  static status store(const Found& found, outputs<Number> into) {
    return store(found, *into.begin());
  }
  template <class First, class... More, class Number>
  static status store(const std::tuple<First, More...>& found, outputs<Number> into) {
    Number* const* next = into.begin();
    std::apply([&](const auto&... each) { (store(each, *next++), ...); }, found);
    return status_of(std::get<0>(found));
  }

  status interpret_unreduced(const instant<double>& at, outputs<double> into) const {
    double all[static_cast<std::size_t>(n + o * o + o + m)];
    const status s = unreduced_.evaluate(at.t, at.x, p_.data(), at.r, all);
    const double* next = all;
    for (std::size_t i = 0; const int size : {n, o * o, o, m}) {
      std::copy_n(next, size, into.begin()[i++]);
      next += size;
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
