// expect: the system System has no speed u
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>> {};
using eom = equations_of_motion<System>;

int main() {
  eom::state x;
  x[u] = 1;
}
