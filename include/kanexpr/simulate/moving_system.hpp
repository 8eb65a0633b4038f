#pragma once

#include <kanexpr/simulate/explicit_motion.hpp>
#include <kanexpr/simulate/integrator.hpp>
#include <kanexpr/simulate/multiplier_motion.hpp>
#include <kanexpr/simulate/sundials/arkode.hpp>
#include <kanexpr/simulate/sundials/cvode.hpp>
#include <kanexpr/simulate/sundials/ida.hpp>

#include <optional>

namespace kanexpr::simulated {

/// A system with the integrator that moves it.
template <integrator by>
class moving_system {
public:
  static constexpr bool is_implicit = by == integrator::differential_algebraic;
  static constexpr bool has_newton = by == integrator::bdf || by == integrator::implicit_runge_kutta;
  using motion_type =
      std::conditional_t<is_implicit, multiplier_motion<surroundings>, explicit_motion<has_newton>>;

  explicit moving_system(surroundings& around) : motion(around) {}

  /// Sets the integrator up at the start of the span; where that fails the stepper, or the surroundings, know
  /// why.
  answer start(const Eigen::VectorXd& x, const solvers::stepper_options& options) {
    std::vector<double> y(static_cast<std::size_t>(motion.size()));
    if constexpr (is_implicit) {
      std::vector<double> ydot(y.size());
      if (const answer a = motion.start(0, x, y.data(), ydot.data()); a != answer::given) return a;
      solvers::stepper_options all = options;
      constexpr double any = 1e100; // multipliers, in whatever units: no test looks at them
      all.absolute_tolerances.resize(y.size(), any);
      integrating_.emplace(motion, 0, y, ydot, all);
    } else {
      std::ranges::copy(x, y.begin());
      integrating_.emplace(formulas, motion, 0, y, options);
    }
    return answer::given;
  }

  solvers::stepper& stepper() { return *integrating_; }

  /// Goes on from another state, and from no later time.
  bool restart(double elapsed, const Eigen::VectorXd& x) {
    solvers::stepper& s = stepper();
    s.go_back_to(elapsed);
    if constexpr (is_implicit) {
      if (motion.start(elapsed, x, s.state(), s.rates()) != answer::given) return false;
    } else {
      std::ranges::copy(x, s.state());
    }
    return s.restart();
  }

  motion_type motion;

private:
  static constexpr auto formulas_of() {
    if constexpr (by == integrator::adams)
      return solvers::cvode::formulas::adams;
    else if constexpr (by == integrator::bdf)
      return solvers::cvode::formulas::backward_differences;
    else if constexpr (by == integrator::implicit_runge_kutta)
      return solvers::arkode::formulas::implicit_stages;
    else
      return solvers::arkode::formulas::explicit_stages;
  }
  static constexpr auto formulas = formulas_of();
  using stepper_type = std::conditional_t<
      is_implicit, solvers::ida,
      std::conditional_t<by == integrator::adams || by == integrator::bdf, solvers::cvode, solvers::arkode>>;

  std::optional<stepper_type> integrating_{};
};

} // namespace kanexpr::simulated
