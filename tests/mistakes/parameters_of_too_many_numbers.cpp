// expect: the parameter vector of System has 2 entries, not 3
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  parameter_values<System> p{1, 2, 9.81};
  return p(0) > 0;
}
