// expect: the linear spring between P and Edge lacks an argument; write linear_spring<Path, stiffness,
// expect: natural length>
#include "pendulum.hpp"

struct Edge : offset<Edge, O, l * N::y> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<linear_spring<straight<P, Edge>>>> {};

int main() { use<System>(); }
