#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/steps/unit_quaternions.hpp>

#include <Eigen/Core>

namespace kanexpr::steps {

/// The constraints whose equations are evaluated: the configuration constraints with the norms of quaternions
/// and the velocity constraints, or all velocity constraints, the redundant ones last.
enum class unreduced_rows { configuration_and_velocities, all_velocities };

/// The equations for all speeds that `constrained_motion` evaluates, at a given time and with constant
/// inputs.
template <class System, class Number, class Parameters, class Inputs, unreduced_rows rows>
class unreduced_equations {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  using quantity = mechanics::quantity;
  using quaternions = unit_quaternions<System>;
  static constexpr bool has_configuration = rows == unreduced_rows::configuration_and_velocities;
  static constexpr int l = has_configuration ? known.configuration_constraints : 0,
                       norms = has_configuration ? quaternions::count : 0, m = known.constraints,
                       redundant = has_configuration ? 0 : known.redundant_constraints;

public:
  using number = Number;
  static constexpr int fixed_coordinates = known.coordinates, fixed_speeds = known.speeds,
                       fixed_rows_of_coordinates = l + norms, fixed_rows_of_speeds = m + redundant;
  static constexpr bool only_linear = known.nonlinear_constraints == 0;
  using state = Eigen::Matrix<Number, known.coordinates + known.speeds, 1>;

  unreduced_equations(Number t, const Parameters& p, const Inputs& r) : t_(t), p_(p), r_(r) {}
  /// Sets the time and the inputs.
  void go_to(Number t, const Inputs& r) { t_ = t, r_ = r; }

  static constexpr int coordinates() { return fixed_coordinates; }
  static constexpr int speeds() { return fixed_speeds; }
  static constexpr int rows_of_coordinates() { return fixed_rows_of_coordinates; }
  static constexpr int rows_of_speeds() { return fixed_rows_of_speeds; }

  static constexpr bool velocities_are_linear() { return only_linear; }

  template <class Left, class Rows>
  void configuration(const state& x, Left& left, Rows& by_coordinates) const {
    if constexpr (l != 0) {
      const auto [kept, by_all] =
          evaluate<quantity::configuration_residual, quantity::configuration_jacobian_by_all>(x);
      left.template head<l>() = kept, by_coordinates.template topRows<l>() = by_all;
    }
    if constexpr (norms != 0) {
      left.template tail<norms>() = quaternions::residual(x);
      by_coordinates.template bottomRows<norms>() = quaternions::jacobian(x);
    }
  }
  template <class Left, class Rows>
  void velocities(const state& x, Left& left, Rows& by_speeds) const {
    if constexpr (m != 0) {
      const auto [kept, by_all] = evaluate<quantity::velocity_residual, quantity::constraint_jacobian>(x);
      left.template head<m>() = kept, by_speeds.template topRows<m>() = by_all;
    }
    if constexpr (redundant != 0)
      by_speeds.template bottomRows<redundant>() = evaluate<quantity::redundant_jacobian>(x);
  }
  template <class Rates, class Masses, class Forces, class Biases>
  status motion(const state& x, Rates& qdot, Masses& mass, Forces& force, Biases& bias) const {
    const auto [rates, masses, forces, biases] =
        evaluate<quantity::qdot, quantity::unreduced_mass_matrix, quantity::unreduced_forcing,
                 quantity::constraint_bias>(x);
    qdot = rates, mass = masses, force = forces, bias.template head<m>() = biases;
    if constexpr (redundant != 0) bias.template tail<redundant>() = evaluate<quantity::redundant_bias>(x);
    return status_of(biases);
  }

private:
  template <quantity... wanted>
  auto evaluate(const state& x) const {
    return out_of_line<function<System, wanted...>>{}(t_, x, p_, r_);
  }

  Number t_;
  const Parameters& p_;
  Inputs r_;
};

} // namespace kanexpr::steps
