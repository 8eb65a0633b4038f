#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulate/motions/input_sensitivity.hpp>
#include <kanexpr/simulate/constraints/manifold.hpp>
#include <kanexpr/simulate/motions/simulation_context.hpp>

namespace kanexpr::simulated {

/// ẋ of a system in the form that the integrators require.
template <bool with_jacobian>
class explicit_motion final : public solvers::explicit_problem {
public:
  explicit explicit_motion(surroundings& around) : around_(around), manifold_(around.constraints()) {}
  explicit_motion(const explicit_motion&) = delete;
  explicit_motion& operator=(const explicit_motion&) = delete;

  long rate_evaluations() const { return rate_evaluations_; }
  long projections() const { return projections_; }

  int size() const override { return around_.system().states(); }
  int watched() const override { return static_cast<int>(around_.events().size()); }
  answer watch(double elapsed, const double* y, double* values) override {
    return around_.watch(around_.time(elapsed), y, values);
  }
  int direction(int i) const override { return around_.direction(i); }

  answer rates(double elapsed, const double* y, double* ydot) override {
    const double t = around_.time(elapsed);
    ++rate_evaluations_;
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    if (const status s = around_.rates(t, ydot); !s) return around_.refuse(s);
    for (int i = 0; i < size(); ++i)
      if (!numeric::is_finite(ydot[i]))
        return around_.refuse("the rate of " + around_.name_of_state(i) + " is not finite");
    return answer::given;
  }

  bool has_jacobian() const override { return with_jacobian; }
  answer jacobian(double elapsed, const double* y, double* columns) override {
    if constexpr (with_jacobian) return jacobian_at(around_.time(elapsed), y, columns);
    return answer::never;
  }

  bool has_constraints() const override { return manifold_ != nullptr; }
  answer project(double elapsed, const double* y, const double* weights, double* out,
                 double* error) override {
    const double t = around_.time(elapsed);
    ++projections_;
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    if (!manifold_->project(t, around_.x(), around_.r(), Eigen::Map<const Eigen::VectorXd>(weights, size())))
      return around_.refuse("the constraints are dependent or inconsistent near this state");
    std::copy_n(manifold_->correction().data(), size(), out);
    if (error != nullptr) manifold_->project_error(error);
    return answer::given;
  }

private:
  answer jacobian_at(double t, const double* y, double* columns) {
    if (around_.is_near_singular()) return differences_at(t, y, columns);
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    Eigen::MatrixXd by_inputs(size(), around_.known().inputs);
    const status s =
        around_.system().jacobian(t, around_.x().data(), around_.r().data(), columns, by_inputs.data());
    if (!s) return around_.refuse(s);
    Eigen::Map<Eigen::MatrixXd> out(columns, size(), size());
    if (by_inputs.cols() != 0) {
      input_sensitivity sensitivity(around_);
      if (const answer a = sensitivity.find(t, around_); a != answer::given) return a;
      if (around_.inputs_depend_on_state()) out += by_inputs.lazyProduct(sensitivity.by_state());
    }
    return numeric::all_finite(out) ? answer::given
                                    : around_.refuse("the derivatives of the motion are not finite");
  }

  /// Near a singular position the rates have no analytic derivatives, so differences are used. At a perturbed
  /// state there may be no state on the constraints, or one on a different branch of the mechanism; Newton's
  /// method then omits the derivative in that direction.
  answer differences_at(double t, const double* y, double* columns) {
    const Eigen::Map<const Eigen::VectorXd> from(y, size());
    Eigen::VectorXd beside = from, here(size()), before(size()), after(size());
    if (const answer a = around_.take(t, from); a != answer::given) return a;
    if (const status s = around_.rates(t, here.data()); !s) return around_.refuse(s);
    for (int j = 0; j < size(); ++j) {
      const double step = 1e-5 * around_.sizes()(j);
      bool is_smooth = true;
      for (const double side : {-1, 1}) {
        beside(j) = from(j) + side * step;
        if (const answer a = around_.take(t, beside); a != answer::given) return a;
        is_smooth = is_smooth && around_.rates(t, (side < 0 ? before : after).data());
      }
      beside(j) = from(j);
      is_smooth = is_smooth && beside_sizes(after - 2 * here + before) <= beside_sizes(after - before) / 2;
      for (int i = 0; i < size(); ++i)
        columns[j * size() + i] = is_smooth ? (after(i) - before(i)) / (2 * step) : 0;
    }
    return answer::given;
  }
  double beside_sizes(const Eigen::VectorXd& rates) const {
    return rates.cwiseQuotient(around_.sizes()).norm();
  }

  surroundings& around_;
  manifold* manifold_;
  long rate_evaluations_ = 0, projections_ = 0;
};

} // namespace kanexpr::simulated
