#pragma once

#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/simulate/constraint_projection.hpp>
#include <kanexpr/simulate/input_sensitivity.hpp>
#include <kanexpr/simulate/surroundings.hpp>

#include <complex>

namespace kanexpr::simulated {

/// The equations of all speeds with the multipliers λ of the constraints, as F(t, y, ẏ) = 0 in y = [q; u; λ;
/// μ]:
///
///     q̇ − q̇(q, u) − Φ_qᵀ μ = 0,  F_r + F_r* + Jᵀ λ = 0,  J u + c = 0,  Φ = 0.
///
/// Coordinates and speeds are both held to their constraints; μ, which is zero in the solution, makes room
/// for that (Gear, Gupta & Leimkuhler 1985). Norms of quaternions are left out: a multiplier for each takes
/// three times the evaluations and gains nothing.
template <class System>
class multiplier_motion final : public solvers::implicit_problem {
public:
  explicit multiplier_motion(surroundings<System>& around) : around_(around) {}

  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr int n = known.coordinates, o = known.speeds;
  static constexpr int m = known.constraints, l = known.configuration_constraints;
  static constexpr int entries = n + o + m + l;
  using vector = Eigen::Matrix<double, entries, 1>;

  long rate_evaluations() const { return rate_evaluations_; }
  long projections() const { return projections_; }

  int size() const override { return entries; }
  int watched() const override { return static_cast<int>(around_.events().size()); }
  answer watch(double elapsed, const double* y, double* values) override {
    return around_.watch(around_.time(elapsed), y, values);
  }
  int direction(int i) const override { return around_.direction(i); }
  bool is_algebraic(int entry) const override { return entry >= n + o; }

  /// A state with its multipliers, and their rates, those of multipliers zero.
  answer start(double elapsed, const kanexpr::state<System>& x, double* y, double* ydot) {
    const double t = around_.time(elapsed);
    if (const answer a = around_.take(t, x); a != answer::given) return a;
    Eigen::Map<vector> values(y), rates(ydot);
    values.setZero(), rates.setZero();
    values.template head<n + o>() = x;
    const auto xdot = out_of_line<function<System, quantity::rhs>>{}(t, x, around_.p(), around_.r());
    if (const status s = compiled::status_of(xdot); !s) return around_.refuse(s);
    rates.template head<n + o>() = xdot;
    if constexpr (m != 0)
      values.template segment<m>(n + o) =
          out_of_line<function<System, quantity::multipliers>>{}(t, x, around_.p(), around_.r());
    return values.allFinite() && rates.allFinite() ? answer::given
                                                   : around_.refuse("the rates at this state are not finite");
  }

  bool has_invariants() const override { return known.quaternions != 0; }
  answer project(double elapsed, const double* y, const double* weights, double* out) override {
    if constexpr (known.quaternions != 0) {
      const double t = around_.time(elapsed);
      ++projections_;
      if (const answer a = around_.take(t, y); a != answer::given) return a;
      const Eigen::Map<const Eigen::Matrix<double, n + o, 1>> unit(weights);
      if (!projection_(t, around_.x(), around_.p(), around_.r(), unit))
        return around_.refuse("the constraints are dependent, or cannot be met, near this state");
      Eigen::Map<Eigen::Matrix<double, n + o, 1>> correction(out);
      correction = projection_.correction();
    }
    return answer::given;
  }

  answer residual(double elapsed, const double* y, const double* ydot, double* left) override {
    const double t = around_.time(elapsed);
    ++rate_evaluations_;
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    Eigen::Map<vector> out(left);
    status s;
    out = residual_of<double>(t, Eigen::Map<const vector>(y), Eigen::Map<const vector>(ydot), around_.r(), s);
    if (!s) return around_.refuse(s);
    return out.allFinite() ? answer::given : around_.refuse("the equations of motion are not finite");
  }

  bool has_jacobian() const override { return true; }
  /// Exact, by a complex step along each entry of y and, c times as far, of ẏ.
  answer jacobian(double elapsed, double c, const double* y, const double* ydot, double* columns) override {
    const double t = around_.time(elapsed);
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    if constexpr (known.inputs != 0)
      if (const answer a = sensitivity_.find(t, around_); a != answer::given) return a;
    Eigen::Map<Eigen::Matrix<double, entries, entries>> out(columns);
    Eigen::Matrix<complex, entries, 1> at = Eigen::Map<const vector>(y),
                                       rate = Eigen::Map<const vector>(ydot);
    constexpr double step = 1e-100;
    for (int j = 0; j < entries; ++j) {
      Eigen::Matrix<complex, known.inputs, 1> r = around_.r();
      if constexpr (known.inputs != 0)
        if (j < n + o) r += complex(0, step) * sensitivity_.by_state().col(j);
      at(j) += complex(0, step), rate(j) += complex(0, c * step);
      status s;
      out.col(j) = residual_of<complex>(t, at, rate, r, s).imag() / step;
      if (!s) return around_.refuse(s);
      at(j) = y[j], rate(j) = ydot[j];
    }
    return out.allFinite() ? answer::given : around_.refuse("the derivatives of the motion are not finite");
  }

private:
  using quantity = mechanics::quantity;
  using constraints = compiled::constraints_at<System, parameter_values<System>, input_values<System>>;
  using complex = std::complex<double>;

  template <class T, class Y, class R>
  Eigen::Matrix<T, entries, 1> residual_of(double t, const Y& y, const Y& ydot, const R& r, status& s) const {
    const Eigen::Matrix<T, n + o, 1> x = y.template head<n + o>();
    const Eigen::Matrix<T, o, 1> udot = ydot.template segment<o>(n);
    const Eigen::Matrix<T, known.parameters, 1> p = around_.p().template cast<T>();
    Eigen::Matrix<T, entries, 1> left;
    const auto qdot = out_of_line<function<System, quantity::qdot>>{}(t, x, p, r);
    s = compiled::status_of(qdot);
    left.template head<n>() = ydot.template head<n>() - qdot;
    left.template segment<o>(n) =
        out_of_line<function<System, quantity::unreduced_forces>>{}(t, x, p, r, udot);
    if constexpr (m != 0) {
      const auto [residual, jacobian] = constraints::velocities()(t, x, p, r);
      left.template segment<o>(n) += jacobian.transpose() * y.template segment<m>(n + o);
      left.template segment<m>(n + o) = residual;
    }
    if constexpr (l != 0) {
      const auto [residual, jacobian] = constraints::configuration()(t, x, p, r);
      left.template head<n>() -= jacobian.transpose() * y.template tail<l>();
      left.template tail<l>() = residual;
    }
    return left;
  }

  surroundings<System>& around_;
  input_sensitivity<System> sensitivity_{};
  constraint_projection<System> projection_{};
  long rate_evaluations_ = 0, projections_ = 0;
};

} // namespace kanexpr::simulated
