// expect: forcing needs the time: call it as forcing(t, x, p, r)
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, sin(t) * N::x>>> {};
using eom = equations_of_motion<System>;

int main() {
  const double f = eom::forcing(eom::state(), eom::parameters());
  return f > 0;
}
