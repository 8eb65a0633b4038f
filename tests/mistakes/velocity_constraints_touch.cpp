// expect: wherever the constraints on the velocities hold, the derivatives of velocity constraint 2 with
// expect: respect to the speeds are a combination of those of the preceding ones
#include "pendulum.hpp"

constexpr coordinate<"r"> r;
constexpr speed<"w"> w;
struct R : offset<R, O, r * N::z> {};
struct Bead : particle<Bead, R, m> {};
struct System : kane_system<inertial<N>, coordinates<q, s, r>, speeds<u, v, w>,
                            kinematics<dot(q) == u, dot(s) == v, dot(r) == w>, bodies<Bob, Block, Bead>,
                            velocity_constraints<u * v == 1, u * u + v * v == 2>> {};

int main() { use<System>(); }
