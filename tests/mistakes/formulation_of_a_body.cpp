// expect: Bob, which formulation<...> uses as a frame, is a body
#include "pendulum.hpp"

struct System : bound_pendulum<formulation<written_in<Bob, N>>> {};

int main() { use<System>(); }
