// expect: the configuration constraints cannot be solved for the dependent coordinates q and s in any
// expect: configuration
#include "pendulum.hpp"

constexpr coordinate<"z"> z;
constexpr speed<"w"> w;

struct System : kane_system<inertial<N>, coordinates<q, s, z>, speeds<u, v, w>,
                            kinematics<dot(q) == u, dot(s) == v, dot(z) == w>, bodies<Bob, Block>,
                            configuration_constraints<q + s == z, sin(q + s) == 2 * z>, dependent<q, s>> {};

int main() { use<System>(); }
