// expect: the Coriolis matrix requires a mass matrix that depends only on coordinates; this one depends on
// expect: time
#include "pendulum.hpp"

struct Rope : offset<Rope, O, (l - t) * A::x> {};
struct Load : particle<Load, Rope, m> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Load>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(0, eom::state(), eom::parameters()); }
