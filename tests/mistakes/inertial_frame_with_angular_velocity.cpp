// expect: the inertial frame G has a declared angular velocity
#include "pendulum.hpp"

struct G : inertial_frame<G>, angular_velocity<G, u * own::z> {};
struct B : rotated<B, G, q, G::z> {};
struct C : origin<C, G> {};
struct Q : offset<Q, C, l * B::x> {};
struct Bead : particle<Bead, Q, m> {};

struct System : kane_system<inertial<G>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bead>> {};

int main() { use<System>(); }
