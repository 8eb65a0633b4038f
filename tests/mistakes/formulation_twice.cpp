// expect: the system System lists formulation<...> twice; write one list
#include "pendulum.hpp"

struct System : bound_pendulum<formulation<written_in<A, A>>, formulation<by_elimination>> {};

int main() { use<System>(); }
