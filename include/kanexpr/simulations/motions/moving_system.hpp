#pragma once

#include <kanexpr/base/statistics.hpp>
#include <kanexpr/simulations/integrator.hpp>
#include <kanexpr/simulations/motions/explicit_motion.hpp>
#include <kanexpr/simulations/motions/multiplier_motion.hpp>
#include <kanexpr/simulations/sundials/arkode.hpp>
#include <kanexpr/simulations/sundials/cvode.hpp>
#include <kanexpr/simulations/sundials/ida.hpp>

#include <Eigen/Core>
#include <optional>
#include <type_traits>
#include <vector>

namespace kanexpr::simulations {

/// A system together with its integrator.
template <integrator by>
class moving_system {
public:
  /// The distinctness of the constraints below which the equations of all speeds are used.
  static constexpr double least_distinctness = 0.05;

  explicit moving_system(simulation_context& context) : motion_(context) {}

  /// Sets up the integrator at the start of the span; on failure the stepper or the context holds the
  /// cause.
  answer start(const Eigen::VectorXd& x, const simulations::stepper_options& options) {
    integrating_.emplace(formulas, motion_, 0, std::vector<double>(x.begin(), x.end()), options);
    return answer::success;
  }

  simulations::stepper& stepper() { return *integrating_; }

  /// Restarts from a different state, at the same or an earlier time.
  bool restart(double elapsed, const Eigen::VectorXd& x) {
    integrating_->go_back_to(elapsed);
    std::ranges::copy(x, integrating_->state());
    return integrating_->restart();
  }
  /// Whether a different integrator has to continue from the end of the last step.
  static bool has_to_change() { return false; }

  void set_tolerances(double relative, const std::vector<double>& absolute) {
    integrating_->set_tolerances(relative, absolute);
  }

  long steps() const { return integrating_->steps(); }
  integration_statistics statistics() const {
    integration_statistics all = integrating_->statistics();
    all.rate_evaluations = motion_.rate_evaluations();
    all.projections = motion_.projections();
    return all;
  }

private:
  static constexpr auto formulas_of() {
    if constexpr (by == integrator::adams)
      return simulations::cvode::formulas::adams;
    else if constexpr (by == integrator::bdf)
      return simulations::cvode::formulas::backward_differences;
    else if constexpr (by == integrator::implicit_runge_kutta)
      return simulations::arkode::formulas::implicit_stages;
    else
      return simulations::arkode::formulas::explicit_stages;
  }
  static constexpr auto formulas = formulas_of();
  using stepper_type = std::conditional_t<by == integrator::adams || by == integrator::bdf,
                                          simulations::cvode, simulations::arkode>;

  explicit_motion<has_newton(by)> motion_;
  std::optional<stepper_type> integrating_{};
};

/// Uses the equations with multipliers; near singular positions, where these are not determined, it uses
/// backward differentiation of the rates.
template <>
class moving_system<integrator::differential_algebraic> {
public:
  static constexpr double least_distinctness = 0.2; ///< multipliers lose digits sooner

  explicit moving_system(simulation_context& context)
      : context_(context), motion_(context), passing_motion_(context) {}

  answer start(const Eigen::VectorXd& x, const simulations::stepper_options& options) {
    options_ = options;
    return begin(0, x);
  }

  simulations::stepper& stepper() {
    return is_passing_ ? static_cast<simulations::stepper&>(*passing_) : *integrating_;
  }

  bool restart(double elapsed, const Eigen::VectorXd& x) {
    const bool has_one = context_.is_near_singular() ? passing_.has_value() : integrating_.has_value();
    if (!has_one) return begin(elapsed, x) == answer::success && !stepper().failed();
    is_passing_ = context_.is_near_singular();
    simulations::stepper& s = stepper();
    s.go_back_to(elapsed);
    if (is_passing_)
      std::ranges::copy(x, s.state());
    else if (motion_.start(elapsed, x, s.state(), s.rates()) != answer::success)
      return false;
    return s.restart();
  }
  bool has_to_change() const { return is_passing_ != context_.is_near_singular(); }

  void set_tolerances(double relative, const std::vector<double>& absolute) {
    options_.relative_tolerance = relative;
    options_.absolute_tolerances = absolute;
    if (integrating_) integrating_->set_tolerances(relative, absolute);
    if (passing_) passing_->set_tolerances(relative, absolute);
  }

  long steps() const {
    return (integrating_ ? integrating_->steps() : 0) + (passing_ ? passing_->steps() : 0);
  }
  integration_statistics statistics() const {
    integration_statistics all;
    const auto add = [&](const simulations::stepper& s) {
      const integration_statistics own = s.statistics();
      all.steps += own.steps;
      all.error_test_failures += own.error_test_failures;
      all.solver_failures += own.solver_failures;
      all.jacobian_evaluations += own.jacobian_evaluations;
    };
    if (integrating_) add(*integrating_);
    if (passing_) add(*passing_);
    all.rate_evaluations = motion_.rate_evaluations() + passing_motion_.rate_evaluations();
    all.projections = motion_.projections() + passing_motion_.projections();
    return all;
  }

private:
  /// Creates the integrator that the current position requires.
  answer begin(double elapsed, const Eigen::VectorXd& x) {
    is_passing_ = context_.is_near_singular();
    if (is_passing_) {
      passing_.emplace(simulations::cvode::formulas::backward_differences, passing_motion_, elapsed,
                       std::vector<double>(x.begin(), x.end()), options_);
      return answer::success;
    }
    std::vector<double> y(static_cast<std::size_t>(motion_.size())), ydot(y.size());
    if (const answer a = motion_.start(elapsed, x, y.data(), ydot.data()); a != answer::success) return a;
    simulations::stepper_options all = options_;
    constexpr double any = 1e100; // for multipliers, which no error test checks
    all.absolute_tolerances.resize(y.size(), any);
    integrating_.emplace(motion_, elapsed, y, ydot, all);
    return answer::success;
  }

  simulation_context& context_;
  multiplier_motion motion_;
  explicit_motion<true> passing_motion_;
  simulations::stepper_options options_{};
  std::optional<simulations::ida> integrating_{};
  std::optional<simulations::cvode> passing_{};
  bool is_passing_ = false;
};

} // namespace kanexpr::simulations
