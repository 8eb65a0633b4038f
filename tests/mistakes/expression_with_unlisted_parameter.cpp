// expect: parameter c, which an expression contains, is not among those of System; write used_elsewhere<c>
#include "pendulum.hpp"

constexpr parameter<"c"> c;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, c * u> product;
  const double value = product(eom::state(), eom::parameters());
  return value > 0;
}
