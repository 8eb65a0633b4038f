#pragma once

#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/simulate/motions/input_sensitivity.hpp>
#include <kanexpr/simulate/constraints/manifold.hpp>
#include <kanexpr/simulate/motions/simulation_context.hpp>

#include <complex>

namespace kanexpr::simulated {

/// The equations of all speeds with the multipliers λ of the constraints, as F(t, y, ẏ) = 0 in y = [q; u; λ;
/// μ]:
///
///     q̇ − q̇(q, u) − Φ_qᵀ μ = 0,  F_r + F_r* + Jᵀ λ = 0,  J u + c = 0,  Φ = 0.
///
/// Coordinates and speeds both satisfy their constraints; μ, which is zero in the solution, makes this
/// possible (Gear, Gupta & Leimkuhler 1985). Quaternion norms are omitted: a multiplier for each takes three
/// times as many evaluations and gains nothing.
template <class Surroundings>
class multiplier_motion final : public solvers::implicit_problem {
public:
  using vector = Eigen::VectorXd;

  explicit multiplier_motion(Surroundings& around)
      : around_(around), sensitivity_(around), manifold_(around.constraints()),
        states_(around.system().states()),
        entries_(states_ + around.known().constraints + around.known().configuration_constraints) {}
  multiplier_motion(const multiplier_motion&) = delete;
  multiplier_motion& operator=(const multiplier_motion&) = delete;

  long rate_evaluations() const { return rate_evaluations_; }
  long projections() const { return projections_; }

  int size() const override { return entries_; }
  int watched() const override { return static_cast<int>(around_.events().size()); }
  answer watch(double elapsed, const double* y, double* values) override {
    return around_.watch(around_.time(elapsed), y, values);
  }
  int direction(int i) const override { return around_.direction(i); }
  bool is_algebraic(int entry) const override { return entry >= states_; }

  /// Sets y and ydot to a state with its multipliers and to their rates; the rates of the multipliers are
  /// zero.
  answer start(double elapsed, const vector& x, double* y, double* ydot) {
    const double t = around_.time(elapsed);
    if (const answer a = around_.take(t, x); a != answer::given) return a;
    Eigen::Map<vector> values(y, entries_), rates(ydot, entries_);
    values.setZero(), rates.setZero();
    values.head(states_) = x;
    if (const status s = around_.rates(t, ydot); !s) return around_.refuse(s);
    if (around_.known().constraints != 0)
      around_.system().multipliers(t, x.data(), around_.r().data(), y + states_);
    return numeric::all_finite(values) && numeric::all_finite(rates)
               ? answer::given
               : around_.refuse("the rates at this state are not finite");
  }

  bool has_invariants() const override { return around_.known().quaternions != 0; }
  answer project(double elapsed, const double* y, const double* weights, double* out) override {
    const double t = around_.time(elapsed);
    ++projections_;
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    if (!manifold_->project(t, around_.x(), around_.r(), Eigen::Map<const vector>(weights, states_)))
      return around_.refuse("the constraints are dependent or inconsistent near this state");
    std::copy_n(manifold_->correction().data(), states_, out);
    return answer::given;
  }

  answer residual(double elapsed, const double* y, const double* ydot, double* left) override {
    const double t = around_.time(elapsed);
    ++rate_evaluations_;
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    if (const status s = around_.system().implicit(t, y, ydot, around_.r().data(), left); !s)
      return around_.refuse(s);
    return numeric::all_finite(Eigen::Map<vector>(left, entries_))
               ? answer::given
               : around_.refuse("the equations of motion are not finite");
  }

  bool has_jacobian() const override { return true; }
  /// Exact, by complex steps in each entry of y and, scaled by c, of ẏ.
  answer jacobian(double elapsed, double c, const double* y, const double* ydot, double* columns) override {
    const double t = around_.time(elapsed);
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    const int inputs = around_.known().inputs;
    if (inputs != 0)
      if (const answer a = sensitivity_.find(t, around_); a != answer::given) return a;
    Eigen::VectorXcd at = Eigen::Map<const vector>(y, entries_),
                     rate = Eigen::Map<const vector>(ydot, entries_);
    Eigen::VectorXcd left(entries_);
    constexpr double step = 1e-100;
    for (int j = 0; j < entries_; ++j) {
      Eigen::VectorXcd r = around_.r();
      if (j < states_)
        for (int i = 0; i < inputs; ++i) r(i).imag(step * sensitivity_.by_state()(i, j));
      at(j).imag(step), rate(j).imag(c * step);
      const status s = around_.system().implicit(t, at.data(), rate.data(), r.data(), left.data());
      if (!s) return around_.refuse(s);
      for (int i = 0; i < entries_; ++i) columns[j * entries_ + i] = left(i).imag() / step;
      at(j) = y[j], rate(j) = ydot[j];
    }
    return numeric::all_finite(Eigen::Map<Eigen::MatrixXd>(columns, entries_, entries_))
               ? answer::given
               : around_.refuse("the derivatives of the motion are not finite");
  }

private:
  Surroundings& around_;
  input_sensitivity sensitivity_;
  manifold* manifold_;
  int states_, entries_;
  long rate_evaluations_ = 0, projections_ = 0;
};

} // namespace kanexpr::simulated
