// expect: two inputs are called th
#include "pendulum.hpp"

constexpr prescribed<"th"> th;
constexpr input<"th"> other;
struct B : rotated<B, A, th, A::z> {};
struct Q : offset<Q, P, l * B::x> {};
struct Bead : particle<Bead, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bead>,
                            loads<torque<A, other * N::z>>> {};

int main() { use<System>(); }
