#pragma once

#include <kanexpr/kanexpr.hpp>

/// What the demo shows of a system, from a file of its own for each, so that the build can tell what the
/// compiler needed to derive it.
namespace demo {

struct compiled {
  Eigen::VectorXd udot;
  Eigen::VectorXd reference;
  kanexpr::symbolic::cost mass_matrix_and_forcing;
  kanexpr::symbolic::cost udot_cost;
  double nanoseconds; ///< of one evaluation of u'
};

compiled compiled_rolling_disc();
compiled compiled_iiwa();

} // namespace demo
