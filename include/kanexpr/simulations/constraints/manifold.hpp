#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/lower/unit_quaternion.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/simulations/system_interface.hpp>

#include <Eigen/Core>

#include <memory>

namespace kanexpr::simulations {

/// The manifold on which the constraints hold and quaternions have norm 1.
class manifold {
public:
  using vector = Eigen::VectorXd;
  virtual ~manifold() = default;

  /// Solves for the dependent coordinates and speeds and normalizes quaternions. A given quaternion may
  /// deviate from norm 1 only by rounding, unless constraints are solved for its coordinates.
  virtual assembly assemble(double t, vector& x, const vector& r) = 0;
  /// Returns the residuals of the configuration constraints.
  virtual vector configuration_residual(double t, const vector& x, const vector& r) = 0;
  /// Returns a message about a redundant constraint whose residual, relative to its terms, exceeds a
  /// tolerance; empty if all hold.
  virtual base::sentence redundant_violation(double t, const vector& x, const vector& r,
                                             double tolerance) = 0;

  /// Sets the magnitudes of the entries of a state; the constraints are examined around the given state.
  virtual void set_sizes(double t, const vector& x, const vector& r, const vector& sizes) = 0;
  /// Determines whether a state is near a position in which velocity constraints follow from others, or
  /// whether some always do. Later calls use this result. `least` is the distinctness below which a position
  /// counts as singular.
  virtual void update_singularity(double t, const vector& x, const vector& r, double least) = 0;
  virtual bool is_near_singular() const = 0;
  /// Evaluates ẋ at the nearest state on the manifold, from the equations for all speeds, for any choice of
  /// dependent speeds.
  virtual status rates(double t, const vector& x, const vector& r, double* xdot) = 0;

  /// Evaluates the multipliers at a state on the manifold, for any choice of dependent speeds.
  virtual status multipliers(double t, const vector& x, const vector& r, double* lambda) = 0;

  /// Finds the correction from a state to the nearest point on the manifold, with each entry measured in
  /// units of 1/weight. Returns false if the constraints are dependent or the manifold cannot be reached from
  /// there.
  virtual bool project(double t, const vector& x, const vector& r, const vector& weights) = 0;
  virtual const vector& correction() const = 0;
  /// Removes from an error estimate its component normal to the manifold at the last projection.
  virtual void project_error(double* error) const = 0;
};

/// Returns the manifold of a system; null if it has neither constraints nor quaternions.
inline std::unique_ptr<manifold> manifold_for(const system_interface& of) {
  return of.create_manifold == nullptr ? nullptr : of.create_manifold(of);
}

} // namespace kanexpr::simulations
