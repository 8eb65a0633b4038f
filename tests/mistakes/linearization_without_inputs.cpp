// expect: explicit_form needs the input T: call it as explicit_form(x, p, r)
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * q * N::z>>> {};
using lin = linearization<System>;

int main() {
  const auto [A, B] = lin::explicit_form(lin::state(), lin::parameters());
  return A(0, 0) > B(0, 0);
}
