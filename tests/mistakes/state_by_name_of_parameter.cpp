// expect: m is not an entry of the state vector of System
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  state<System> x{{q, 0.1}, {m, 2}};
  return x(0) > 0;
}
