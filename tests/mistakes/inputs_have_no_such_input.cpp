// expect: the system System has no input F
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};
using eom = equations_of_motion<System>;
constexpr input<"F"> F;

int main() {
  eom::inputs r;
  r[F] = 1;
}
