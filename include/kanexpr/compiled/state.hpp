#pragma once

#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/value_vector.hpp>

namespace kanexpr {

/// The state [q; u; z] of a system, or [q; dq/dt; z] with Lagrange's method, where z are the state variables:
/// a fixed-size Eigen vector with access by name, `x[q1]`, and with Lagrange's method also `x[dot(q1)]`. It
/// is initialized to zero.
template <class System, class Scalar = double>
class state : public compiled::value_vector<System, compiled::symbols_of::state, Scalar> {
public:
  static constexpr int coordinates = compiled::survey_of<System>.coordinates;
  static constexpr int state_variables = compiled::survey_of<System>.state_variables;
  static constexpr int speeds = compiled::survey_of<System>.speeds - state_variables;
  using state::value_vector::value_vector;

  auto q() { return this->template head<coordinates>(); }
  auto q() const { return this->template head<coordinates>(); }
  auto u() { return this->template segment<speeds>(coordinates); }
  auto u() const { return this->template segment<speeds>(coordinates); }
  auto z() { return this->template tail<state_variables>(); }
  auto z() const { return this->template tail<state_variables>(); }
};

/// The parameters of a system that are not bound in its type, with access by name, `p[m]`. Unset parameters
/// are NaN.
template <class System, class Scalar = double>
class parameter_values : public compiled::value_vector<System, compiled::symbols_of::parameters, Scalar> {
public:
  using parameter_values::value_vector::value_vector;
};

/// The inputs of a system, with access by name, `r[T1]`; for prescribed quantities, `r[theta]` and
/// `r[dot(theta)]`. Unset inputs are NaN; `r.setZero()` sets all of them.
template <class System, class Scalar = double>
class input_values : public compiled::value_vector<System, compiled::symbols_of::inputs, Scalar> {
public:
  using input_values::value_vector::value_vector;
};

} // namespace kanexpr
