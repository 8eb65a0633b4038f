// expect: the system System has no speed v
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            auxiliary<v>> {};

int main() {
  equations_of_motion<System>::state x;
  x[v] = 1;
}
