// expect: angular_velocity<...> is a base class of Q, which is not a frame
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, angular_velocity<N, u * N::z> {};
struct Bead : particle<Bead, Q, m> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
