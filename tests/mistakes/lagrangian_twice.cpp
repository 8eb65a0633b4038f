// expect: the system System lists lagrangian<...> twice; write one list
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>, lagrangian<-g * q>> {};

int main() { use_rates<System>(); }
