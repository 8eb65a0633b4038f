// expect: linearized<Step> requires inputs that are constant during the step, because it differentiates
// expect: with respect to them; it does not accept a function
#include "pendulum.hpp"

#include <kanexpr/control.hpp>

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};

int main() {
  const auto law = [](double, const state<System>&) { return input_values<System>(1); };
  const auto next =
      linearized<runge_kutta_4<System>>{}(0, state<System>(), 0.1, parameter_values<System>(), law);
  return next.status ? 0 : 1;
}
