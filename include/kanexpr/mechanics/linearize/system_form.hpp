#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/dynamics/dynamics.hpp>
#include <kanexpr/mechanics/linearize/general_form.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/kinematic_equations.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

/// The equations of a system, by either method, in the general form from which they are linearized.
namespace kanexpr::mechanics {

/// The parts of a system from which its linearized equations are formed.
struct parts_of_system {
  const mechanics::skeleton& skeleton;
  const mechanics::loads& loads;
  const mechanics::constraints& constraints;
  const symbolic::matrix& by_q; ///< the derivatives of the configuration constraints with respect to the
                                ///< coordinates
  const partition &coordinates, &speeds;
  mechanics::dynamics& dynamics;
};

/// Forms the general form, with f_2 = −F_r* of inertia and gravity, f_3 = −F_r of the other loads and f_4 =
/// −Jᵀ λ, so that the mass matrix is positive.
class system_form {
public:
  constexpr explicit system_form(const parts_of_system& of)
      : of_(of), m_(*of.skeleton.model),
        motion_(motion_on_accelerated_ground(of.skeleton, of.loads, m_.speed_rates)) {}

  /// The form for the independent speeds, without multipliers.
  constexpr general_form reduced() {
    general_form form = common();
    form.f_2 = negative(of_.dynamics.reduce(of_.dynamics.inertia_in(motion_)));
    form.f_3 = negative(of_.dynamics.reduce(of_.dynamics.forces_of_loads()));
    of_.dynamics.gather(form.f_2, form.f_3);
    form.known.dependency = of_.dynamics.dependent().on_independent;
    form.known.coupling = of_.dynamics.coupling();
    form.known.mass = of_.dynamics.mass();
    return form;
  }

  /// The form for all speeds, with multipliers.
  constexpr general_form with_multipliers() {
    general_form form = common();
    form.f_2 = negative(of_.dynamics.inertia_in(motion_));
    form.f_3 = negative(of_.dynamics.forces_of_loads());
    for (int i = 0; i < of_.constraints.size(); ++i) {
      name called("lambda");
      called.append(i + 1);
      form.lambda.push(symbolic::variable(*m_.g, {symbolic::symbol_kind::multiplier, called, i}));
    }
    for (sequence<expression>* f : {&form.f_2, &form.f_3})
      f->resize(m_.speeds.size()); // the auxiliary speeds come last
    for (int r = 0; r < m_.speeds.size(); ++r) {
      expression force = m_.zero();
      for (int i = 0; i < of_.constraints.size(); ++i)
        force += of_.constraints.jacobian(i, r) * form.lambda[i];
      form.f_4.push(-force);
    }
    return form;
  }

private:
  constexpr general_form common() {
    general_form form;
    form.q = m_.coordinates, form.qdot = m_.coordinate_rates;
    form.u = m_.speeds, form.udot = m_.speed_rates;
    form.r = m_.inputs;
    form.coordinates = of_.coordinates, form.speeds = of_.speeds;
    take_kinematics(form);
    take_constraints(form);
    return form;
  }

  /// Sets f_0 = K q̇ and f_1 = k.
  constexpr void take_kinematics(general_form& form) {
    without_auxiliary_speeds drop(m_);
    const linear_kinematics k = linear_in_rates(m_);
    for (int i = 0; i < k.k_rates.rows; ++i) {
      expression sum = m_.zero();
      for (int j = 0; j < k.k_rates.columns; ++j) sum += k.k_rates(i, j) * m_.coordinate_rates[j];
      form.f_0.push(sum);
      form.f_1.push(drop.in(k.remainder[i]));
    }
    for (const expression& rate : of_.skeleton.coordinate_rates) form.known.qdot.push(drop.in(rate));
  }

  constexpr void take_constraints(general_form& form) {
    form.f_c = of_.constraints.on_configuration;
    for (const velocity_constraint& each : of_.constraints.on_velocities) form.f_v.push(each.value);
    form.known.on_q = of_.by_q;
    form.known.on_u = form.known.on_udot = of_.constraints.jacobian;
    if (of_.constraints.on_accelerations.empty()) {
      for (int i = 0; i < of_.constraints.size(); ++i)
        form.f_a.push(rate_of_constraint(motion_, of_.constraints, i));
      return;
    }
    known_rates known(m_, of_.skeleton.coordinate_rates);
    for (const expression& e : of_.constraints.on_accelerations) form.f_a.push(known.in(e));
    form.known.on_udot = linear_in_speed_rates(of_.skeleton, of_.constraints).jacobian;
  }

  const parts_of_system of_;
  const mechanism& m_;
  motion motion_;
};

} // namespace kanexpr::mechanics
