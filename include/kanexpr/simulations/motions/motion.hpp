#pragma once

#include <kanexpr/simulations/constraints/manifold.hpp>
#include <kanexpr/simulations/motions/simulation_context.hpp>

#include <Eigen/Core>

namespace kanexpr::simulations {

/// The functions of a motion that do not depend on the form of its equations. Its state comes first in the
/// entries of the problem.
template <class Problem>
class motion : public Problem {
public:
  using vector = Eigen::VectorXd;

  motion(const motion&) = delete;
  motion& operator=(const motion&) = delete;

  long rate_evaluations() const { return rate_evaluations_; }
  long projections() const { return projections_; }

  int size() const final { return entries_; }
  int watched() const final { return static_cast<int>(context_.events().size()); }
  answer watch(double elapsed, const double* y, double* values) final {
    return context_.evaluate_events(context_.time(elapsed), y, values);
  }
  int direction(int i) const final { return context_.direction(i); }

  answer project(double elapsed, const double* y, const double* weights, double* out, double* error) final {
    const double t = context_.time(elapsed);
    ++projections_;
    if (const answer a = context_.set_state(t, y); a != answer::success) return a;
    if (!manifold_->project(t, context_.x(), context_.r(), Eigen::Map<const vector>(weights, states_)))
      return context_.fail(off_manifold);
    std::copy_n(manifold_->correction().data(), states_, out);
    if (error != nullptr) manifold_->project_error(error);
    return answer::success;
  }

protected:
  motion(simulation_context& context, int further_entries)
      : context_(context), manifold_(context.constraints()), states_(context.system().states()),
        entries_(states_ + further_entries) {}

  /// Sets the state at the beginning of an evaluation of rates.
  answer begin_rates(double t, const double* y) {
    ++rate_evaluations_;
    return context_.set_state(t, y);
  }
  answer check_derivatives(const double* columns) {
    return context_.check_finite(Eigen::Map<const Eigen::MatrixXd>(columns, entries_, entries_),
                                 "the derivatives of the motion are not finite");
  }

  simulation_context& context_;
  manifold* manifold_;
  const int states_, entries_;

private:
  long rate_evaluations_ = 0, projections_ = 0;
};

} // namespace kanexpr::simulations
