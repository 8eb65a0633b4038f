// expect: an acceleration constraint contains the second derivative of coordinate s; write it in terms of the
// expect: rates of the speeds
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<v == 0>, acceleration_constraints<dot(dot(s)) == 0>> {};

int main() { use<System>(); }
