// expect: the input vector of System has 1 entry, not 2
#include "pendulum.hpp"

#include <kanexpr/fixed_step.hpp>

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};

int main() {
  double now = 0;
  state<System> x;
  const auto motor = [](double, const state<System>&) { return Eigen::Vector2d(1, 2); };
  return runge_kutta_4<System>{}(now, x, 0.01, parameter_values<System>(), motor) ? 0 : 1;
}
