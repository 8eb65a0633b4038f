// expect: loads<...> lists Bob, which is a body; list it in bodies<...>
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>, loads<Bob>> {
};

int main() { use<System>(); }
