// expect: the angle of frame D contains the auxiliary speed v; it may contain only coordinates
#include "pendulum.hpp"

struct D : rotated<D, A, v, A::z> {};
struct Q : offset<Q, P, l * D::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, auxiliary<v>, kinematics<dot(q) == u>,
                            bodies<Ball>> {};

int main() { use<System>(); }
