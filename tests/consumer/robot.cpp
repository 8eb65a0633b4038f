// A robot from a file, at rest below its shoulder: it does not move, and its mass matrix equals the one
// computed by hand.
#include <two_links.hpp>

#include <cmath>

int main() {
  using eom = kanexpr::equations_of_motion<two_links::System>;
  const eom::state x = two_links::at_rest();
  const eom::inputs r = eom::inputs::Zero();
  const eom::parameters p = two_links::values();
  const Eigen::Matrix2d mass = eom::mass_matrix(x, p, r);
  // The elbow rotates in the opposite direction: its axes are rotated by a half turn.
  const double elbow = 0.05 + 0.5 * 0.16, across = -(0.05 + 0.5 * 1.4 * 0.4);
  const double shoulder = 0.1 + 0.25 + 0.05 + 0.5 * 1.96;
  const Eigen::Matrix2d by_hand{{shoulder, across}, {across, elbow}};
  return mass.isApprox(by_hand, 1e-14) && eom::udot(x, p, r).norm() < 1e-14 ? 0 : 1;
}
