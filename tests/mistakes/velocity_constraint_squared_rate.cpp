// expect: the derivatives of velocity constraint 2 with respect to the speeds vanish wherever it holds
#include "pendulum.hpp"

constexpr coordinate<"r"> r;
constexpr speed<"w"> w;
struct R : offset<R, O, r * N::z> {};
struct Bead : particle<Bead, R, m> {};
struct System : kane_system<inertial<N>, coordinates<q, s, r>, speeds<u, v, w>,
                            kinematics<dot(q) == u, dot(s) == v, dot(r) == w>, bodies<Bob, Block, Bead>,
                            velocity_constraints<u * u + v * v == 4, (dot(r) - v) * (dot(r) - v) == 0>> {};

int main() { use<System>(); }
