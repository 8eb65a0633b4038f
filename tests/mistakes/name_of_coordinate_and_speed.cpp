// expect: the name q is used twice: among the coordinates and among the speeds
#include "pendulum.hpp"

constexpr speed<"q"> q_rate;

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<q_rate>, kinematics<dot(q) == q_rate>, bodies<Bob>> {};

int main() { use<System>(); }
