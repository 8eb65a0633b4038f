// expect: the list of inputs contains theta', a derivative of a prescribed quantity, without theta
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            inputs<dot(theta)>, loads<force<P, dot(theta) * N::x>>> {};

int main() { use<System>(); }
