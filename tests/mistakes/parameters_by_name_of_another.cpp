// expect: the system System has no parameter g
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  parameter_values<System> p;
  p = {{m, 2}, {l, 1}, {g, 9.81}};
  return p(0) > 0;
}
