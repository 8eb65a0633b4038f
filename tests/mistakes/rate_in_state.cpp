// expect: the state of System does not contain the rate of coordinate q
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};
using eom = equations_of_motion<System>;

int main() {
  eom::state x;
  x[dot(q)] = 1;
}
