// expect: parameter d is listed, but nothing in the system uses it; if this is intended, write
// expect: used_elsewhere<d>
#include "pendulum.hpp"

constexpr parameter<"d"> d; // a damper that is missing from the loads

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight>, parameters<m, l, g, d>> {};

int main() { use<System>(); }
