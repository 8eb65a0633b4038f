// expect: the velocity of Body is not the rate of its position, as the Coriolis matrix requires
#include "pendulum.hpp"

struct Skate : offset<Skate, O, 0.0 * N::x>, velocity<N, v * A::x> {};
struct G : offset<G, Skate, l * A::x>, fixed_in<A> {};
struct Body : rigid_body<Body, G, A, m, inertia<A, 0, 0, 0.3>> {};
struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Body>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters()); }
