// expect: the linear spring between P and Edge contains a velocity or derivative; it may contain only
// expect: coordinates
#include "pendulum.hpp"

struct Edge : offset<Edge, O, l * N::y> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<linear_spring<through<P, O, Edge>, 3 * magnitude(velocity_of<P>)>>> {};

int main() { use<System>(); }
