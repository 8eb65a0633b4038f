#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/lower/unit_quaternion.hpp>
#include <kanexpr/numeric/assembly.hpp>
#include <kanexpr/simulate/system.hpp>

#include <Eigen/Core>

#include <memory>

namespace kanexpr::simulated {

/// Where the constraints hold and quaternions have norm 1.
class manifold {
public:
  using vector = Eigen::VectorXd;
  virtual ~manifold() = default;

  /// Lets the dependent coordinates and speeds follow the others. Quaternions get norm 1; one that is given
  /// may be rounded, no more, unless constraints are solved for its coordinates.
  virtual assembly assemble(double t, vector& x, const vector& r) = 0;
  /// What the configuration constraints leave.
  virtual vector configuration_residual(double t, const vector& x, const vector& r) = 0;
  /// Which redundant constraint does not hold to a tolerance of its terms, and by how much; empty: none.
  virtual mechanics::sentence redundant_off(double t, const vector& x, const vector& r, double tolerance) = 0;

  /// Sets how large the entries of a state are; it looks around the one that is given.
  virtual void set_sizes(double t, const vector& x, const vector& r, const vector& sizes) = 0;
  /// Finds out whether a state is near a position in which constraints on the speeds follow from others, or
  /// where some always do. What is asked from then on is answered for such a place. `least` is the
  /// distinctness below which it is one.
  virtual void come_to(double t, const vector& x, const vector& r, double least) = 0;
  virtual bool is_near_singular() const = 0;
  /// ẋ at the nearest state of the manifold, from the equations of all speeds, whatever is dependent.
  virtual status rates(double t, const vector& x, const vector& r, double* xdot) = 0;

  /// Finds what leads from a state to the nearest point of the manifold, each entry measured in units of
  /// 1/weight. False where the constraints are dependent, or cannot be reached from there.
  virtual bool project(double t, const vector& x, const vector& r, const vector& weights) = 0;
  virtual const vector& correction() const = 0;
  /// Takes what points away from the manifold, where it was last projected, off an error estimate.
  virtual void project_error(double* error) const = 0;
};

/// Of a system; null: it has no constraints, and no quaternions.
inline std::unique_ptr<manifold> own_manifold(const system& of) {
  return of.make_manifold == nullptr ? nullptr : of.make_manifold(of);
}

} // namespace kanexpr::simulated
