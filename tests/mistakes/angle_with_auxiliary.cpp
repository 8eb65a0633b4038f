// expect: the angle of frame D holds the auxiliary speed v; it may hold coordinates only
#include "pendulum.hpp"

struct D : rotated<D, A, v, A::z> {};
struct Q : offset<Q, P, l * D::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, auxiliary<v>, kinematics<dot(q) == u>,
                            bodies<Ball>> {};

int main() { use<System>(); }
