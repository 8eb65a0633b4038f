#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/steps/methods.hpp>
#include <kanexpr/steps/unit_quaternions.hpp>

#include <Eigen/Core>

namespace kanexpr::steps {

using symbolic::added;

/// Moves a state that nearly satisfies its constraints back onto them with a fixed amount of work: it
/// normalizes the quaternions, takes `corrections` Newton steps for the dependent coordinates, then solves
/// for the dependent speeds, by as many Newton steps if constraints are not linear in them. The independent
/// coordinates and speeds are unchanged.
template <class System, int newton_steps>
class correction {
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr int unknowns = known.configuration_constraints;
  using eom = equations_of_motion<System>;
  using quantity = mechanics::quantity;
  using quaternions = unit_quaternions<System>;

public:
  static constexpr bool is_needed = newton_steps > 0 && (known.constraints > 0 || quaternions::count > 0);
  /// The number of solutions for the dependent speeds.
  static constexpr int solutions = known.nonlinear_constraints == 0 ? 1 : newton_steps;

  template <class Time, class Number, class Parameters, class Inputs>
  static kanexpr::status apply(const Time& t, state<System, Number>& x, const Parameters& p,
                               const Inputs& r) {
    return steps::correct(at_inputs<Parameters, Inputs>{p, r}, newton_steps, t, x);
  }

  /// Returns the index in the state of a dependent coordinate or, after the coordinates, a dependent speed.
  static constexpr int place(int i) { return dependent_places<System>[static_cast<std::size_t>(i)]; }

  /// Returns the total number of operations in all evaluations and solves.
  static constexpr symbolic::cost cost() {
    symbolic::cost total;
    if constexpr (is_needed) total = added(total, quaternions::cost());
    if constexpr (is_needed && known.constraints > 0)
      total = added(total, eom::dependent_speeds.cost(), solutions);
    if constexpr (is_needed && unknowns > 0) {
      symbolic::cost one = eom::configuration_step.cost();
      if constexpr (quaternions::are_bound) one = added(one, quaternions::cost());
      total = added(total, one, newton_steps);
    }
    return total;
  }

private:
  /// The quantities of a system that the correction evaluates, at constant inputs.
  template <class Parameters, class Inputs>
  struct at_inputs {
    const Parameters& p;
    const Inputs& r;

    template <quantity wanted, class Time, class Number>
    [[gnu::always_inline]] auto get(const Time& t, const state<System, Number>& x) const {
      constexpr auto rows = mechanics::row_of(wanted).rows;
      if constexpr (known.count(rows) == 0)
        return Eigen::Matrix<Number, 0, 1>();
      else
        return out_of_line<function<System, wanted>>{}(t, x, p, r);
    }
    template <class Number>
    [[gnu::always_inline]] kanexpr::status normalize(state<System, Number>& x) const {
      return quaternions::normalize(x, near_one);
    }
    static constexpr bool quaternions_are_bound() { return quaternions::are_bound; }
    static constexpr bool velocities_are_linear() { return known.nonlinear_constraints == 0; }
    static constexpr int dependent(int i) { return place(i); }
  };
};

} // namespace kanexpr::steps
