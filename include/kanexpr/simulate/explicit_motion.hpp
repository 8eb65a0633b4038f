#pragma once

#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/simulate/constraint_projection.hpp>
#include <kanexpr/simulate/input_sensitivity.hpp>
#include <kanexpr/simulate/surroundings.hpp>

namespace kanexpr::simulated {

/// ẋ of a system as integrators ask for it. The derivatives are compiled only where the method needs them.
template <class System, bool with_jacobian>
class explicit_motion final : public solvers::explicit_problem {
public:
  explicit explicit_motion(surroundings<System>& around) : around_(around) {}

  long rate_evaluations() const { return rate_evaluations_; }
  long projections() const { return projections_; }

  int size() const override { return entries; }
  int watched() const override { return static_cast<int>(around_.events().size()); }
  answer watch(double elapsed, const double* y, double* values) override {
    return around_.watch(around_.time(elapsed), y, values);
  }
  int direction(int i) const override { return around_.direction(i); }

  answer rates(double elapsed, const double* y, double* ydot) override {
    const double t = around_.time(elapsed);
    ++rate_evaluations_;
    if (const answer a = around_.take(t, y); a != answer::given) return a;
    const auto rates = rhs(t, around_.x(), around_.p(), around_.r());
    if (const status s = compiled::status_of(rates); !s) return around_.refuse(s);
    Eigen::Map<vector> out(ydot);
    out = rates;
    return out.allFinite() ? answer::given : around_.refuse(unfinished(out));
  }

  bool has_jacobian() const override { return with_jacobian; }
  answer jacobian(double elapsed, const double* y, double* columns) override {
    if constexpr (with_jacobian) {
      const double t = around_.time(elapsed);
      if (const answer a = around_.take(t, y); a != answer::given) return a;
      const auto [by_state, by_inputs] = motion_jacobian(t, around_.x(), around_.p(), around_.r());
      if (const status s = compiled::status_of(by_state); !s) return around_.refuse(s);
      Eigen::Map<Eigen::Matrix<double, entries, entries>> out(columns);
      out = by_state;
      if constexpr (known.inputs != 0) {
        if (const answer a = sensitivity_.find(t, around_); a != answer::given) return a;
        if (around_.source().depends_on_state()) out += by_inputs * sensitivity_.by_state();
      }
      return out.allFinite() ? answer::given : around_.refuse("the derivatives of the motion are not finite");
    }
    return answer::never;
  }

  bool has_constraints() const override { return constraint_projection<System>::is_needed; }
  answer project(double elapsed, const double* y, const double* weights, double* out,
                 double* error) override {
    if constexpr (constraint_projection<System>::is_needed) {
      const double t = around_.time(elapsed);
      ++projections_;
      if (const answer a = around_.take(t, y); a != answer::given) return a;
      const Eigen::Map<const vector> unit(weights);
      if (!projection_(t, around_.x(), around_.p(), around_.r(), unit))
        return around_.refuse("the constraints are dependent, or cannot be met, near this state");
      Eigen::Map<vector> correction(out);
      correction = projection_.correction();
      if (error != nullptr) {
        Eigen::Map<vector> estimate(error);
        projection_.project_error(estimate);
      }
    }
    return answer::given;
  }

private:
  static constexpr out_of_line<function<System, mechanics::quantity::rhs>> rhs{};
  static constexpr out_of_line<
      finite_function<System, mechanics::quantity::state_jacobian, mechanics::quantity::input_jacobian>>
      motion_jacobian{};
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr int entries = known.coordinates + known.speeds;
  using vector = Eigen::Matrix<double, entries, 1>;

  static std::string unfinished(const vector& rates) {
    int i = 0;
    while (i < entries - 1 && std::isfinite(rates(i))) ++i;
    return "the rate of " + surroundings<System>::name_of_state(i) + " is not finite";
  }

  surroundings<System>& around_;
  constraint_projection<System> projection_{};
  input_sensitivity<System> sensitivity_{};
  long rate_evaluations_ = 0, projections_ = 0;
};

} // namespace kanexpr::simulated
