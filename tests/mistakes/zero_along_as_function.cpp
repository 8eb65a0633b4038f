// expect: an expression is a constraint; it must be an expression
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() {
  kanexpr::function<System, zero_along<velocity_of<P>, N::x>> nothing;
  static_cast<void>(nothing(equations_of_motion<System>::state(), equations_of_motion<System>::parameters()));
}
