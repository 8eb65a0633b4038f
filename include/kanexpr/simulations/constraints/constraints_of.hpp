#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/simulations/constraints/unit_norms.hpp>
#include <kanexpr/simulations/system_interface.hpp>

#include <Eigen/Core>
#include <vector>

namespace kanexpr::simulations {

/// The constraints of a system at a fixed time with its inputs, for the numerical methods that satisfy them.
/// If a constraint is solved for a coordinate of a quaternion, the constraints are evaluated at norm 1.
template <class System, class Motion>
class constraints_of {
public:
  using coordinate_vector = Eigen::VectorXd;
  using vector = Eigen::VectorXd;

  /// `look` returns the motion from the equations of all speeds, which provides the magnitudes of the
  /// constraints.
  constraints_of(const System& of, const unit_norms& norms, double t, const vector& r, Motion& motion)
      : of_(of), norms_(norms), t_(t), r_(r), motion_(motion), left_(coordinates()),
        by_all_(coordinates(), of.known.coordinates) {
    for (int i = 0; i < of.states(); ++i)
      if (of.known.dependent[i]) places_.push_back(i);
  }

  int all_coordinates() const { return of_.known.coordinates; }
  int coordinates() const { return of_.known.configuration_constraints; }
  int place_of_coordinate(int i) const { return places_[static_cast<std::size_t>(i)]; }

  const vector& configuration_residual(const vector& x) {
    if (coordinates() != 0) evaluate(x);
    return left_;
  }
  Eigen::MatrixXd configuration_jacobian_by_all(const vector& x) {
    evaluate(x);
    Eigen::MatrixXd by_dependent(coordinates(), coordinates());
    for (int i = 0; i < coordinates(); ++i) by_dependent.col(i) = by_all_.col(place_of_coordinate(i));
    return by_dependent;
  }
  vector velocity_residual(const vector& x) const {
    vector left(of_.known.constraints);
    Eigen::MatrixXd by_speeds(left.size(), of_.known.speeds);
    if (left.size() != 0)
      of_.evaluate(results::velocities, t_, x.data(), r_.data(), {left.data(), by_speeds.data()});
    return left;
  }
  vector redundant_residual(const vector& x) const { return redundant(x).col(0); }
  vector redundant_terms(const vector& x) const { return redundant(x).col(1); }
  vector redundant_rate(const vector& x) const { return redundant(x).col(2); }
  vector redundant_rate_terms(const vector& x) const { return redundant(x).col(3); }
  bool configuration_holds(const vector& x) const { return motion_(x).configuration_holds(x); }
  bool velocities_hold(const vector& x) const { return motion_(x).velocities_hold(x); }
  status normalize_quaternions(vector& x) const { return norms_.normalize(x, lower::norm_range{}); }

  /// Sets the dependent speeds of the state, if they can be solved for.
  status solve_speeds(vector& x) const {
    vector u(of_.known.constraints);
    if (u.size() == 0) return {};
    const status s = of_.evaluate(results::dependent_speeds, t_, x.data(), r_.data(), {u.data()});
    if (s)
      for (int i = 0; i < u.size(); ++i) x(place_of_coordinate(coordinates() + i)) = u(i);
    return s;
  }

private:
  Eigen::MatrixXd redundant(const vector& x) const {
    const Eigen::Index rows = of_.known.redundant_constraints;
    Eigen::MatrixXd all(rows, 4);
    if (rows != 0)
      of_.evaluate(results::redundant, t_, x.data(), r_.data(),
                   {all.data(), all.data() + rows, all.data() + 2 * rows, all.data() + 3 * rows});
    return all;
  }
  void evaluate(const vector& x) {
    vector at = x;
    if (norms_.are_bound()) norms_.normalize(at, lower::norm_range{});
    of_.evaluate(results::configuration, t_, at.data(), r_.data(), {left_.data(), by_all_.data()});
    if (norms_.are_bound()) norms_.leave_out(by_all_, at);
  }

  const System& of_;
  const unit_norms& norms_;
  double t_;
  const vector& r_;
  Motion& motion_;
  vector left_;
  Eigen::MatrixXd by_all_;
  std::vector<int> places_{};
};

} // namespace kanexpr::simulations
