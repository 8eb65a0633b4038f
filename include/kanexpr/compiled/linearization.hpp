#pragma once

#include <kanexpr/compiled/finite_function.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/request_kinds.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <Eigen/Core>
#include <array>

namespace kanexpr {

/// A system linearized about any operating point that satisfies its constraints, as compiled functions of the
/// state, the parameters and the inputs: `const auto [A, B] = linearization<System>::explicit_form(x, p, r);`
///
/// The states are the independent coordinates followed by the independent speeds; the inputs are all symbols
/// other than states, parameters and time, including prescribed quantities and their derivatives. The
/// derivatives are exact.
template <class System>
struct linearization {
  using quantity = mechanics::quantity;
  static constexpr const derivation::survey& known = compiled::survey_of<System>;

  using state = kanexpr::state<System>;
  using parameters = parameter_values<System>;
  using inputs = input_values<System>;

  static constexpr int states = known.states();

  /// A and B in δẋ_i = A δx_i + B δr.
  static constexpr finite_function<System, quantity::state_matrix, quantity::input_matrix> explicit_form{};

  /// M, A and B in M δ[q̇; u̇; λ] = A δx_i + B δr. The rows are the kinematic differential equations, the
  /// rates of the constraints, and the dynamics: with Kane's method those for the independent speeds, with
  /// Lagrange's method those for all speeds with the multipliers λ.
  static constexpr finite_function<System, quantity::implicit_mass_matrix, quantity::implicit_state_matrix,
                                   quantity::implicit_input_matrix>
      implicit_form{};

  /// The same matrices at known rates of the speeds: f(x, p, r, udot).
  static constexpr finite_function<System, derivation::at_given_rates{quantity::state_matrix},
                                   derivation::at_given_rates{quantity::input_matrix}>
      explicit_form_at{};
  static constexpr finite_function<System, derivation::at_given_rates{quantity::implicit_mass_matrix},
                                   derivation::at_given_rates{quantity::implicit_state_matrix},
                                   derivation::at_given_rates{quantity::implicit_input_matrix}>
      implicit_form_at{};

  /// The derivatives of ẋ = [q̇; u̇], as returned by `equations_of_motion<System>::rhs`, with respect to the
  /// whole state [q; u] and to the inputs: `const auto [by_state, by_inputs] =
  /// linearization<System>::jacobian(x, p, r);`. The state need not satisfy the constraints, and the
  /// derivatives treat its entries as unconstrained, as an integrator of the whole state requires.
  /// Quaternions must have norm 1; in the direction that changes the norm, the derivatives of u̇ are
  /// meaningless.
  static constexpr finite_function<System, quantity::state_jacobian, quantity::input_jacobian> jacobian{};

  /// C and D in δy = C δx_i + D δr of measured quantities, which are expressions of the model and may contain
  /// velocities and accelerations: `outputs<q1, acceleration_of<P>>(x, p, r)`. A vector contributes one row
  /// per component.
  template <auto... measured>
  static constexpr finite_function<System, derivation::sensitivity<false, measured...>{},
                                   derivation::sensitivity<true, measured...>{}>
      outputs{};

  /// The indices in [q; u] of the states of the linearized equations.
  static constexpr std::array<int, static_cast<std::size_t>(states)> places = [] {
    std::array<int, static_cast<std::size_t>(states)> found{};
    std::size_t next = 0;
    for (int i = 0; i < known.coordinates + known.speeds; ++i)
      if (!known.dependent[i] && next < found.size()) found[next++] = i;
    return found;
  }();

  /// Returns P in [q; u] = P [q_i; u_i; q_d; u_d].
  static Eigen::Matrix<double, known.coordinates + known.speeds, known.coordinates + known.speeds>
  permutation() {
    constexpr int size = known.coordinates + known.speeds;
    Eigen::Matrix<double, size, size> p = Eigen::Matrix<double, size, size>::Zero();
    int column = 0;
    for (const bool dependent : {false, true})
      for (int i = 0; i < size; ++i)
        if (known.dependent[i] == dependent) p(i, column++) = 1;
    return p;
  }

  /// Returns the number of operations of one call of a function.
  template <auto... wanted>
  static constexpr symbolic::cost cost(function<System, wanted...> f) {
    return f.cost();
  }
};

} // namespace kanexpr
