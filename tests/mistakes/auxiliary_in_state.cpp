// expect: the system System has no speed v
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, velocity<N, l * u * A::y + v * A::x> {};
struct Ball : particle<Ball, Q, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Ball>,
                            auxiliary<v>> {};

int main() {
  equations_of_motion<System>::state x;
  x[v] = 1;
}
