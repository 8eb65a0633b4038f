// expect: the force between P and Edge is wrapped around an axis that is not fixed in N
#include "pendulum.hpp"

struct Edge : offset<Edge, O, l * N::x> {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                  loads<force_along<around_cylinder<N, O, A::x, 0.1, P, Edge, wrapping::clockwise>, T>>> {};

int main() { use<System>(); }
