#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/motions/input_sensitivity.hpp>
#include <kanexpr/simulations/motions/motion.hpp>

#include <Eigen/Core>

namespace kanexpr::simulations {

/// ẋ of a system in the form that the integrators require.
template <bool with_jacobian>
class explicit_motion final : public motion<simulations::explicit_problem> {
public:
  explicit explicit_motion(simulation_context& context) : motion(context, 0) {}

  answer rates(double elapsed, const double* y, double* ydot) override {
    const double t = context_.time(elapsed);
    if (const answer a = begin_rates(t, y); a != answer::success) return a;
    if (const status s = context_.rates(t, ydot); !s) return context_.fail(s);
    for (int i = 0; i < size(); ++i)
      if (!numeric::is_finite(ydot[i]))
        return context_.fail("the rate of " + context_.name_of_state(i) + " is not finite");
    return answer::success;
  }

  bool has_jacobian() const override { return with_jacobian; }
  answer jacobian(double elapsed, const double* y, double* columns) override {
    if constexpr (with_jacobian) return jacobian_at(context_.time(elapsed), y, columns);
    return answer::unrecoverable;
  }

  bool has_manifold() const override { return manifold_ != nullptr; }

private:
  answer jacobian_at(double t, const double* y, double* columns) {
    if (context_.is_near_singular()) return differences_at(t, y, columns);
    if (const answer a = context_.set_state(t, y); a != answer::success) return a;
    Eigen::MatrixXd by_inputs(size(), context_.known().inputs);
    const status s = context_.system().evaluate(results::jacobian, t, context_.x().data(),
                                                context_.r().data(), {columns, by_inputs.data()});
    if (!s) return context_.fail(s);
    Eigen::Map<Eigen::MatrixXd> out(columns, size(), size());
    if (by_inputs.cols() != 0) {
      input_sensitivity sensitivity(context_);
      if (const answer a = sensitivity.find(t, context_); a != answer::success) return a;
      if (context_.inputs_depend_on_state()) out += by_inputs.lazyProduct(sensitivity.by_state());
    }
    return check_derivatives(columns);
  }

  /// Near a singular position the rates have no analytic derivatives, so differences are used. At a perturbed
  /// state there may be no state on the constraints, or one on a different branch of the mechanism; Newton's
  /// method then omits the derivative in that direction.
  answer differences_at(double t, const double* y, double* columns) {
    const Eigen::Map<const Eigen::VectorXd> from(y, size());
    Eigen::VectorXd nearby = from, here(size()), before(size()), after(size());
    if (const answer a = context_.set_state(t, from); a != answer::success) return a;
    if (const status s = context_.rates(t, here.data()); !s) return context_.fail(s);
    for (int j = 0; j < size(); ++j) {
      const double step = 1e-5 * context_.sizes()(j);
      bool is_smooth = true;
      for (const double side : {-1, 1}) {
        nearby(j) = from(j) + side * step;
        if (const answer a = context_.set_state(t, nearby); a != answer::success) return a;
        is_smooth = is_smooth && context_.rates(t, (side < 0 ? before : after).data());
      }
      nearby(j) = from(j);
      is_smooth =
          is_smooth && relative_to_sizes(after - 2 * here + before) <= relative_to_sizes(after - before) / 2;
      for (int i = 0; i < size(); ++i)
        columns[j * size() + i] = is_smooth ? (after(i) - before(i)) / (2 * step) : 0;
    }
    return answer::success;
  }
  double relative_to_sizes(const Eigen::VectorXd& rates) const {
    return rates.cwiseQuotient(context_.sizes()).norm();
  }
};

} // namespace kanexpr::simulations
