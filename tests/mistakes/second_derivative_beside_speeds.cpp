// expect: an acceleration constraint holds the second derivative of coordinate s; write it by the rates of
// the speeds
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<v == 0>, acceleration_constraints<dot(dot(s)) == 0>> {};

int main() { use<System>(); }
