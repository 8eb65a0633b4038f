// expect: the cubic stiffness of the cubic spring between P and Edge contains the coordinate q; it may
// expect: contain only parameters, inputs and time
#include "pendulum.hpp"

struct Edge : offset<Edge, O, l * N::y> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<cubic_spring<straight<P, Edge>, 3, q>>> {};

int main() { use<System>(); }
