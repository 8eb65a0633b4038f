// expect: the angle of the torsional spring with k contains no coordinate; pass the angle first, then the
// expect: stiffness
#include "pendulum.hpp"

constexpr parameter<"k"> k;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torsional_spring<k, q>>> {};

int main() { use<System>(); }
