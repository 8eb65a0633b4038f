// expect: input F, which an expression contains, is not among those of System; write used_elsewhere<F>
#include "pendulum.hpp"

constexpr input<"F"> F;
struct End : offset<End, P, l * A::x> {}; // which the system does not use

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;

int main() {
  kanexpr::function<System, F * dot(position_of<End, O>, N::x)> reach;
  const double value = reach(eom::state(), eom::parameters(), eom::inputs());
  return value > 0;
}
