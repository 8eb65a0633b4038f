// expect: the offset of point Q contains the auxiliary speed v; it may contain only coordinates
#include "pendulum.hpp"

struct Q : offset<Q, O, v * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, auxiliary<v>, kinematics<dot(q) == u>,
                            bodies<Ball>> {};

int main() { use<System>(); }
