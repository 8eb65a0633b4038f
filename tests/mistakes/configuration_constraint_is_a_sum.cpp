// expect: configuration constraint 3 follows from the preceding ones in every configuration
#include "pendulum.hpp"

constexpr coordinate<"z"> z;
constexpr speed<"w"> w;

struct System
    : kane_system<inertial<N>, coordinates<q, s, z>, speeds<u, v, w>,
                  kinematics<dot(q) == u, dot(s) == v, dot(z) == w>, bodies<Bob, Block>,
                  configuration_constraints<s == l * sin(q), z == s * s, s + z == s * s + l * sin(q)>> {};

int main() { use<System>(); }
