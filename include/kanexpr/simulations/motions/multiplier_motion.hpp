#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/simulations/motions/input_sensitivity.hpp>
#include <kanexpr/simulations/motions/motion.hpp>

#include <Eigen/Core>
#include <complex>

namespace kanexpr::simulations {

/// The equations of all speeds with the multipliers λ of the constraints, as F(t, y, ẏ) = 0 in y = [q; u; λ;
/// μ]:
///
///     q̇ − q̇(q, u) − Φ_qᵀ μ = 0,  F_r + F_r* + Jᵀ λ = 0,  J u + c = 0,  Φ = 0.
///
/// Coordinates and speeds both satisfy their constraints; μ, which is zero in the solution, makes this
/// possible (Gear, Gupta & Leimkuhler 1985). Quaternion norms are omitted: a multiplier for each takes three
/// times as many evaluations and gains nothing.
class multiplier_motion final : public motion<simulations::implicit_problem> {
public:
  explicit multiplier_motion(simulation_context& context)
      : motion(context, context.known().constraints + context.known().configuration_constraints),
        sensitivity_(context) {}

  bool is_algebraic(int entry) const override { return entry >= states_; }

  /// Sets y and ydot to a state with its multipliers and to their rates; the rates of the multipliers are
  /// zero.
  answer start(double elapsed, const vector& x, double* y, double* ydot) {
    const double t = context_.time(elapsed);
    if (const answer a = context_.set_state(t, x); a != answer::success) return a;
    Eigen::Map<vector> values(y, entries_), rates(ydot, entries_);
    values.setZero(), rates.setZero();
    values.head(states_) = x;
    if (const status s = context_.rates(t, ydot); !s) return context_.fail(s);
    if (context_.known().constraints != 0)
      context_.system().evaluate(results::multipliers, t, x.data(), context_.r().data(), {y + states_});
    constexpr const char* not_finite = "the rates at this state are not finite";
    const answer a = context_.check_finite(values, not_finite);
    return a == answer::success ? context_.check_finite(rates, not_finite) : a;
  }

  bool has_manifold() const override { return context_.known().quaternions != 0; }

  answer residual(double elapsed, const double* y, const double* ydot, double* left) override {
    const double t = context_.time(elapsed);
    if (const answer a = begin_rates(t, y); a != answer::success) return a;
    if (const status s = context_.system().implicit(t, y, ydot, context_.r().data(), left); !s)
      return context_.fail(s);
    return context_.check_finite(Eigen::Map<vector>(left, entries_),
                                 "the equations of motion are not finite");
  }

  bool has_jacobian() const override { return true; }
  /// Exact, by complex steps in each entry of y and, scaled by c, of ẏ.
  answer jacobian(double elapsed, double c, const double* y, const double* ydot, double* columns) override {
    const double t = context_.time(elapsed);
    if (const answer a = context_.set_state(t, y); a != answer::success) return a;
    const int inputs = context_.known().inputs;
    if (inputs != 0)
      if (const answer a = sensitivity_.find(t, context_); a != answer::success) return a;
    Eigen::VectorXcd at = Eigen::Map<const vector>(y, entries_),
                     rate = Eigen::Map<const vector>(ydot, entries_);
    Eigen::VectorXcd left(entries_);
    constexpr double step = 1e-100;
    for (int j = 0; j < entries_; ++j) {
      Eigen::VectorXcd r = context_.r();
      if (j < states_)
        for (int i = 0; i < inputs; ++i) r(i).imag(step * sensitivity_.by_state()(i, j));
      at(j).imag(step), rate(j).imag(c * step);
      const status s = context_.system().implicit(t, at.data(), rate.data(), r.data(), left.data());
      if (!s) return context_.fail(s);
      for (int i = 0; i < entries_; ++i) columns[j * entries_ + i] = left(i).imag() / step;
      at(j) = y[j], rate(j) = ydot[j];
    }
    return check_derivatives(columns);
  }

private:
  input_sensitivity sensitivity_;
};

} // namespace kanexpr::simulations
