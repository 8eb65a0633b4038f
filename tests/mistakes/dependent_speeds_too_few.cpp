// expect: 1 dependent speed for 2 constraints on the velocities; the numbers must be equal
#include "pendulum.hpp"

constexpr coordinate<"z"> z;
constexpr speed<"w"> w;

struct System : kane_system<inertial<N>, coordinates<q, s, z>, speeds<u, v, w>,
                            kinematics<dot(q) == u, dot(s) == v, dot(z) == w>, bodies<Bob, Block>,
                            velocity_constraints<u == v, v == w>, dependent<u>> {};

int main() { use<System>(); }
