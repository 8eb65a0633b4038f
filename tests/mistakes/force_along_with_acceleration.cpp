// expect: the force between P and Edge contains the rate of speed u
#include "pendulum.hpp"

struct Edge : offset<Edge, O, l * N::y> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_along<straight<P, Edge>, dot(acceleration_of<P>, N::x)>>> {};

int main() { use<System>(); }
