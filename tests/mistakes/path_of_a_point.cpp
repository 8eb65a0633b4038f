// expect: the linear spring acts along P, which is a point, not a pathway; write straight<P, Q>, for example
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<linear_spring<P, 3>>> {};

int main() { use<System>(); }
