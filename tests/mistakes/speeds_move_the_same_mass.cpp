// expect: speeds u and v move the same mass in any configuration: the mass matrix is numerically singular
#include "pendulum.hpp"

struct R : offset<R, O, q * N::x + s * N::x> {};
struct Ball : particle<Ball, R, m> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Ball>> {};

int main() { use<System>(); }
