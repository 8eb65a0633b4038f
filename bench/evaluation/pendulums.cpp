#include "models/double_pendulum.hpp"
#include "models/simple_pendulum.hpp"
#include "side_by_side.hpp"

#include "../instructions/pendulums_by_hand.hpp"

int main(int argc, char** argv) {
  side_by_side::add_system<simple_pendulum::System>("simple_pendulum");
  side_by_side::add("simple_pendulum/udot/by_hand", Eigen::Vector2d(0.3, 0.3), [](const Eigen::Vector2d& x) {
    const double p[]{1.1, 1.1, 1.1, 1.1}, r[]{0.2};
    Eigen::Vector2d rate;
    simple_pendulum_rhs_by_hand(x.data(), p, r, rate.data());
    return rate;
  });
  side_by_side::add_system<double_pendulum::System>("double_pendulum");
  side_by_side::add("double_pendulum/udot/by_hand", Eigen::Vector4d(0.3, 0.3, 0.3, 0.3),
                    [](const Eigen::Vector4d& x) {
                      const double p[]{1.1, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1}, r[]{0.2, 0.2};
                      Eigen::Vector4d rate;
                      double_pendulum_rhs_by_hand(x.data(), p, r, rate.data());
                      return rate;
                    });
  return side_by_side::run(argc, argv);
}
