// expect: the pathway of the linear spring lacks an argument; write through<Point, Via, ..., Other>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<linear_spring<through<O, P>, 3>>> {};

int main() { use<System>(); }
