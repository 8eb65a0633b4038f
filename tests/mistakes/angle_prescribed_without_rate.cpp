// expect: the angle of frame D contains the input theta, whose rate is not known
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct D : rotated<D, N, theta, N::z> {};
struct Q : offset<Q, P, l * D::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Ball>,
                            inputs<theta>> {};

int main() { use<System>(); }
