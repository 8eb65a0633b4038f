// expect: the constraints cannot be solved for the dependent speeds u and v in any configuration
#include "pendulum.hpp"

constexpr coordinate<"z"> z;
constexpr speed<"w"> w;

struct System : kane_system<inertial<N>, coordinates<q, s, z>, speeds<u, v, w>,
                            kinematics<dot(q) == u, dot(s) == v, dot(z) == w>, bodies<Bob, Block>,
                            velocity_constraints<u + v == w, l * u + l * v == 2 * w>, dependent<u, v>> {};

int main() { use<System>(); }
