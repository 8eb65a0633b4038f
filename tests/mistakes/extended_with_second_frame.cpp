// expect: inertial<...> takes one frame
#include "pendulum.hpp"

struct System : extended<pendulum_with<Bob>, inertial<A>> {};

int main() { use<System>(); }
