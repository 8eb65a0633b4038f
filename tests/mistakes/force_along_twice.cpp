// expect: the force between P and Edge is listed twice
#include "pendulum.hpp"

struct Edge : offset<Edge, O, l * N::y> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_along<straight<P, Edge>, T>, force_along<straight<P, Edge>, T>>> {};

int main() { use<System>(); }
