#pragma once

#include <kanexpr/steps/assemble.hpp>
#include <kanexpr/steps/unit_quaternions.hpp>

#include <utility>

namespace kanexpr::simulated {

/// What the coordinates keep to in a motion: the configuration constraints, then norm 1 of quaternions.
template <class System>
struct configuration_manifold {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr int constraints = known.configuration_constraints, quaternions = known.quaternions;
  static constexpr int equations = constraints + quaternions;

  template <class T>
  struct values {
    Eigen::Matrix<T, equations, 1> residual;
    Eigen::Matrix<T, equations, known.coordinates> by_coordinates;
  };

  template <class T, class X, class P, class R>
  static values<T> at(double t, const X& x, const P& p, const R& r) {
    values<T> all;
    if constexpr (constraints != 0) {
      using equations_at = compiled::constraints_at<System, parameter_values<System>, input_values<System>>;
      const auto [residual, by_coordinates] = equations_at::configuration()(t, x, p, r);
      all.residual.template head<constraints>() = residual;
      all.by_coordinates.template topRows<constraints>() = by_coordinates;
    }
    if constexpr (quaternions != 0) {
      all.residual.template tail<quaternions>() = compiled::unit_quaternions<System>::residual(x);
      all.by_coordinates.template bottomRows<quaternions>() = compiled::unit_quaternions<System>::jacobian(x);
    }
    static_cast<void>(t), static_cast<void>(p), static_cast<void>(r);
    return all;
  }
};

} // namespace kanexpr::simulated
