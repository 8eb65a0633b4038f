// expect: kinematics_of<C, A> is not available: frame C is not oriented relative to A
#include "pendulum.hpp"

struct C : rotated<C, N, s, N::z>, angular_velocity<N, v * own::z> {};
struct Q : offset<Q, P, l * C::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, kinematics_of<C, A>>, bodies<Ball>> {};

int main() { use<System>(); }
