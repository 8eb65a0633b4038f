// expect: gravity is listed twice
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<-g * N::y>, gravity<-g * N::y>>> {};

int main() { use<System>(); }
