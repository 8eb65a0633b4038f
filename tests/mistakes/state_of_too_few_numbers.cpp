// expect: the state vector of System has 2 entries, not 1
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  state<System> x{0.1};
  return x(0) > 0;
}
