// expect: the system System has kinematics<...>; a lagrange_system has no speeds but the rates of its
// coordinates
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, kinematics<dot(q) == u>> {};

int main() { use_rates<System>(); }
