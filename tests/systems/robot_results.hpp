// The results that the tests of robots compare, and their relation to the reference.
#pragma once

#include "oracles.hpp"

namespace check {

using oracle::MatrixXd;
using oracle::VectorXd;

// The reference's speeds are `turn` times those of the model, its accelerations `turn` times (those of the
// model + `extra`).
struct convention {
  MatrixXd turn;
  VectorXd extra;
};

// In terms of the coordinates and speeds of the reference.
using seen_by_reference = convention (*)(const VectorXd& q, const VectorXd& u);

// Joints only, for which model and reference agree.
convention on_the_ground(const VectorXd& q, const VectorXd& u);

// The reference expresses the base's velocity in ground axes, the model in the base's axes: a = R (v̇ + ω×v).
convention floating_base(const VectorXd& q, const VectorXd& u);

struct robot_results {
  MatrixXd mass_matrix;
  VectorXd forcing_without_motors, forcing, udot;
};

// The model's motors provide the last torques; the preceding ones act on the base.
void expect_reference(const robot_results& model, const oracle::robot_state& reference,
                      const convention& seen, Eigen::Index motors);

} // namespace check
