#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/vector_checks.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/numeric/independence.hpp>
#include <kanexpr/numeric/least_multipliers.hpp>
#include <kanexpr/runtime/model.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace kanexpr {

namespace runtime {

/// The equations of a model that `constrained_motion` needs to find multipliers at a state: all constraints
/// on the speeds, followed by the redundant ones.
class constraint_equations {
  using quantity = mechanics::quantity;
  using vector = Eigen::VectorXd;

public:
  using number = double;
  static constexpr int fixed_coordinates = -1, fixed_speeds = -1, fixed_rows_of_coordinates = -1,
                       fixed_rows_of_speeds = -1;

  /// Requires a model without mistakes.
  constraint_equations(model& m, double t, const vector& p, const vector& r)
      : coordinates_(m.mechanism().coordinates.size()), speeds_(m.mechanism().speeds.size()),
        solved_(m.get(quantity::constraint_jacobian).rows),
        redundant_(m.get(quantity::redundant_jacobian).rows), t_(t), p_(p), r_(r),
        qdot_(m.function(m.get(quantity::qdot))), mass_(m.function(m.get(quantity::unreduced_mass_matrix))),
        force_(m.function(m.get(quantity::unreduced_forcing))),
        bias_(m.function(m.get(quantity::constraint_bias))),
        redundant_bias_(m.function(m.get(quantity::redundant_bias))),
        jacobian_(m.function(m.get(quantity::constraint_jacobian))),
        redundant_jacobian_(m.function(m.get(quantity::redundant_jacobian))) {}

  int coordinates() const { return coordinates_; }
  int speeds() const { return speeds_; }
  int solved() const { return solved_; }
  static int rows_of_coordinates() { return 0; }
  int rows_of_speeds() const { return solved_ + redundant_; }

  static void configuration(const vector&, vector&, Eigen::MatrixXd&) {}
  void velocities(const vector& x, vector&, Eigen::MatrixXd& by_speeds) const {
    by_speeds.topRows(solved_) = jacobian_(t_, x, p_, r_);
    by_speeds.bottomRows(redundant_) = redundant_jacobian_(t_, x, p_, r_);
  }
  status motion(const vector& x, vector& qdot, Eigen::MatrixXd& mass, vector& force, vector& bias) const {
    qdot = qdot_(t_, x, p_, r_), mass = mass_(t_, x, p_, r_), force = force_(t_, x, p_, r_);
    bias.head(solved_) = bias_(t_, x, p_, r_);
    bias.tail(redundant_) = redundant_bias_(t_, x, p_, r_);
    for (const auto* each : {&qdot_, &mass_, &force_, &bias_, &redundant_bias_})
      if (const status s = each->status(); !s) return s;
    return {};
  }

private:
  int coordinates_, speeds_, solved_, redundant_;
  double t_;
  const vector &p_, &r_;
  // these own the matrices that they return
  mutable interpreted<double> qdot_, mass_, force_, bias_, redundant_bias_, jacobian_, redundant_jacobian_;
};

} // namespace runtime

/// Finds u̇ and the multipliers of least norm at a state where constraints may be redundant, as for a compiled
/// system.
template <class Parameters = Eigen::VectorXd, class Inputs = Eigen::VectorXd>
numeric::least_multipliers<Eigen::VectorXd, Eigen::VectorXd>
find_least_multipliers(model& m, const Eigen::VectorXd& x, const Parameters& p = {}, const Inputs& r = {},
                       double t = 0) {
  m.udot(); // clears the mistake in the previous request, and may report a new one
  if (!m.mistake().empty()) return {.failure = base::sentence({m.mistake()})};
  const mechanics::mechanism& of = m.mechanism();
  if (const base::sentence wrong = compiled::check_size("state", "the model", static_cast<int>(x.size()),
                                                        of.coordinates.size() + of.speeds.size()))
    return {.failure = wrong};
  const Eigen::VectorXd parameters = p, inputs = r;
  const runtime::constraint_equations equations(m, t, parameters, inputs);
  return numeric::find_least_multipliers(equations, x, equations.solved());
}

namespace runtime {

KANEXPR_ENGINE assembly assemble(model& m, std::span<double> x, std::span<const double> p,
                                 std::span<const double> r, double t, const assembly_options& options);
KANEXPR_ENGINE consistency check_consistency(model& m, std::span<const double> x, std::span<const double> p,
                                             std::span<const double> r, double t, double tolerance);

/// Copies the entries of a vector of any type.
template <class Vector>
std::vector<double> entries_of(const Vector& v) {
  std::vector<double> entries(static_cast<std::size_t>(v.size()));
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = v[static_cast<Eigen::Index>(i)];
  return entries;
}

} // namespace runtime

/// Normalizes quaternions and solves the constraints for the dependent coordinates and speeds in `x` = [q;
/// u], as for a compiled system.
template <class Parameters = Eigen::VectorXd, class Inputs = Eigen::VectorXd>
assembly assemble(model& m, Eigen::VectorXd& x, const Parameters& p = {}, const Inputs& r = {}, double t = 0,
                  const assembly_options& options = {}) {
  return runtime::assemble(m, {x.data(), static_cast<std::size_t>(x.size())}, runtime::entries_of(p),
                           runtime::entries_of(r), t, options);
}

/// Checks whether a state satisfies the constraints to within `tolerance`, relative to their terms, and
/// whether its quaternions have norm 1. If not, reports which condition is violated and by how much.
template <class Parameters = Eigen::VectorXd, class Inputs = Eigen::VectorXd>
consistency check_consistency(model& m, const Eigen::VectorXd& x, const Parameters& p, const Inputs& r,
                              double t = 0, double tolerance = 1e-9) {
  return runtime::check_consistency(m, {x.data(), static_cast<std::size_t>(x.size())}, runtime::entries_of(p),
                                    runtime::entries_of(r), t, tolerance);
}

/// Checks whether the constraints on the speeds are independent at a state, and reports the rows of
/// `constraint_jacobian` that depend on preceding rows.
template <class Parameters = Eigen::VectorXd, class Inputs = Eigen::VectorXd>
independence check_independence(model& m, const Eigen::VectorXd& x, const Parameters& p = {},
                                const Inputs& r = {}, double t = 0) {
  auto jacobian = m.function(m.constraint_jacobian());
  const Eigen::VectorXd parameters = p, inputs = r;
  return numeric::independence_of(jacobian(t, x, parameters, inputs));
}

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/assemble.ipp>
#endif
