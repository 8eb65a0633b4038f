#include <models/simple_pendulum.hpp>

using eom = kanexpr::equations_of_motion<simple_pendulum::System>;

Eigen::Matrix<double, 2, 1> rates(const eom::state& x, const eom::parameters& p, const eom::inputs& r) {
  return eom::rhs(x, p, r);
}
