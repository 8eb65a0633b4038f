#pragma once

#include <kanexpr/base/statistics.hpp>
#include <kanexpr/simulations/motions/motion.hpp>
#include <kanexpr/simulations/sundials/arkode.hpp>
#include <kanexpr/simulations/sundials/cvode.hpp>
#include <kanexpr/simulations/sundials/ida.hpp>

#include <Eigen/Core>
#include <optional>
#include <type_traits>
#include <vector>

namespace kanexpr::simulations {

/// A motion with its integrator, which is created when it is first needed.
template <class Motion, class Integrator>
struct integrated {
  explicit integrated(simulation_context& context) : motion(context) {}

  Motion motion;
  std::optional<Integrator> integrator{};
};

/// A system together with its integrator. `differential_algebraic` uses the equations with multipliers; near
/// singular positions, where the multipliers are indeterminate, backward differentiation of the rates
/// replaces them.
template <integrator by>
class moving_system {
  static constexpr bool has_multipliers = by == integrator::differential_algebraic;

public:
  /// The distinctness of the constraints below which the equations for all speeds are used. Multipliers lose
  /// accuracy sooner.
  static constexpr double least_distinctness = has_multipliers ? 0.2 : 0.05;

  explicit moving_system(simulation_context& context)
      : context_(context), by_rates_(context), by_multipliers_(context) {}

  /// Sets up the integrator at the start of the span; on failure the stepper or the context reports
  /// the cause.
  answer start(const Eigen::VectorXd& x, const stepper_options& options) {
    options_ = options;
    uses_rates_ = needs_rates();
    return begin(0, x);
  }

  simulations::stepper& stepper() {
    if constexpr (has_multipliers)
      if (!uses_rates_) return *by_multipliers_.integrator;
    return *by_rates_.integrator;
  }

  /// Restarts from a different state, at the same or an earlier time.
  bool restart(double elapsed, const Eigen::VectorXd& x) {
    uses_rates_ = needs_rates();
    if (!has_integrator()) return begin(elapsed, x) == answer::success && stepper().failure().empty();
    simulations::stepper& s = stepper();
    s.go_back_to(elapsed);
    if (uses_rates_)
      std::ranges::copy(x, s.state());
    else if constexpr (has_multipliers)
      if (by_multipliers_.motion.start(elapsed, x, s.state(), s.rates()) != answer::success) return false;
    return s.restart();
  }
  /// Whether a different integrator has to continue from the end of the last step.
  bool has_to_change() const { return uses_rates_ != needs_rates(); }

  void set_tolerances(double relative, const std::vector<double>& absolute) {
    options_.relative_tolerance = relative;
    options_.absolute_tolerances = absolute;
    for_each(*this, [&](auto& each) {
      if (each.integrator) each.integrator->set_tolerances(relative, absolute);
    });
  }

  integration_statistics statistics() const {
    integration_statistics all;
    for_each(*this, [&](const auto& each) {
      all.rate_evaluations += each.motion.rate_evaluations();
      all.projections += each.motion.projections();
      if (!each.integrator) return;
      const integration_statistics own = each.integrator->statistics();
      all.steps += own.steps;
      all.error_test_failures += own.error_test_failures;
      all.solver_failures += own.solver_failures;
      all.jacobian_evaluations += own.jacobian_evaluations;
    });
    return all;
  }
  long steps() const { return statistics().steps; }

private:
  static constexpr auto formulas_of() {
    if constexpr (by == integrator::adams)
      return cvode::formulas::adams;
    else if constexpr (by == integrator::explicit_runge_kutta)
      return arkode::formulas::explicit_stages;
    else if constexpr (by == integrator::implicit_runge_kutta)
      return arkode::formulas::implicit_stages;
    else
      return cvode::formulas::backward_differences;
  }
  using formulas = decltype(formulas_of());
  using rate_integrator = std::conditional_t<std::is_same_v<formulas, cvode::formulas>, cvode, arkode>;
  /// Replaces the motion with multipliers in all other methods.
  struct nothing {
    explicit nothing(simulation_context&) {}
  };

  bool needs_rates() const { return !has_multipliers || context_.is_near_singular(); }
  bool has_integrator() const {
    if constexpr (has_multipliers)
      if (!uses_rates_) return by_multipliers_.integrator.has_value();
    return by_rates_.integrator.has_value();
  }

  /// Creates the integrator that the current position requires.
  answer begin(double elapsed, const Eigen::VectorXd& x) {
    if constexpr (has_multipliers)
      if (!uses_rates_) return begin_with_multipliers(elapsed, x);
    by_rates_.integrator.emplace(formulas_of(), by_rates_.motion, elapsed,
                                 std::vector<double>(x.begin(), x.end()), options_);
    return answer::success;
  }
  answer begin_with_multipliers(double elapsed, const Eigen::VectorXd& x) {
    auto& [motion, integrator] = by_multipliers_;
    std::vector<double> y(static_cast<std::size_t>(motion.size())), ydot(y.size());
    if (const answer a = motion.start(elapsed, x, y.data(), ydot.data()); a != answer::success) return a;
    stepper_options all = options_;
    constexpr double any = 1e100; // for multipliers, which are excluded from the error test
    all.absolute_tolerances.resize(y.size(), any);
    integrator.emplace(motion, elapsed, y, ydot, all);
    return answer::success;
  }

  template <class Self, class Function>
  static void for_each(Self& self, const Function& f) {
    f(self.by_rates_);
    if constexpr (has_multipliers) f(self.by_multipliers_);
  }

  simulation_context& context_;
  stepper_options options_{};
  integrated<explicit_motion<has_newton(by) || has_multipliers>, rate_integrator> by_rates_;
  std::conditional_t<has_multipliers, integrated<multiplier_motion<>, ida>, nothing> by_multipliers_;
  bool uses_rates_ = true;
};

} // namespace kanexpr::simulations
