#pragma once

#include <kanexpr/compiled/callable.hpp>
#include <kanexpr/compiled/instance.hpp>
#include <kanexpr/compiled/named_results.hpp>

#include <complex>
#include <cstdint>
#include <type_traits>
#include <utility>

/// Models whose functions are compiled once, in a library of their own. The header of such a model, which
/// `kanexpr_add_model` writes, holds its types, names and sizes; nothing is derived where it is included.
namespace kanexpr {

template <class System>
struct equations_of_motion;
template <class System>
struct linearization;

namespace compiled {

/// Whether a system has its functions in a library. `surveyed` is written out for those.
template <class System>
inline constexpr bool is_linked = requires { surveyed<System>::is_linked; };

template <class... Functions>
struct function_list {
  template <class Function>
  static constexpr bool holds = (std::is_same_v<Function, Functions> || ...);
};

template <class... Lists>
struct joined;
template <class... First, class... Second>
struct joined<function_list<First...>, function_list<Second...>> {
  using type = function_list<First..., Second...>;
};

/// The results that a system has by name, those that are given the rates of the speeds apart.
template <bool at_rates>
struct results_by_name {
  static constexpr bool holds(const mechanics::result_row& row) {
    return !mechanics::is_of_linearization(row.is) && !row.takes_weights && !row.takes_direction &&
           row.holds_speed_rates == at_rates;
  }
  static constexpr int size = [] {
    int count = 0;
    for (const mechanics::result_row& row : mechanics::results) count += holds(row) ? 1 : 0;
    return count;
  }();
  static constexpr mechanics::quantity at(int place) {
    for (const mechanics::result_row& row : mechanics::results)
      if (holds(row) && place-- == 0) return row.is;
    return {};
  }
};
template <class System, bool at_rates,
          class Places = std::make_integer_sequence<int, results_by_name<at_rates>::size>>
struct functions_by_name;
template <class System, bool at_rates, int... place>
struct functions_by_name<System, at_rates, std::integer_sequence<int, place...>> {
  using type = function_list<function<System, results_by_name<at_rates>::at(place)>...>;
};

/// What the library of a model holds for double: each result by itself, and what simulations and operating
/// points ask for together.
template <class System>
struct linked_functions {
  using of = mechanics::quantity;
  using together = function_list<
      function<System, of::mass_matrix, of::forcing>,
      function<System, of::kinetic_energy, of::potential_energy>,
      function<System, of::configuration_residual, of::configuration_jacobian_by_all>,
      function<System, of::velocity_residual, of::constraint_jacobian>,
      function<System, of::qdot, of::unreduced_mass_matrix, of::unreduced_forcing, of::constraint_bias>,
      finite_function<System, of::state_matrix, of::input_matrix>,
      finite_function<System, of::implicit_mass_matrix, of::implicit_state_matrix, of::implicit_input_matrix>,
      finite_function<System, of::state_jacobian, of::input_jacobian>>;
  using type = typename joined<typename functions_by_name<System, false>::type, together>::type;
};
/// And of functions that are given the rates of the speeds.
template <class System>
struct linked_functions_at_rates : functions_by_name<System, true> {};
/// And for complex numbers: what operating points ask for.
template <class System>
struct linked_functions_of_complex {
  using of = mechanics::quantity;
  static constexpr bool is_constrained =
      survey_of<System>.constraints + survey_of<System>.configuration_constraints != 0;
  using type =
      std::conditional_t<is_constrained, function_list<function<System, of::constraint_residual, of::rhs>>,
                         function_list<function<System, of::rhs>>>;
};

template <class System, class Number, class Function, bool at_rates = false>
constexpr bool is_in_library() {
  if constexpr (!is_linked<System>)
    return false;
  else if constexpr (at_rates)
    return std::is_same_v<Number, double> &&
           linked_functions_at_rates<System>::type::template holds<Function>;
  else if constexpr (std::is_same_v<Number, std::complex<double>>)
    return linked_functions_of_complex<System>::type::template holds<Function>;
  else
    return std::is_same_v<Number, double> && linked_functions<System>::type::template holds<Function>;
}

/// The code of a function in the library of its model; declared here only.
template <class Number, class Function, int alignment = EIGEN_MAX_STATIC_ALIGN_BYTES>
struct linked_instance : instance<Number, Function, alignment> {
  using typename instance<Number, Function, alignment>::vectors;
  using typename instance<Number, Function, alignment>::results;
  static results evaluate(const Number& t, const typename vectors::state& x,
                          const typename vectors::parameters& p, const typename vectors::inputs& r) noexcept;
  static std::uint64_t digest() noexcept;
};
template <class Number, class Function, int alignment = EIGEN_MAX_STATIC_ALIGN_BYTES>
struct linked_instance_at_rates : instance_at_rates<Number, Function, alignment> {
  using typename instance_at_rates<Number, Function, alignment>::vectors;
  using typename instance_at_rates<Number, Function, alignment>::results;
  static results evaluate(const Number& t, const typename vectors::state& x,
                          const typename vectors::parameters& p, const typename vectors::inputs& r,
                          const typename vectors::rates& a) noexcept;
};

/// A function of a linked model. It is called as `function` is, and each result has a status. An argument
/// that is left out is not a number where something depends on it.
template <class Function>
struct linked : callable<linked<Function>> {
  using System = typename stated<Function>::System;

  template <class First, class... More>
  static auto called(const First& first, const More&... more) noexcept {
    if constexpr (requires { First::SizeAtCompileTime; }) // a vector, not the time
      return at<typename First::Scalar>(0.0, first, more...);
    else
      return at_time(first, more...);
  }

private:
  template <class Time, class State, class... More>
  static auto at_time(const Time& t, const State& x, const More&... more) noexcept {
    return at<typename State::Scalar>(t, x, more...);
  }

  template <class Number, class Time, class State, class Parameters = parameter_values<System, Number>,
            class Inputs = input_values<System, Number>>
  static auto at(const Time& t, const State& x, const Parameters& p = {}, const Inputs& r = {}) noexcept {
    using v = vectors<System, Number>;
    check_fit<Number, State, Parameters, Inputs>();
    static_assert(is_in_library<System, Number, Function>(),
                  "the library of this model does not hold this result for numbers of this type; write "
                  "function<System, ...> and include <kanexpr/kanexpr.hpp>");
    return linked_instance<Number, Function>::evaluate(
        lower::scalar_math<Number>::from(t), passed<typename v::state>(x), passed<typename v::parameters>(p),
        passed<typename v::inputs>(r));
  }
  template <class Number, class Time, class State, class Parameters, class Inputs, class Accelerations>
  static auto at(const Time& t, const State& x, const Parameters& p, const Inputs& r,
                 const Accelerations& a) noexcept {
    using v = vectors<System, Number>;
    check_fit<Number, State, Parameters, Inputs>();
    static_assert(is_in_library<System, Number, Function, true>(),
                  "the library of this model does not hold this result for numbers of this type; write "
                  "function<System, ...> and include <kanexpr/kanexpr.hpp>");
    return linked_instance_at_rates<Number, Function>::evaluate(
        lower::scalar_math<Number>::from(t), passed<typename v::state>(x), passed<typename v::parameters>(p),
        passed<typename v::inputs>(r), passed<typename v::rates>(a));
  }

  template <class Number, class State, class Parameters, class Inputs>
  static void check_fit() {
    static_assert(fitting<System, symbols_of::state, entries_of<State>()>::possible);
    static_assert(fitting<System, symbols_of::parameters, entries_of<Parameters>()>::possible);
    static_assert(fitting<System, symbols_of::inputs, entries_of<Inputs>()>::possible);
    static_assert(belongs<State, symbols_of::state> && belongs<Parameters, symbols_of::parameters> &&
                      belongs<Inputs, symbols_of::inputs>,
                  "a function of this model is given one vector in the place of another, or that of another "
                  "system; call it as f(x, p, r)");
  }
  template <class Given, symbols_of which>
  static constexpr bool belongs =
      decltype(belonging_of(static_cast<const Given*>(nullptr)))::template fits<System, which>;
};

template <class System, auto... wanted>
using linked_result = linked<function<System, wanted...>>;

/// `equations_of_motion` of a linked model.
template <class System>
struct linked_equations : named_results<linked_result, System> {
  using state = kanexpr::state<System>;
  using parameters = parameter_values<System>;
  using inputs = input_values<System>;
  template <auto... wanted>
  using linked = compiled::linked<function<System, wanted...>>;

  static constexpr int coordinates = survey_of<System>.coordinates;
  static constexpr int speeds = survey_of<System>.speeds;

  /// Whether the constraints are solved for a coordinate or speed.
  template <class Symbol>
  static constexpr bool is_dependent(const Symbol&) {
    return survey_of<System>.dependent[place_in<System, symbols_of::state, Symbol>::place];
  }

  /// Several results of one call, as far as the library holds them together: `mass_matrix` with `forcing`,
  /// and both energies.
  template <auto first, auto second>
  static constexpr auto together(linked<first>, linked<second>) {
    return linked<first, second>{};
  }
  template <class... More>
    requires(sizeof...(More) > 2)
  static constexpr void together(More...) {
    static_assert(sizeof...(More) == 2,
                  "the library of this model holds no more than two results together; write "
                  "function<System, ...> and include <kanexpr/kanexpr.hpp>");
  }
};

/// A function that is derived, in a file that derives nothing.
struct not_derived_here {
  template <class... Arguments>
  void operator()(const Arguments&...) const {
    static_assert(sizeof...(Arguments) > 100,
                  "results that the library of a model does not hold are derived where "
                  "they are asked for; include <kanexpr/kanexpr.hpp>");
  }
};

/// `linearization` of a linked model.
template <class System>
struct linked_linearization {
  using of = mechanics::quantity;
  using state = kanexpr::state<System>;
  using parameters = parameter_values<System>;
  using inputs = input_values<System>;
  template <auto... wanted>
  using linked = compiled::linked<finite_function<System, wanted...>>;

  static constexpr int states = survey_of<System>.states();

  static constexpr linked<of::state_matrix, of::input_matrix> explicit_form{};
  static constexpr linked<of::implicit_mass_matrix, of::implicit_state_matrix, of::implicit_input_matrix>
      implicit_form{};
  static constexpr linked<of::state_jacobian, of::input_jacobian> jacobian{};
};

} // namespace compiled

} // namespace kanexpr
