// expect: a force on P is given along the axes of B and depends on the omitted angle of B
#include "pendulum.hpp"

struct B : rotated<B, A, 0, A::z>, angular_velocity<A, v * A::z> {};
struct Wheel : rigid_body<Wheel, P, B, m, inertia<B, 1, 1, 2>> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u, v>, kinematics<dot(q) == u>, bodies<Wheel>,
                            loads<force<P, m * g * B::x>>> {};

int main() { use<System>(); }
