// expect: forcing of Rod is given the parameters of Rod in place of its state
#include "pendulum.hpp"

// one coordinate, one speed and two parameters: both vectors have two entries
struct Tip : offset<Tip, O, l * A::x> {};
struct Mass : particle<Mass, Tip, m> {};
struct Rod : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Mass>> {};
using eom = equations_of_motion<Rod>;

int main() {
  eom::state x;
  eom::parameters p(1, 2);
  return eom::forcing(p, x) > 0;
}
