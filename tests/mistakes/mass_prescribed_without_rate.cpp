// expect: the mass of Ball contains the input theta, whose rate is not known
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct Ball : particle<Ball, P, m * theta> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Ball>,
                            inputs<theta>> {};

int main() { use<System>(); }
