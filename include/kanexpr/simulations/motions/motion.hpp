#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/constraints/manifold.hpp>
#include <kanexpr/simulations/motions/simulation_context.hpp>
#include <kanexpr/simulations/sundials/stepper.hpp>
#include <kanexpr/simulations/system_interface.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace kanexpr::simulations {

/// The functions of a motion that do not depend on the form of its equations. The first entries of the
/// problem are the state.
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
        entries_(states_ + further_entries),
        inputs_by_state_(Eigen::MatrixXd::Zero(context.known().inputs, states_)) {}

  /// Sets the state at the beginning of an evaluation of rates.
  answer begin_rates(double t, const double* y) {
    ++rate_evaluations_;
    return context_.set_state(t, y);
  }
  answer check_derivatives(const double* columns) {
    return context_.check_finite(Eigen::Map<const Eigen::MatrixXd>(columns, entries_, entries_),
                                 "the derivatives of the motion are not finite");
  }

  /// Evaluates ∂r/∂x of a controller at the current state, by central differences, since only the values of
  /// its function are available.
  answer differentiate_inputs(double t) {
    if (!context_.inputs_depend_on_state()) return answer::success;
    static const double relative_step = std::cbrt(std::numeric_limits<double>::epsilon());
    const vector x = context_.x();
    for (int j = 0; j < x.size(); ++j) {
      const double step = relative_step * (std::max)(context_.sizes()(j), std::abs(x(j)));
      for (const double side : {1.0, -1.0}) {
        vector nearby = x;
        nearby(j) += side * step;
        if (const answer a = context_.set_state(t, nearby); a != answer::success) return a;
        for (int i = 0; i < inputs_by_state_.rows(); ++i)
          inputs_by_state_(i, j) =
              side > 0 ? context_.r()(i) : (inputs_by_state_(i, j) - context_.r()(i)) / (2 * step);
      }
    }
    return context_.set_state(t, x);
  }

  simulation_context& context_;
  manifold* manifold_;
  const int states_, entries_;
  Eigen::MatrixXd inputs_by_state_;

private:
  long rate_evaluations_ = 0, projections_ = 0;
};

/// The motion of a system as ẋ = f(t, x).
template <bool with_jacobian>
class explicit_motion final : public motion<explicit_problem> {
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
    const status s = context_.system().evaluate(
        results::jacobian, {t, context_.x().data(), context_.r().data()}, {columns, by_inputs.data()});
    if (!s) return has_manifold() ? differences_at(t, y, columns) : context_.fail(s);
    if (by_inputs.cols() != 0 && context_.inputs_depend_on_state()) {
      if (const answer a = differentiate_inputs(t); a != answer::success) return a;
      Eigen::Map<Eigen::MatrixXd>(columns, size(), size()) += by_inputs.lazyProduct(inputs_by_state_);
    }
    return check_derivatives(columns);
  }

  /// Near a singular position the rates have no analytic derivatives, so differences are used. Near a
  /// perturbed state there may be no state that satisfies the constraints, or one on a different branch of
  /// the mechanism; Newton's method then omits the derivative in that direction.
  answer differences_at(double t, const double* y, double* columns) {
    const Eigen::Map<const vector> from(y, size());
    vector nearby = from, here(size()), before(size()), after(size());
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
  double relative_to_sizes(const vector& rates) const { return rates.cwiseQuotient(context_.sizes()).norm(); }
};

/// The equations for all speeds with the multipliers λ of the constraints, as F(t, y, ẏ) = 0 in y = [q; u; λ;
/// μ]:
///
///     q̇ − q̇(q, u) − Φ_qᵀ μ = 0,  F_r + F_r* + Jᵀ λ = 0,  J u + c = 0,  Φ = 0.
///
/// Coordinates and speeds both satisfy their constraints; μ, which is zero in the solution, makes this
/// possible (Gear, Gupta & Leimkuhler 1985). Quaternion norms are omitted: a multiplier for each would triple
/// the number of evaluations and gain nothing.
///
/// This is a template on its problem so that the other methods do not compile it.
template <class Problem = implicit_problem>
class multiplier_motion final : public motion<Problem> {
  using base = motion<Problem>;
  using base::context_, base::entries_, base::states_, base::inputs_by_state_;

public:
  using typename base::vector;

  explicit multiplier_motion(simulation_context& context)
      : base(context, context.known().constraints + context.known().configuration_constraints) {}

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
    const instant<double> at{t, x.data(), context_.r().data()};
    if (!context_.system().evaluate(results::multipliers, at, {y + states_}))
      base::manifold_->multipliers(t, x, context_.r(), y + states_);
    constexpr const char* not_finite = "the rates at this state are not finite";
    const answer a = context_.check_finite(values, not_finite);
    return a == answer::success ? context_.check_finite(rates, not_finite) : a;
  }

  bool has_manifold() const override { return context_.known().quaternions != 0; }

  answer residual(double elapsed, const double* y, const double* ydot, double* left) override {
    const double t = context_.time(elapsed);
    if (const answer a = base::begin_rates(t, y); a != answer::success) return a;
    if (const status s = evaluate(t, y, ydot, context_.r().data(), left); !s) return context_.fail(s);
    return context_.check_finite(Eigen::Map<vector>(left, entries_),
                                 "the equations of motion are not finite");
  }

  bool has_jacobian() const override { return true; }
  /// Evaluates exact derivatives by complex steps in each entry of y and, scaled by c, of ẏ.
  answer jacobian(double elapsed, double c, const double* y, const double* ydot, double* columns) override {
    const double t = context_.time(elapsed);
    if (const answer a = context_.set_state(t, y); a != answer::success) return a;
    const int inputs = context_.known().inputs;
    if (inputs != 0)
      if (const answer a = base::differentiate_inputs(t); a != answer::success) return a;
    Eigen::VectorXcd at = Eigen::Map<const vector>(y, entries_),
                     rate = Eigen::Map<const vector>(ydot, entries_);
    Eigen::VectorXcd left(entries_);
    constexpr double step = 1e-100;
    for (int j = 0; j < entries_; ++j) {
      Eigen::VectorXcd r = context_.r();
      if (j < states_)
        for (int i = 0; i < inputs; ++i) r(i).imag(step * inputs_by_state_(i, j));
      at(j).imag(step), rate(j).imag(c * step);
      if (const status s = evaluate(t, at.data(), rate.data(), r.data(), left.data()); !s)
        return context_.fail(s);
      for (int i = 0; i < entries_; ++i) columns[j * entries_ + i] = left(i).imag() / step;
      at(j) = y[j], rate(j) = ydot[j];
    }
    return base::check_derivatives(columns);
  }

private:
  /// Evaluates F in real or complex numbers.
  template <class Number>
  status evaluate(double t, const Number* y, const Number* ydot, const Number* r, Number* out) const {
    using numbers = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
    using matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
    using values = Eigen::Map<const numbers>;
    const system_interface& of = context_.system();
    const derivation::survey& known = context_.known();
    const int n = known.coordinates, o = known.speeds, m = known.constraints,
              l = known.configuration_constraints;
    const instant<Number> at{t, y, r, ydot + n};
    Eigen::Map<numbers> left(out, entries_);
    const status s = of.evaluate(results::coordinate_rates, at, {out});
    left.head(n) = values(ydot, n) - left.head(n);
    of.evaluate(results::forces, at, {out + n});
    if (m != 0) {
      matrix by_speeds(m, o);
      of.evaluate(results::velocities, at, {out + states_, by_speeds.data()});
      left.segment(n, o) += by_speeds.transpose().lazyProduct(values(y + states_, m));
    }
    if (l != 0) {
      matrix by_coordinates(l, n);
      of.evaluate(results::configuration, at, {out + states_ + m, by_coordinates.data()});
      left.head(n) -= by_coordinates.transpose().lazyProduct(values(y + states_ + m, l));
    }
    return s;
  }
};

} // namespace kanexpr::simulations
