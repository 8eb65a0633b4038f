// expect: the name T' contains a prime, which denotes a rate
#include "pendulum.hpp"

constexpr input<"T'"> rate;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, rate * N::z>>> {};

int main() { use<System>(); }
