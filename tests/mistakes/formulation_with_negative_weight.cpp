// expect: weighted_by<...> gives an operation a negative weight
#include "pendulum.hpp"

struct System : bound_pendulum<formulation<weighted_by<operation_weights{.division = -4}>>> {};

int main() { use<System>(); }
