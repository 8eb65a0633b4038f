#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/compiled/not_finite.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/least_multipliers.hpp>

#include <Eigen/Core>
#include <type_traits>

namespace kanexpr {

namespace steps {

/// The equations that `constrained_motion` evaluates to find the multipliers of a system at a state: all
/// velocity constraints, followed by the redundant ones.
template <class System, class Number, class Parameters, class Inputs>
class bound_equations {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  using quantity = mechanics::quantity;
  static constexpr int m = known.constraints, redundant = known.redundant_constraints;

public:
  using number = Number;
  static constexpr int fixed_coordinates = known.coordinates, fixed_speeds = known.speeds,
                       fixed_rows_of_coordinates = 0, fixed_rows_of_speeds = m + redundant;
  using state = Eigen::Matrix<Number, known.coordinates + known.speeds, 1>;

  bound_equations(Number t, const Parameters& p, const Inputs& r) : t_(t), p_(p), r_(r) {}

  static constexpr int coordinates() { return fixed_coordinates; }
  static constexpr int speeds() { return fixed_speeds; }
  static constexpr int rows_of_coordinates() { return 0; }
  static constexpr int rows_of_speeds() { return fixed_rows_of_speeds; }

  template <class Left, class Rows>
  static void configuration(const state&, Left&, Rows&) {}
  template <class Left, class Rows>
  void velocities(const state& x, Left& left, Rows& by_speeds) const {
    if constexpr (m != 0) {
      const auto [kept, by_all] =
          out_of_line<function<System, quantity::velocity_residual, quantity::constraint_jacobian>>{}(t_, x,
                                                                                                      p_, r_);
      left.template head<m>() = kept, by_speeds.template topRows<m>() = by_all;
    }
    if constexpr (redundant != 0) {
      by_speeds.template bottomRows<redundant>() =
          out_of_line<function<System, quantity::redundant_jacobian>>{}(t_, x, p_, r_);
    }
  }
  template <class Rates, class Masses, class Forces, class Biases>
  status motion(const state& x, Rates& qdot, Masses& mass, Forces& force, Biases& bias) const {
    const auto [rates, masses, forces, biases] =
        out_of_line<function<System, quantity::qdot, quantity::unreduced_mass_matrix,
                             quantity::unreduced_forcing, quantity::constraint_bias>>{}(t_, x, p_, r_);
    qdot = rates, mass = masses, force = forces, bias.template head<m>() = biases;
    if constexpr (redundant != 0)
      bias.template tail<redundant>() =
          out_of_line<function<System, quantity::redundant_bias>>{}(t_, x, p_, r_);
    return status_of(biases);
  }

private:
  Number t_;
  const Parameters& p_;
  const Inputs& r_;
};

} // namespace steps

/// Returns u̇ and the multipliers at a state where constraints may be linearly dependent: redundant
/// constraints, or any constraints at a singular position. u̇ is the acceleration that Gauss's principle
/// gives under the constraints at this state; at a bifurcation of a mechanism, the constraints do not
/// determine which branch the motion takes. If the multipliers are not unique, those with the least sum of
/// squares, each in its unit, are returned.
template <class System, class Number = double, class Parameters = parameter_values<System, Number>,
          class Inputs = input_values<System, Number>>
auto find_least_multipliers(const state<System, Number>& x, const Parameters& p = {}, const Inputs& r = {},
                            std::type_identity_t<Number> t = 0) {
  using equations = steps::bound_equations<System, Number, Parameters, Inputs>;
  using vector = typename numeric::constrained_motion<equations>::state;
  auto found =
      numeric::find_least_multipliers(equations(t, p, r), vector(x), compiled::survey_of<System>.constraints);
  if (!found)
    found.failure = base::sentence(
        {compiled::not_finite<System>::cause_of(status(found.failure.view()), x, p, r).view()});
  return found;
}

} // namespace kanexpr
