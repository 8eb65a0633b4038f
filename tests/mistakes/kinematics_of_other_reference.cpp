// expect: kinematics_of<C, N> is not available: the angular velocity of frame C is declared relative to A
#include "pendulum.hpp"

struct C : rotated<C, A, s, A::z>, angular_velocity<A, v * own::z> {};
struct Q : offset<Q, P, l * C::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, kinematics_of<C, N>>, bodies<Ball>> {};

int main() { use<System>(); }
