// expect: the surface of the force between P and Edge has no positive radius
#include "pendulum.hpp"

struct Edge : offset<Edge, O, l * N::x> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_along<around_sphere<O, -0.1, P, Edge>, T>>> {};

int main() { use<System>(); }
