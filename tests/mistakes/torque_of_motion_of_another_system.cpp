// expect: frame M, which the torque on A uses, is not connected to the inertial frame N
#include "pendulum.hpp"

struct M : inertial_frame<M> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torque<A, -m * angular_velocity_of<M>>>> {};

int main() { use<System>(); }
