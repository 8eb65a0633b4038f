// expect: the system System has no prescribed quantity theta''
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            inputs<theta, dot(theta)>, loads<force<P, dot(theta) * N::x>>> {};

int main() {
  equations_of_motion<System>::inputs r;
  r[dot(dot(theta))] = 1;
}
