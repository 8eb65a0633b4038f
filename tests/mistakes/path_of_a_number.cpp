// expect: the force acts along N, which is a frame, not a pathway; write straight<P, Q>, for example
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_along<N, T>>> {};

int main() { use<System>(); }
