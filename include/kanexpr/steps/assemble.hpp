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
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/steps/unit_quaternions.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <type_traits>

namespace kanexpr {

namespace steps {

/// The constraints of a system at given arguments, in the form that the numerical methods require. If a
/// constraint is solved for a coordinate of a quaternion, all constraints are evaluated at the normalized
/// quaternion.
template <class System, class Parameters, class Inputs, class Number = double>
class constraints_at {
public:
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  using quantity = mechanics::quantity;
  using quaternions = unit_quaternions<System>;
  using state = kanexpr::state<System, Number>;
  using coordinate_vector = Eigen::Matrix<Number, known.configuration_constraints, 1>;
  using square = Eigen::Matrix<Number, known.configuration_constraints, known.configuration_constraints>;
  using speed_vector = Eigen::Matrix<Number, known.constraints, 1>;
  using square_of_speeds = Eigen::Matrix<Number, known.constraints, known.constraints>;
  using redundant_vector = Eigen::Matrix<Number, known.redundant_constraints, 1>;

  static constexpr bool only_linear = known.nonlinear_constraints == 0;

  constraints_at(Number t, const Parameters& p, const Inputs& r) : t_(t), p_(p), r_(r) {}

  /// The configuration residual with its derivatives with respect to all coordinates. All numerical methods
  /// for constraints share it so that it is compiled only once.
  static constexpr auto configuration() {
    return out_of_line<
        function<System, quantity::configuration_residual, quantity::configuration_jacobian_by_all>>{};
  }
  static constexpr int all_coordinates() { return known.coordinates; }
  static constexpr int coordinates() { return known.configuration_constraints; }
  static constexpr int place_of_coordinate(int i) {
    return dependent_places<System>[static_cast<std::size_t>(i)];
  }

  coordinate_vector configuration_residual(const state& x) const {
    if constexpr (coordinates() == 0)
      return {};
    else
      return std::get<0>(configuration()(t_, at_norm_one(x), p_, r_));
  }
  coordinate_vector configuration_terms(const state& x) const {
    return of_once<quantity::configuration_terms, coordinate_vector>(x);
  }
  square configuration_jacobian_by_all(const state& x) const {
    square by_dependent;
    if constexpr (coordinates() != 0) {
      const state at = at_norm_one(x);
      auto [residual, by_all] = configuration()(t_, at, p_, r_);
      if constexpr (quaternions::are_bound) quaternions::leave_norms_out(by_all, at);
      for (int i = 0; i < coordinates(); ++i) by_dependent.col(i) = by_all.col(place_of_coordinate(i));
    }
    return by_dependent;
  }
  static constexpr bool velocities_are_linear() { return only_linear; }
  static constexpr int dependent_speeds() { return known.constraints; }
  static constexpr int place_of_speed(int i) { return place_of_coordinate(coordinates() + i); }

  speed_vector velocity_residual(const state& x) const {
    return of_once<quantity::velocity_residual, speed_vector>(x);
  }
  square_of_speeds velocity_jacobian_by_dependent(const state& x) const {
    const auto [residual, by_all] =
        out_of_line<function<System, quantity::velocity_residual, quantity::constraint_jacobian>>{}(t_, x, p_,
                                                                                                    r_);
    square_of_speeds by_dependent;
    for (int i = 0; i < dependent_speeds(); ++i)
      by_dependent.col(i) = by_all.col(place_of_speed(i) - all_coordinates());
    return by_dependent;
  }
  speed_vector velocity_terms(const state& x) const {
    return of_once<quantity::velocity_terms, speed_vector>(x);
  }
  redundant_vector redundant_residual(const state& x) const {
    return redundant<quantity::redundant_residual>(x);
  }
  redundant_vector redundant_terms(const state& x) const { return redundant<quantity::redundant_terms>(x); }
  redundant_vector redundant_rate(const state& x) const { return redundant<quantity::redundant_rate>(x); }
  redundant_vector redundant_rate_terms(const state& x) const {
    return redundant<quantity::redundant_rate_terms>(x);
  }
  /// Whether the configuration constraints hold up to rounding.
  bool configuration_holds(const state& x) const {
    return numeric::is_within_rounding(
        configuration_residual(x),
        numeric::typical_terms([&](const state& at) { return configuration_terms(at); }, x,
                               all_coordinates()));
  }
  bool velocities_hold(const state& x) const {
    return numeric::is_within_rounding(
        velocity_residual(x),
        numeric::typical_terms([&](const state& at) { return velocity_terms(at); }, x, all_coordinates()));
  }
  /// Returns the deviations of the quaternion norms from 1.
  Eigen::Matrix<Number, quaternions::count, 1> quaternion_residual(const state& x) const {
    return quaternions::residual(x);
  }
  static base::sentence quaternion_called(int k) { return quaternions::called(k); }
  kanexpr::status normalize_quaternions(state& x) const {
    return quaternions::normalize(x, lower::norm_range{});
  }
  /// Sets the dependent speeds of the state if they can be solved for.
  kanexpr::status solve_speeds(state& x) const {
    if constexpr (known.constraints == 0) {
      return {};
    } else {
      const auto u = of_once<quantity::dependent_speeds>(x);
      if (status_of(u))
        for (int i = 0; i < known.constraints; ++i) x(place_of_speed(i)) = u(i);
      return status_of(u);
    }
  }

  /// If the constraints are not finite, returns a message that names the parameter, input or state entry
  /// that is not set; otherwise, returns an empty message.
  base::sentence gap_before(const state& x) const {
    if (numeric::all_finite(configuration_residual(x)) && numeric::all_finite(velocity_residual(x)))
      return {};
    const bool is_of_list = std::any_of(
        x.begin(), x.end(), [](Number entry) { return compiled::gap_in(entry) >= compiled::gap::never_set; });
    const base::sentence found =
        is_of_list ? compiled::gap_among<System, compiled::symbols_of::state>(x) : base::sentence{};
    return found ? found : compiled::gap_among<System>(p_, r_);
  }

private:
  /// One function returns all quantities that are rarely needed, because each separate function would cost
  /// more compile time than the additional operations. A linked model provides them separately.
  template <quantity wanted>
  auto of_once(const state& x) const {
    if constexpr (compiled::is_linked<System>) {
      return out_of_line<function<System, wanted>>{}(t_, x, p_, r_);
    } else {
      constexpr quantity all[]{quantity::velocity_residual, quantity::velocity_terms,
                               quantity::dependent_speeds, quantity::configuration_terms};
      constexpr auto place =
          static_cast<std::size_t>(std::find(std::begin(all), std::end(all), wanted) - all);
      if constexpr (coordinates() == 0)
        return std::get<place>(out_of_line<function<System, all[0], all[1], all[2]>>{}(t_, x, p_, r_));
      else
        return std::get<place>(
            out_of_line<function<System, all[0], all[1], all[2], all[3]>>{}(t_, x, p_, r_));
    }
  }

  /// Returns a vector with an entry for each constraint of a kind; empty if there are none.
  template <quantity wanted, class Vector>
  Vector of_once(const state& x) const {
    if constexpr (Vector::SizeAtCompileTime == 0)
      return {};
    else
      return of_once<wanted>(x);
  }
  template <quantity wanted>
  redundant_vector redundant(const state& x) const {
    if constexpr (known.redundant_constraints == 0)
      return {};
    else
      return out_of_line<function<System, wanted>>{}(t_, x, p_, r_);
  }

  static decltype(auto) at_norm_one(const state& x) {
    if constexpr (quaternions::are_bound) {
      state at = x;
      quaternions::normalize(at, lower::norm_range{});
      return at;
    } else {
      return (x);
    }
  }

  Number t_;
  const Parameters& p_;
  const Inputs& r_;
};

} // namespace steps

/// Normalizes the quaternions, solves the configuration constraints for the dependent coordinates by Newton's
/// method, starting from their values in `x`, then solves the velocity constraints for the dependent speeds,
/// also by Newton's method from their values in `x` if the constraints are not linear in the speeds. On
/// failure, `x` is unchanged and the report contains the cause. The function neither allocates nor throws.
template <class System, class Number = double, class Parameters = parameter_values<System, Number>,
          class Inputs = input_values<System, Number>>
assembly assemble(state<System, Number>& x, const Parameters& p = {}, const Inputs& r = {},
                  std::type_identity_t<Number> t = 0, const assembly_options& options = {}) {
  const steps::constraints_at<System, Parameters, Inputs, Number> constraints(t, p, r);
  assembly report = numeric::assemble(constraints, x, options);
  if (report) return report;
  if (const base::sentence found = constraints.gap_before(x)) report.failure = found;
  return report;
}

/// Checks whether a state satisfies the constraints within `tolerance`, relative to the magnitude of their
/// terms, and whether its quaternions have norm 1. The default tolerance is 1e-9, or 1e-5 for `float`. If a
/// check fails, the report names the violated constraint and its residual.
template <class System, class Number = double, class Parameters = parameter_values<System, Number>,
          class Inputs = input_values<System, Number>>
consistency check_consistency(const state<System, Number>& x, const Parameters& p = {}, const Inputs& r = {},
                              std::type_identity_t<Number> t = 0,
                              double tolerance = sizeof(Number) < sizeof(double) ? 1e-5 : 1e-9) {
  const steps::constraints_at<System, Parameters, Inputs, Number> constraints(t, p, r);
  consistency report = numeric::check_consistency(constraints, x, tolerance);
  if (report) return report;
  if (const base::sentence found = constraints.gap_before(x)) report.failure = found;
  return report;
}

} // namespace kanexpr
