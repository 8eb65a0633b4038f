#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/numeric/independence.hpp>
#include <kanexpr/runtime/least_multipliers.hpp>
#include <kanexpr/runtime/model.hpp>

#include <Eigen/Core>
#include <span>
#include <vector>

namespace kanexpr {

namespace runtime {

KANEXPR_ENGINE assembly assemble(model& m, std::span<double> x, std::span<const double> p,
                                 std::span<const double> r, double t, const assembly_options& options);
KANEXPR_ENGINE consistency check_consistency(model& m, std::span<const double> x, std::span<const double> p,
                                             std::span<const double> r, double t, double tolerance);

/// Copies the entries of a vector of any type.
template <class Vector>
std::vector<double> entries_of(const Vector& v) {
  std::vector<double> entries;
  for (Eigen::Index i = 0; i < v.size(); ++i) entries.push_back(v[i]);
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
